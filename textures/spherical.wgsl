/// Throws flat patterns outwards from a center: u is the longitude, v the latitude, as on a globe.
///
/// center = (0, 0, 0), -10 to 10: middle of the globe
/// around = 12, 1 to 1000: units of u in a full turn, so half a turn of v has half as many
fn spherical(at: Surface, center: vec3f, around: f32) -> Surface {
    let d = at.position - center;
    let from_axis = length(d.xz);
    // The poles have no longitude and the center no latitude: any will do.
    let level = select(d.xz, vec2f(1.0, 0.0), dot(d.xz, d.xz) == 0.0);
    let per_radian = around / 6.2831853;
    var moved = at;
    moved.uv = per_radian * vec2f(atan2(level.y, level.x), atan2(d.y, max(from_axis, 1e-12)));
    // Seen from outside, longitude grows to the left; the sky is seen from inside.
    let is_sky = at.whole.x < 0.0;
    moved.whole = 0.25 * around * select(vec4f(2.0, -1.0, -4.0, 2.0), vec4f(-2.0, -1.0, 4.0, 2.0), is_sky);
    moved.density = 1.0;
    // The root mean square of the stretches along and across the circles of latitude.
    let crowding = per_radian / max(vec2f(from_axis, length(d)), vec2f(1e-4));
    moved.footprint *= sqrt(0.5 * dot(crowding, crowding));
    return moved;
}
