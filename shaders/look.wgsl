// What a pixel sees of a surface: the material, as a mean over the pixel's footprint.

/// The most looks that a pixel takes at one surface.
const MOST_LOOKS: u32 = 9u;

/// A surface and its material as a pixel sees them.
struct Looked {
    met: Placed,
    material: Material,
}

/// `object` at the world point `p`, where a ray `width` wide arrives along `direction`. Seen at a slant the
/// footprint is long: several looks along it, each about square, do not blur across it.
fn looked(object: u32, p: vec3f, direction: vec3f, width: f32) -> Looked {
    var seen: Looked;
    var looks = 1u;
    var footprint = 0.0;
    var step = vec3f(0.0);
    for (var i = 0u; i < looks; i++) {
        // 0, 1, -1, 2, -2, …
        let place = f32((i + 1u) / 2u) * select(-1.0, 1.0, (i & 1u) == 1u);
        let there = surfaceAt(object, p + place * step);
        if i == 0u {
            seen.met = there;
            let cosine = max(abs(dot(there.normal, direction)), 0.02);
            let along = direction - dot(direction, there.normal) * there.normal;
            let wanted = 2u * u32(0.5 / cosine) + 1u;
            looks = select(1u, min(wanted, MOST_LOOKS), TEXTURED && width > 0.0) + zero;
            step = along / max(length(along), 1e-6) * width / (cosine * f32(looks));
            footprint = max(width, width / (cosine * f32(looks))) * there.scale;
            seen.met.at.footprint = width * there.scale / cosine;
        }
        var at = there.at;
        at.footprint = footprint;
        seen.material = summed(seen.material, materialAt(object, at));
    }
    seen.material = meanOf(seen.material, 1.0 / f32(looks));
    return seen;
}
