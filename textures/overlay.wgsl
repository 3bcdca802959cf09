/// A color whose darks another darkens and whose lights it brightens; both are clamped to 0 to 1.
///
/// a = "#c08a5a": color below, black and white stay as they are
/// b = "#6fa3c0": color over it, linear grey 0.5 changes nothing
fn overlay(at: Surface, a: vec3f, b: vec3f) -> vec3f {
    let below = clamp(a, vec3f(0.0), vec3f(1.0));
    let above = clamp(b, vec3f(0.0), vec3f(1.0));
    let dark = 2.0 * below * above;
    let light = 1.0 - 2.0 * (1.0 - below) * (1.0 - above);
    return select(light, dark, below < vec3f(0.5));
}
