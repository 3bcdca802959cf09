/// A texture whose function is called something else.
fn another(at: Surface) -> f32 {
    return at.uv.x;
}
