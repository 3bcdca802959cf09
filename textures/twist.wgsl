/// Wrings a texture around the y axis: the higher up, the further it is turned.
///
/// angle_deg = 60, -720 to 720: turn per scene unit of height; uv turns likewise around its origin
fn twist(at: Surface, angle_deg: f32) -> Surface {
    let turns = at.position.y * angle_deg / 360.0;
    // sin and cos are only sure between -pi and pi.
    let angle = (turns - round(turns)) * 6.2831853;
    let c = cos(angle);
    let s = sin(angle);
    // The texture turns one way if the point that asks turns the other.
    let turn = mat2x2f(c, s, -s, c);
    let position = turn * at.position.xz;
    let normal = turn * at.normal.xz;
    var moved = at;
    moved.position = vec3f(position.x, at.position.y, position.y);
    moved.normal = vec3f(normal.x, at.normal.y, normal.y);
    moved.uv = turn * at.uv;

    // What goes up along the surface turns around the axis: a shear in space, while in uv it may also
    // be drawn out. Of the stretch, the root mean square over all directions.
    let rise = abs(angle_deg) * 0.017453293 * sqrt(max(1.0 - at.normal.y * at.normal.y, 0.0));
    let shear = rise * vec2f(length(at.position.xz), length(at.uv));
    let along = rise * vec2f(0.0, abs(at.uv.x));
    let stretch = sqrt(1.0 + along + 0.5 * shear * shear);
    moved.footprint *= max(stretch.x, stretch.y);
    return moved;
}
