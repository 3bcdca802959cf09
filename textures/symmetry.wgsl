/// Mirrors one half of a texture onto the other, like a butterfly's wings.
///
/// mirror_x = true: what lies at x < 0, or u < 0, is the mirror image of the other side
/// mirror_y = false: likewise for y, and v
/// mirror_z = false: likewise for z
fn symmetry(at: Surface, mirror_x: bool, mirror_y: bool, mirror_z: bool) -> Surface {
    let folded = vec3<bool>(mirror_x, mirror_y, mirror_z);
    // The pixel stays on its side of the mirror: behind it lies what is not shown.
    let room = 0.5 * at.footprint;
    var moved = at;
    moved.position = select(at.position, max(abs(at.position), vec3f(room)), folded);
    moved.normal = select(at.normal, -at.normal, folded & (at.position < vec3f(0.0)));
    moved.uv = select(at.uv, max(abs(at.uv), vec2f(room)), folded.xy);
    return moved;
}
