/// A curved sheet that fills a ball with two mazes which never meet (Schoen, Infinite Periodic Minimal
/// Surfaces, 1970).
/// moves with center
///
/// center = (0, 0, 0): the middle of the ball
/// radius = 1, 0.00001 to 100000: of the ball
/// period = 0.9, 0.00001 to 100000: from one turn of the sheet to the next
/// thickness = 0.08, 0.000001 to 10000: of the sheet, about
fn gyroidDistance(p: vec3f, center: vec3f, radius: f32, period: f32, thickness: f32) -> f32 {
    let q = p - center;
    let turns = q / period;
    let angle = 6.2831853 * (turns - round(turns));
    let sheet = dot(sin(angle), cos(angle.yzx)) * period / 6.2831853;
    // The sum of sines is no steeper than 1.75 times the way across.
    return max((abs(sheet) - 0.6 * thickness) / 1.75, length(q) - radius);
}

fn gyroidBounds(center: vec3f, radius: f32, period: f32, thickness: f32) -> Bounds {
    return Bounds(center - radius, center + radius);
}
