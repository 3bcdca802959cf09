/// A ball whose docs name points that it does not have.
/// moves with centre, radius, axis
///
/// center = (0, 0, 0): the middle
/// axis = (0, 1, 0), nonzero: the way up
/// radius = 1: its radius
fn pointless(ray: Ray, center: vec3f, axis: vec3f, radius: f32) -> f32 {
    return NO_HIT;
}

fn pointlessSurface(p: vec3f, center: vec3f, axis: vec3f, radius: f32) -> Surface {
    return surface(p, axis, p.xy);
}
