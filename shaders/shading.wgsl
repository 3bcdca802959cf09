// Light at a surface: Blinn-Phong from each light that the surface sees.

/// A branch of the ray tree that would add less than this share of the picture is cut.
const MIN_WEIGHT: f32 = 1.0 / 512.0;

/// Offset of new rays from the surface, as a share of the numbers that were added up to find it.
const SPAWN_ERROR: f32 = 1e-5;

/// Different in each pixel and each sample of it.
var<private> seed: u32;

/// What a surface sends towards a viewer, mirrors and glass aside.
struct Shade {
    light: vec3f,
    /// Unblocked share of the lights that the surface faces, 0 to 1.
    visibility: f32,
}

/// An integer hash (PCG; Jarzynski and Olano, Hash Functions for GPU Rendering, 2020).
fn hashed(x: u32) -> u32 {
    let state = x * 747796405u + 2891336453u;
    let word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

/// A point off the surface on the side that `normal` shows, so that a ray from it does not meet it again.
fn spawnPoint(p: vec3f, normal: vec3f, t: f32) -> vec3f {
    let size = max(max(abs(p.x), abs(p.y)), max(abs(p.z), t));
    return p + SPAWN_ERROR * size * normal;
}

/// The light that `material` at world point `p` sends along `v`. `n` faces the viewer.
fn shade(p: vec3f, origin: vec3f, n: vec3f, v: vec3f, material: Material) -> Shade {
    var sum = material.emission + ambientLight() * material.color;
    var visible = 0.0;
    var facing = 0.0;
    for (var i = 0u; i < LIGHTS; i++) {
        let light = lightAt(i, p);
        let l = normalize(light.to);
        let cosine = dot(n, l);
        if cosine > 0.0 && max(max(light.arriving.x, light.arriving.y), light.arriving.z) > 0.0 {
            let share = visibleShare(light, origin);
            let h = normalize(l + v);
            let highlight = material.specular * pow(max(dot(n, h), 0.0), material.shininess);
            sum += share * light.arriving * (material.color * cosine + highlight);
            visible += share;
            facing += 1.0;
        }
    }
    return Shade(sum, visible / max(facing, 1.0));
}
