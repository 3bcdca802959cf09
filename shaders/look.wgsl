// What a pixel sees of a surface: the material, as a mean over the pixel's footprint.

/// The most looks that a pixel takes at one surface.
const MOST_LOOKS: u32 = 9u;

/// A surface and its material as a pixel sees them.
struct Looked {
    /// In world space.
    point: vec3f,
    met: Placed,
    material: Material,
}

/// What `ray` meets at `hit`, where it is `width` wide. Seen at a slant the footprint is long: several looks
/// along it, each about square, do not blur across it.
fn looked(ray: Ray, hit: Hit, width: f32) -> Looked {
    var seen: Looked;
    seen.point = rayPoint(ray, hit.t);
    var corrected = false;
    var footprint = 0.0;
    var step = vec3f(0.0);
    var looks = 1u;
    var look = 0u;
    while look < looks {
        // 0, 1, -1, 2, -2, …
        let place = f32((look + 1u) / 2u) * select(-1.0, 1.0, (look & 1u) == 1u);
        let there = surfaceAt(hit.object, seen.point + place * step);
        if !corrected {
            corrected = true;
            let slip = slipAlong(ray, hit.t, there);
            if length(slip) > MOST_SLIP * length(seen.point) {
                seen.point += slip;
                continue;
            }
        }
        if look == 0u {
            seen.met = there;
            let cosine = max(abs(dot(there.normal, ray.direction)), 0.02);
            let along = ray.direction - dot(ray.direction, there.normal) * there.normal;
            let wanted = 2u * u32(0.5 / cosine) + 1u;
            let varies = width > 0.0 && isTextured(hit.object);
            looks = select(1u, min(wanted, MOST_LOOKS), varies) + zero;
            step = along / max(length(along), 1e-6) * width / (cosine * f32(looks));
            footprint = max(width, width / (cosine * f32(looks))) * there.scale;
            seen.met.at.footprint = width * there.scale / cosine;
        }
        var at = there.at;
        at.footprint = footprint;
        seen.material = summed(seen.material, materialAt(hit.object, at));
        look++;
    }
    seen.material = meanOf(seen.material, 1.0 / f32(looks));
    return seen;
}
