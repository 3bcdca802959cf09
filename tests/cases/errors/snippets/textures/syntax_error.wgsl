/// A texture whose author forgot how to end a line.
///
/// scale = 4, 0.01 to 1000: cells per scene unit
fn syntaxError(at: Surface, scale: f32) -> vec3f {
    let cell = floor(at.uv * scale)
    return vec3f(cell, 0.0);
}
