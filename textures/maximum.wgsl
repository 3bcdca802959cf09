/// The brighter of two colors, in red, green and blue apart.
///
/// a = "#8f3f2c": one color
/// b = "#2c4f8f": the other
fn maximum(at: Surface, a: vec3f, b: vec3f) -> vec3f {
    return max(a, b);
}
