/// The sum of two colors, as of two lights; it may be brighter than white.
///
/// a = "#7a4a2c": one color
/// b = "#2c5f7a": color added to it
/// gives 0 to 2
fn add(at: Surface, a: vec3f, b: vec3f) -> vec3f {
    return a + b;
}
