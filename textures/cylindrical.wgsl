/// Throws flat patterns outwards from the y axis, like the label of a can: u goes around, v is the height.
///
/// around = 6, 1 to 1000: units of u in a full turn: 6.28 times the radius keeps the label's proportions
fn cylindrical(at: Surface, around: f32) -> Surface {
    let p = at.position.xz;
    // The axis has no direction: any will do.
    let d = select(p, vec2f(1.0, 0.0), dot(p, p) == 0.0);
    let per_radian = around / 6.2831853;
    var moved = at;
    moved.uv = vec2f(per_radian * atan2(d.y, d.x), at.position.y);
    moved.whole = vec4f(0.0);
    moved.density = 1.0;
    // The root mean square of the stretches around and upwards, where the surface goes up.
    let crowding = per_radian / max(length(p), 1e-4);
    let rise = max(1.0 - at.normal.y * at.normal.y, 0.0);
    moved.footprint *= sqrt(0.5 * (crowding * crowding + rise));
    return moved;
}
