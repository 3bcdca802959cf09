// The material that a pixel sees: a mean over its footprint on the surface (anisotropic filtering).

/// The most samples that a pixel takes of one surface.
const MAX_FOOTPRINT_SAMPLES: u32 = 9u;

/// A surface and its material, as a mean over the footprint of a pixel.
struct SampledSurface {
    /// In world space.
    point: vec3f,
    met: Placed,
    material: Material,
}

/// The surface that `ray` meets at `hit`, where it is `width` wide. Seen at a slant the footprint is long:
/// several samples along it, each about square, do not blur across it.
fn sampleFootprint(ray: Ray, hit: Hit, width: f32) -> SampledSurface {
    var seen: SampledSurface;
    seen.point = rayPoint(ray, hit.t);
    var corrected = false;
    var footprint = 0.0;
    var step = vec3f(0.0);
    var count = 1u;
    var index = 0u;
    while index < count {
        // 0, 1, -1, 2, -2, …
        let place = f32((index + 1u) / 2u) * select(-1.0, 1.0, (index & 1u) == 1u);
        let there = surfaceAt(hit.object, seen.point + place * step);
        if !corrected {
            corrected = true;
            let slip = slipAlong(ray, hit.t, there);
            if length(slip) > MAX_SLIP * length(seen.point) {
                seen.point += slip;
                continue;
            }
        }
        if index == 0u {
            seen.met = there;
            let cosine = max(abs(dot(there.normal, ray.direction)), 0.02);
            let along = ray.direction - dot(ray.direction, there.normal) * there.normal;
            let wanted = 2u * u32(0.5 / cosine) + 1u;
            let varies = width > 0.0 && isTextured(hit.object);
            count = select(1u, min(wanted, MAX_FOOTPRINT_SAMPLES), varies) + zero;
            step = along / max(length(along), 1e-6) * width / (cosine * f32(count));
            footprint = max(width, width / (cosine * f32(count))) * there.scale;
            seen.met.at.footprint = width * there.scale / cosine;
        }
        var at = there.at;
        at.footprint = footprint;
        seen.material = summed(seen.material, materialAt(hit.object, at));
        index++;
    }
    seen.material = meanOf(seen.material, 1.0 / f32(count));
    return seen;
}
