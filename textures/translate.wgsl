/// Moves a texture along.
///
/// offset = (0.5, 0.25, 0), -10 to 10: how far it goes, in scene units; uv goes by the first two
fn translate(at: Surface, offset: vec3f) -> Surface {
    var moved = at;
    moved.position -= offset;
    moved.uv -= offset.xy;
    return moved;
}
