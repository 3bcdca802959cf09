/// Mirrors a wedge of a texture all around the y axis, and of its uv around their origin.
///
/// folds = 6, 1 to 64: how many times the wedge and its mirror image go around
/// turn_deg = 15, -360 to 360: which way the wedge lies, from x towards z
fn kaleidoscope(at: Surface, folds: u32, turn_deg: f32) -> Surface {
    let share = 1.0 / f32(clamp(folds, 1u, 1024u));
    let fold = kaleidoscopeFold(at.position.xz, share, turn_deg / 360.0);
    let position = fold * at.position.xz;
    let normal = fold * at.normal.xz;
    var moved = at;
    moved.position = vec3f(position.x, at.position.y, position.y);
    moved.normal = vec3f(normal.x, at.normal.y, normal.y);
    moved.uv = kaleidoscopeFold(at.uv, share, turn_deg / 360.0) * at.uv;
    return moved;
}

/// The rotation or reflection that brings `p` into the wedge that begins at `start`, in turns.
fn kaleidoscopeFold(p: vec2f, share: f32, start: f32) -> mat2x2f {
    // The origin has no direction: any will do.
    let d = select(p, vec2f(1.0, 0.0), dot(p, p) == 0.0);
    let angle = atan2(d.y, d.x) / 6.2831853 - start;
    let middle = share * round(angle / share);
    let side = select(-1.0, 1.0, angle >= middle);
    let turns = select(middle + 2.0 * start, -middle, side > 0.0);
    // sin and cos are only sure between -pi and pi.
    let phi = (turns - round(turns)) * 6.2831853;
    let c = cos(phi);
    let s = sin(phi);
    return mat2x2f(c, s, -side * s, side * c);
}
