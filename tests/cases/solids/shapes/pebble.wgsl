/// A rounded block.
///
/// min = (-0.5, 0, -0.5): its lowest corner
/// max = (0.5, 0.4, 0.5): its highest corner
/// radius = 0.15, 0.01 to 1: of its edges
fn pebbleDistance(p: vec3f, min_: vec3f, max_: vec3f, radius: f32) -> f32 {
    let outside = abs(p - 0.5 * (min_ + max_)) - 0.5 * (max_ - min_) + radius;
    return length(max(outside, vec3f(0.0))) + min(max(outside.x, max(outside.y, outside.z)), 0.0) - radius;
}

fn pebbleBounds(min_: vec3f, max_: vec3f, radius: f32) -> Bounds {
    return Bounds(min_, max_);
}
