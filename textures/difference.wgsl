/// How far two colors lie apart, in red, green and blue apart: black where they are one.
///
/// a = "#e8c07a": one color
/// b = "#3f6f8f": the other
fn difference(at: Surface, a: vec3f, b: vec3f) -> vec3f {
    return abs(a - b);
}
