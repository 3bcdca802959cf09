// The tree of rays that a pixel sends, walked in a loop.

/// Follows a ray of length 1 from `origin` and all that it splits into.
fn traceTree(origin: vec3f, direction: vec3f) -> Seen {
    var seen = Seen(vec3f(0.0), -1.0, vec3f(0.0), NO_OBJECT, 0u);
    var waiting: array<Branch, MAX_WAITING>;
    var waits = 0u;
    var branch = Branch(origin, 1.0, direction, 0.0, AIR, 0u);
    for (var rays = 0u; rays < MAX_RAYS; rays++) {
        let ray = Ray(branch.origin, 0.0, branch.direction, NO_HIT);
        let hit = rayTraceScene(ray);
        let depth = branch.depth;
        seen.bounces = max(seen.bounces, depth);
        var follows = false;
        if hit.object == NO_OBJECT {
            seen.radiance += branch.weight * background(branch.direction);
        } else {
            let v = -branch.direction;
            let width = branch.width + frame.pixel_spread * hit.t;
            let seen_there = sampleFootprint(ray, hit, width);
            let p = seen_there.point;
            let met = seen_there.met;
            let material = seen_there.material;
            let inside = dot(met.geometric_normal, v) < 0.0;
            let facing = select(met.geometric_normal, -met.geometric_normal, inside);
            var n = normalAt(hit.object, met);
            n = select(n, -n, inside);
            // A bump may tilt the normal away from the viewer, who then sees the slope edge on.
            n = normalize(n + max(0.001 - dot(n, v), 0.0) * v);
            // Back along the ray, too: where walls meet, rounding may put the point behind the other one.
            let outside = spawnPoint(p, facing + v - dot(facing, v) * facing, hit.t);
            // Light falls on the smooth surface, or it would end in steps along the triangles.
            let rise = select(met.rise, 0.0, inside) * met.geometric_normal;
            let shaded = shade(p + rise, outside + rise, n, v, material);
            if depth == 0u {
                seen.depth = hit.t;
                seen.object = hit.object;
                seen.value = surfaceView(hit, met, n, v, material.color, shaded.visibility);
            }

            let mirror = mirrored(material, clamp(dot(n, v), 0.0, 1.0));
            let stays = branch.weight * (1.0 - mirror);
            seen.radiance += stays * (1.0 - material.transmission) * shaded.light;
            let deeper = depth < frame.max_bounces + zero;
            let reflection = branch.weight * mirror;
            let refraction = stays * material.transmission;
            let reflects = deeper && reflection >= MIN_WEIGHT;
            let refracts = TRANSMITS && deeper && refraction >= MIN_WEIGHT;
            let into = branch.direction;
            let media = branch.media;
            if reflects {
                var away = reflect(into, n);
                // Where light sees another surface than rays meet, a mirror may point into it.
                away = normalize(away + max(0.001 - dot(away, facing), 0.0) * facing);
                branch = Branch(outside, reflection, away, width, media, depth + 1u);
            }
            if refracts {
                let through = refracted(into, n, indexRatio(media, material.ior, inside));
                let is_mirrored = dot(through, facing) > 0.0;
                let start = spawnPoint(p, select(-facing, facing, is_mirrored), hit.t);
                let behind = select(mediaBehind(media, material.ior, inside), media, is_mirrored);
                let beyond = Branch(start, refraction, through, width, behind, depth + 1u);
                var heavier = beyond;
                if !reflects || reflection > refraction {
                    heavier = branch;
                    branch = beyond;
                }
                if reflects {
                    waiting[waits] = heavier;
                    waits++;
                }
            }
            follows = reflects || refracts;
        }
        if !follows {
            if !TRANSMITS || waits == 0u {
                break;
            }
            waits--;
            branch = waiting[waits];
        }
    }
    return seen;
}
