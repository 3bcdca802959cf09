/// Bends flat patterns around the origin of uv: what ran along u runs in circles, v runs outwards.
///
/// around = 12, 1 to 1000: units of u in a full turn; patterns that repeat in it show no seam
fn polar(at: Surface, around: f32) -> Surface {
    let radius = length(at.uv);
    // The origin has no direction: any will do.
    let d = select(at.uv, vec2f(1.0, 0.0), dot(at.uv, at.uv) == 0.0);
    let per_radian = around / 6.2831853;
    var moved = at;
    moved.uv = vec2f(per_radian * atan2(d.y, d.x), radius);
    moved.whole = vec4f(0.0);
    // The root mean square of the stretches outwards and around.
    let crowding = per_radian / max(radius, 1e-4);
    moved.footprint *= sqrt(0.5 + 0.5 * crowding * crowding);
    return moved;
}
