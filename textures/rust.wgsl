/// Rust that eats through paint in ragged blotches and stains it around them.
///
/// scale = 1, 0.01 to 100: blotches per scene unit
/// amount = 0.4, 0.01 to 0.99: share of the paint that is gone
/// roughness = 0.6, 0 to 1: how ragged the edges are
/// stain = 0.5, 0 to 1: how much the paint near a blotch has browned
/// paint = "#5f8379": color of the paint, or of bare steel
/// fresh = "#a9592b": color of young rust
/// old = "#4c2a1d": color of deep rust
fn rust(
    at: Surface, scale: f32, amount: f32, roughness: f32, stain: f32,
    paint: vec3f, fresh: vec3f, old: vec3f,
) -> vec3f {
    var q = at.position * scale;
    var width = at.footprint * scale;
    // An octave counts by its deviation, 0.4 for the first, so that variances can be summed.
    var amplitude = 0.4;
    var field = vec2f(0.0);
    var whole = 0.0;
    var lost = 0.0;
    for (var i = 0u; i < 6u; i++) {
        q = OCTAVE_TURN * q + OCTAVE_SHIFT;
        let seen = exp(-0.35 * width * width);
        field += 2.5 * amplitude * seen * vectorNoise(q).xy;
        whole += amplitude * amplitude;
        lost += amplitude * amplitude * (1.0 - seen * seen);
        amplitude *= roughness;
        width *= 2.0;
        q *= 2.0;
    }
    // The level that a given share of the noise exceeds, were it normal (its quantile, by the logistic).
    let above = field.x - 0.55 * sqrt(whole) * log(1.0 / clamp(amount, 0.01, 0.99) - 1.0);
    // What the footprint hides of the noise is chance: it softens an edge by its deviation. The variances
    // of an edge's own softness and of that chance add up.
    let soft = sqrt(5.0 * (lost + vec3f(1e-6, 0.02, 0.03)));
    let share = smoothstep(-soft, soft, vec3f(above, above + 0.25, field.y - 0.1));
    let rusted = mix(fresh, old, share.z);
    // A sum, not a mix in a mix: the shares are not independent, and only sums can be averaged apart.
    return paint + (rusted - paint) * (share.x + stain * max(share.y - share.x, 0.0));
}
