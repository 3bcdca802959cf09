/// Moves a texture over its surface.
///
/// by = (0, 0): how far, scene units of uv
fn shift(at: Surface, by: vec2f) -> Surface {
    var moved = at;
    moved.uv -= by;
    return moved;
}
