/// Throws flat patterns onto an object from the six sides of a cube, each where the surface faces it.
fn cubic(at: Surface) -> Surface {
    let n = abs(at.normal);
    let p = at.position;
    let side = select(p.xy, p.zy, n.x > n.z);
    var moved = at;
    // As on planes: (x, z) along y, (z, y) along x, (x, y) along z.
    moved.uv = select(side, p.xz, n.y >= max(n.x, n.z));
    moved.whole = vec4f(0.0);
    moved.density = 1.0;
    return moved;
}
