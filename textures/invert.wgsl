/// The negative of a color, white for black; clamped to 0 to 1.
///
/// of = "#d9a05c": the color
fn invert(at: Surface, of_: vec3f) -> vec3f {
    return 1.0 - clamp(of_, vec3f(0.0), vec3f(1.0));
}
