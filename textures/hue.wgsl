/// A color turned around the color circle, its luminance kept; none of red, green and blue falls below 0.
///
/// of = "#c49a78": the color
/// turn_deg = 120, -180 to 180: the turn; red goes towards green
/// saturation = 1, 0 to 4: strength of the color; 0 leaves a grey
/// brightness = 1, 0 to 4: factor of its luminance
/// gives 0 to 19.27
fn hue(at: Surface, of_: vec3f, turn_deg: f32, saturation: f32, brightness: f32) -> vec3f {
    // A rotation about the axis of greys, then a shear that brings the luminance back (Haeberli, Matrix
    // Operations for Image Processing, 1993).
    let turns = turn_deg / 360.0;
    let angle = (turns - round(turns)) * 6.2831853;
    let mean = dot(of_, vec3f(0.3333333));
    let spoke = of_ - mean;
    let across = (of_.zxy - of_.yzx) * 0.5773503;
    let turned = spoke * cos(angle) + across * sin(angle);
    let weights = vec3f(0.2126, 0.7152, 0.0722);
    let chroma = turned - dot(turned, weights);
    return max(brightness * (dot(of_, weights) + saturation * chroma), vec3f(0.0));
}
