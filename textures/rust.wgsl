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
    let noise = vectorOctaves(at.position * scale, 6u, vec3f(roughness), at.footprint * scale);
    // The level that a given share of the noise exceeds, were it normal (its quantile, by the logistic).
    let above = noise.field.x - 0.55 * sqrt(noise.whole.x) * log(1.0 / clamp(amount, 0.01, 0.99) - 1.0);
    // What the footprint hides of the noise is chance: it softens an edge by its deviation. The variances
    // of an edge's own softness and of that chance add up.
    let soft = sqrt(5.0 * (noise.lost + vec3f(1e-6, 0.02, 0.03)));
    let share = smoothstep(-soft, soft, vec3f(above, above + 0.25, noise.field.y - 0.1));
    let rusted = mix(fresh, old, share.z);
    // A sum, not a mix in a mix: the shares are not independent, and only sums can be averaged apart.
    return paint + (rusted - paint) * (share.x + stain * max(share.y - share.x, 0.0));
}
