/// Turns a texture about the origin, as `rotate_deg` turns an object.
///
/// angle_deg = (0, 30, 0), -360 to 360: turns about x, then y, then z; uv turns by y, as a floor does
fn rotate(at: Surface, angle_deg: vec3f) -> Surface {
    let turns = angle_deg / 360.0;
    // sin and cos are only sure between -pi and pi.
    let angle = (turns - round(turns)) * 6.2831853;
    let c = cos(angle);
    let s = sin(angle);
    let about_x = mat3x3f(1.0, 0.0, 0.0, 0.0, c.x, s.x, 0.0, -s.x, c.x);
    let about_y = mat3x3f(c.y, 0.0, -s.y, 0.0, 1.0, 0.0, s.y, 0.0, c.y);
    let about_z = mat3x3f(c.z, s.z, 0.0, -s.z, c.z, 0.0, 0.0, 0.0, 1.0);
    let turn = about_z * about_y * about_x;
    var moved = at;
    // The texture turns one way if the point that asks turns the other: a vector on the left of a
    // rotation meets its inverse.
    moved.position = at.position * turn;
    moved.normal = at.normal * turn;
    moved.uv = vec2f(c.y * at.uv.x - s.y * at.uv.y, s.y * at.uv.x + c.y * at.uv.y);
    return moved;
}
