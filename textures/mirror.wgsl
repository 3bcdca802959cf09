/// Repeats the piece of a texture around the origin, every other copy mirrored, so that no seam shows.
///
/// size = (2.5, 2.5, 2.5), 0 to 100: size of the piece, in scene units, 0 for no end; uv takes the first two
fn mirror(at: Surface, size: vec3f) -> Surface {
    let phase = mirrorPhase(at.position, size);
    let flat = mirrorPhase(vec3f(at.uv, 0.0), size);
    let endless = size <= vec3f(0.0);
    // The pixel stays inside the piece: beyond the seam lies what is not shown. One as wide as a piece
    // sees its middle, and does not flicker.
    let room = max(0.5 * (size - at.footprint), vec3f(0.0));
    var moved = at;
    moved.position = select(clamp((abs(phase) - 0.5) * size, -room, room), at.position, endless);
    moved.normal = select(at.normal, -at.normal, (phase < vec3f(0.0)) & !endless);
    moved.uv = select(clamp((abs(flat) - 0.5) * size, -room, room).xy, at.uv, endless.xy);
    return moved;
}

/// -1 to 1 over a copy and its mirror image, in which it is negative.
fn mirrorPhase(p: vec3f, size: vec3f) -> vec3f {
    let x = p / max(size, vec3f(1e-3)) + 0.5;
    return x - 2.0 * round(0.5 * x);
}
