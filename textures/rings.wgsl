/// Concentric rings of two colors around the y axis, like a target.
///
/// scale = 1.25, 0.01 to 100: rings of each color per scene unit
/// duty = 0.5, 0 to 1: share of the width that the even rings take
/// even = "#a8473f": color of the disc in the middle and of each other ring
/// odd = "#ece2cf": color of the rings between
fn rings(at: Surface, scale: f32, duty: f32, even: vec3f, odd: vec3f) -> vec3f {
    let p = at.position.xz;
    let away = length(p);
    // A square pixel reaches farther across a ring that it meets at an angle: one box along
    // the larger component, at two places for the smaller.
    let reach = abs(p) / max(away, 1e-12) * at.footprint * scale;
    let half = min(reach.x, reach.y) * 0.2887;
    let width = max(reach.x, reach.y);
    // A pixel over the axis has nothing beyond it.
    let ring = max(away * scale + vec2f(-half, half), vec2f(0.5 * width));
    let shares = dutyShare(ring, vec2f(width), duty);
    let share = 0.5 * (shares.x + shares.y);
    return even * share + odd * (1.0 - share);
}
