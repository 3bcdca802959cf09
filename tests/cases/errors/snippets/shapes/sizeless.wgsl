/// A ball whose docs compare what it does not have.
/// centre differs from rim
/// center differs from radius
/// no line holds center, rim, pole
/// radius differs from all that prose may say
///
/// center = (0, 0, 0): the middle
/// rim = (1, 0, 0): a point of it
/// radius = 1: its radius
fn sizeless(ray: Ray, center: vec3f, rim: vec3f, radius: f32) -> f32 {
    return NO_HIT;
}

fn sizelessSurface(p: vec3f, center: vec3f, rim: vec3f, radius: f32) -> Surface {
    return surface(p, rim, p.xy);
}
