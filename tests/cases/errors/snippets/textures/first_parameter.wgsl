/// A texture that does not ask for the point.
fn firstParameter(uv: vec2f) -> f32 {
    return uv.x;
}
