// The sphere around the scene.

/// The point of the unit sphere in `direction`, which is where a background is asked for its color.
fn skyPoint(direction: vec3f) -> Surface {
    let uv = vec2f(atan2(direction.z, direction.x), asin(clamp(direction.y, -1.0, 1.0)));
    var at = surface(direction, direction, uv);
    at.whole = 1.5707963 * vec4f(-2.0, -1.0, 4.0, 2.0);
    return at;
}
