/// A texture that multiplies a whole number by a vector.
///
/// count = 4, 1 to 9: how many
fn mixedTypes(at: Surface, count: u32) -> vec3f {
    return vec3f(at.uv, 0.0) * count;
}
