/// The luminance of a color: how bright it looks, whatever its hue.
///
/// of = "#c98d5e": the color
fn grey(at: Surface, of_: vec3f) -> f32 {
    // The same weights (Rec. 709) as for a color that is given where a pattern is wanted.
    return dot(of_, vec3f(0.2126, 0.7152, 0.0722));
}
