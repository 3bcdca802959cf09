/// Bands of two colors winding out from the y axis, like those of a lollipop.
///
/// scale = 0.8, 0.01 to 100: bands of each color per scene unit away from the axis
/// arms = 3, 1 to 32: bands of each color that meet at the axis
/// duty = 0.5, 0 to 1: share of the width that the even bands take
/// even = "#e9dfca": color of the bands that start towards +x
/// odd = "#2f5f66": color of the bands between
fn spiral(at: Surface, scale: f32, arms: u32, duty: f32, even: vec3f, odd: vec3f) -> vec3f {
    let p = at.position.xz * scale;
    let width = at.footprint * scale;
    let turns = f32(arms) / 6.2831853;
    // Near the axis a wide pixel sees the bands bend.
    let n = footprintParts(width / max(length(p), 1e-6), 2.0);
    let part = width / f32(n);
    var share = 0.0;
    for (var i = 0u; i < n * n; i++) {
        let q = p + footprintPart(i, n, width);
        let away = max(length(q), 1e-9);
        // The angle of no direction is whatever the driver likes.
        let known = select(q, vec2f(1.0, 0.0), away < 1e-8);
        let phase = away - turns * atan2(known.y, known.x);
        // Towards the axis the bands narrow without end.
        let slope = abs(q - turns * vec2f(-q.y, q.x) / away) / away;
        share += dutySquareShare(phase, min(slope * part, vec2f(64.0)), duty) / f32(n * n);
    }
    return even * share + odd * (1.0 - share);
}
