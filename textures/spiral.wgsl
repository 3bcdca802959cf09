/// Bands of two colors winding out from the y axis, like those of a lollipop.
///
/// scale = 0.8, 0.01 to 100: bands of each color per scene unit away from the axis
/// arms = 3, 1 to 32: bands of each color that meet at the axis
/// duty = 0.5, 0 to 1: share of the width that the even bands take
/// even = "#e9dfca": color of the bands that start towards +x
/// odd = "#2f5f66": color of the bands between
fn spiral(at: Surface, scale: f32, arms: u32, duty: f32, even: vec3f, odd: vec3f) -> vec3f {
    let p = at.position.xz;
    let away = max(length(p), 1e-9);
    // The angle of no direction is whatever the driver likes.
    let q = select(p, vec2f(1.0, 0.0), away < 1e-8);
    let turns = f32(arms) / 6.2831853;
    let phase = scale * away - turns * atan2(q.y, q.x);
    // Towards the axis the bands narrow without end. A square pixel reaches farther across
    // those that it meets at an angle: one box, at two places for the smaller component.
    let slope = abs(scale * p - turns * vec2f(-p.y, p.x) / away) / away;
    let reach = min(slope * at.footprint, vec2f(64.0));
    let half = min(reach.x, reach.y) * 0.2887;
    let shares = dutyShare(phase + vec2f(-half, half), vec2f(max(reach.x, reach.y)), duty);
    let share = 0.5 * (shares.x + shares.y);
    return even * share + odd * (1.0 - share);
}
