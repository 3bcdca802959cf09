/// Two balls that flow into each other where they are near.
/// moves with a, b
///
/// a = (-0.6, 0, 0): the middle of the first ball
/// b = (0.7, 0.3, 0): the middle of the second
/// radius_a = 0.8, 0.00001 to 100000: of the first ball
/// radius_b = 0.55, 0.00001 to 100000: of the second
/// blend = 0.5, 0.00001 to 100000: from how far they reach for each other
fn smoothBallsDistance(p: vec3f, a: vec3f, b: vec3f, radius_a: f32, radius_b: f32, blend: f32) -> f32 {
    let first = length(p - a) - radius_a;
    let second = length(p - b) - radius_b;
    // A quadratic minimum (Quilez, Smooth Minimum, 2013).
    let near = max(blend - abs(first - second), 0.0);
    return min(first, second) - near * near * 0.25 / blend;
}

fn smoothBallsBounds(a: vec3f, b: vec3f, radius_a: f32, radius_b: f32, blend: f32) -> Bounds {
    let reach_a = vec3f(radius_a + 0.25 * blend);
    let reach_b = vec3f(radius_b + 0.25 * blend);
    return Bounds(min(a - reach_a, b - reach_b), max(a + reach_a, b + reach_b));
}
