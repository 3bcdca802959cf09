/// Throws flat patterns onto an object from one side, like a slide projector.
///
/// axis = y of x, y, z: where it stands; as on a plane, uv = (z, y) along x, (x, z) along y, (x, y) along z
fn planar(at: Surface, axis: u32) -> Surface {
    let p = at.position;
    var moved = at;
    moved.uv = select(select(p.xy, p.xz, axis == 1u), p.zy, axis == 0u);
    moved.whole = vec4f(0.0);
    moved.density = 1.0;
    return moved;
}
