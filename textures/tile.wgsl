/// Repeats the piece of a texture around the origin, with a hard seam between the copies.
///
/// size = (2.5, 2.5, 2.5), 0 to 100: size of the piece, in scene units, 0 for no end; uv takes the first two
fn tile(at: Surface, size: vec3f) -> Surface {
    var moved = at;
    // Asked just under the surface, a face that lies between two pieces is not torn between them.
    moved.position = tileCell(at.position, at.position - 1e-3 * size * at.normal, size, at.footprint);
    let flat = vec3f(at.uv, 0.0);
    moved.uv = tileCell(flat, flat, size, at.density * at.footprint).xy;
    return moved;
}

/// `p` inside the cell around `inner`.
fn tileCell(p: vec3f, inner: vec3f, size: vec3f, width: f32) -> vec3f {
    let period = max(size, vec3f(1e-3));
    let local = p - period * round(inner / period);
    // The pixel stays inside the cell: beyond the seam lies what is not shown. One as wide as a cell
    // sees its middle, and does not flicker.
    let room = max(0.5 * (period - width), vec3f(0.0));
    return select(clamp(local, -room, room), p, size <= vec3f(0.0));
}
