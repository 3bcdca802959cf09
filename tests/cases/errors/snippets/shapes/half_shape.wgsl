/// A shape whose second function is not there.
///
/// radius = 1, 0 to 100: its radius
fn halfShape(ray: Ray, radius: f32) -> f32 {
    return NO_HIT;
}
