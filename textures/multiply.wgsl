/// The product of two colors: one seen through, or stained by, the other.
///
/// a = "#e0b070": one color
/// b = "#8fb3c7": color that stains it
fn multiply(at: Surface, a: vec3f, b: vec3f) -> vec3f {
    return a * b;
}
