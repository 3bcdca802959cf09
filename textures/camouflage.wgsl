/// Camouflage: ragged blots of three colors laid one over another on a ground.
///
/// scale = 1.2, 0.01 to 100: blots per scene unit
/// roughness = 0.4, 0 to 1: how ragged the edges are
/// cover = 0.4, 0.02 to 0.98: how much of what lies below each color hides
/// ground = "#a79b73": color at the bottom
/// first = "#5f6b3f": color over it
/// second = "#5b4533": color over both
/// third = "#262722": color on top, half as common
fn camouflage(
    at: Surface, scale: f32, roughness: f32, cover: f32,
    ground: vec3f, first: vec3f, second: vec3f, third: vec3f,
) -> vec3f {
    let noise = vectorOctaves(at.position * scale, 4u, vec3f(roughness), at.footprint * scale);
    // The level that a given share of the noise exceeds, were it normal (its quantile, by the logistic).
    let odds = 1.0 / (clamp(cover, 0.02, 0.98) * vec3f(1.0, 1.0, 0.5)) - 1.0;
    let level = 0.55 * sqrt(noise.whole) * log(odds);
    // What the footprint hides of the noise is chance: it softens the edge by its deviation.
    let soft = sqrt(5.0 * noise.lost) + 1e-6;
    let share = smoothstep(-soft, soft, noise.field - level);
    return mix(mix(mix(ground, first, share.x), second, share.y), third, share.z);
}
