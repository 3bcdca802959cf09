/// The darker of two colors, in red, green and blue apart.
///
/// a = "#d98f5c": one color
/// b = "#5c9fd9": the other
fn minimum(at: Surface, a: vec3f, b: vec3f) -> vec3f {
    return min(a, b);
}
