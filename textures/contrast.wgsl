/// A color drawn away from a middle grey, or towards it; clamped to 0 to 1.
///
/// of = "#b98a62": the color
/// amount = 1.5, 0 to 10: 0 leaves the grey alone, 1 the color as it is
/// middle = 0.25, 0 to 1: the grey that stays, in linear light
fn contrast(at: Surface, of_: vec3f, amount: f32, middle: f32) -> vec3f {
    return clamp(middle + amount * (of_ - middle), vec3f(0.0), vec3f(1.0));
}
