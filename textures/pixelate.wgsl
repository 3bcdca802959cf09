/// Cuts a texture into little cubes, or its uv into squares, of one color each.
///
/// size = 0.1, 0.001 to 10: edge of a cube, in scene units
fn pixelate(at: Surface, size: f32) -> Surface {
    let edge = max(size, 1e-4);
    // Cubes that a pixel cannot show would only make it flicker.
    let share = 1.0 - smoothstep(0.5, 1.5, at.footprint / edge);
    // Asked just under the surface, a face that lies between two cubes is not torn between them.
    let inner = at.position - 0.013 * edge * at.normal;
    var moved = at;
    moved.position = mix(at.position, (floor(inner / edge) + 0.5) * edge, share);
    moved.uv = mix(at.uv, (floor(at.uv / edge) + 0.5) * edge, share);
    return moved;
}
