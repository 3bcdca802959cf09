/// A color or a pattern raised to a power, darker or brighter between black and white; never below 0.
///
/// of = "#b0855f": the color
/// power = 2, 0.1 to 10: above 1 it darkens, below 1 it brightens
fn gamma(at: Surface, of_: vec3f, power: f32) -> vec3f {
    // By logarithms, and within the range of f32: pow is only sure of a positive base.
    let raised = exp2(clamp(power * log2(max(of_, vec3f(1e-30))), vec3f(-126.0), vec3f(126.0)));
    return select(raised, vec3f(0.0), of_ <= vec3f(0.0));
}
