/// A color whose red, green and blue are rounded to a few even steps, as on a poster; clamped to 0 to 1.
///
/// of = "#c98d5e": the color
/// steps = 4, 2 to 64: how many values red, green and blue may take
fn quantize(at: Surface, of_: vec3f, steps: u32) -> vec3f {
    let top = f32(max(steps, 2u) - 1u);
    return round(clamp(of_, vec3f(0.0), vec3f(1.0)) * top) / top;
}
