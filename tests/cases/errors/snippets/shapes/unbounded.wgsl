/// A distance without bounds.
///
/// radius = 1, 0.1 to 10: of the ball
fn unboundedDistance(p: vec3f, radius: f32) -> f32 {
    return length(p) - radius;
}
