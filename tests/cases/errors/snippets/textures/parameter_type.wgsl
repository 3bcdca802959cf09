/// A texture with a parameter of a type that no scene can give.
///
/// turn: a matrix
fn parameterType(at: Surface, turn: mat3x3f) -> f32 {
    return (turn * at.position).x;
}
