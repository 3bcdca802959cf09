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
    var q = at.position * scale;
    var width = at.footprint * scale;
    // An octave counts by its deviation, 0.4 for the first, so that variances can be summed.
    var amplitude = 0.4;
    var field = vec3f(0.0);
    var whole = 0.0;
    var lost = 0.0;
    for (var i = 0u; i < 4u; i++) {
        q = OCTAVE_TURN * q + OCTAVE_SHIFT;
        let blur = 0.35 * width * width;
        let seen = exp(-blur);
        field += 2.5 * amplitude * seen * vectorNoise(q);
        whole += amplitude * amplitude;
        // For next to no width, 1 - seen² is the rounding of the exponential, and its root would show.
        let hidden = select(1.0 - seen * seen, 2.0 * blur * (1.0 - blur), blur < 1e-3);
        lost += amplitude * amplitude * hidden;
        amplitude *= roughness;
        width *= 2.0;
        q *= 2.0;
    }
    // The level that a given share of the noise exceeds, were it normal (its quantile, by the logistic).
    let odds = 1.0 / (clamp(cover, 0.02, 0.98) * vec3f(1.0, 1.0, 0.5)) - 1.0;
    let level = 0.55 * sqrt(whole) * log(odds);
    // What the footprint hides of the noise is chance: it softens the edge by its deviation.
    let soft = sqrt(5.0 * lost) + 1e-6;
    let share = smoothstep(vec3f(-soft), vec3f(soft), field - level);
    return mix(mix(mix(ground, first, share.x), second, share.y), third, share.z);
}
