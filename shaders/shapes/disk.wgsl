/// A flat disc, or a ring cut from it; seen from both sides.
/// encloses nothing, so that it cannot be a part of a solid
/// moves with center
/// inner_radius is less than radius
///
/// center = (0, 0, 0): the middle
/// normal = (0, 1, 0), nonzero: the way the disc faces; any length
/// radius = 1, 0.00001 to 100000: from the middle to the rim
/// inner_radius = 0, 0 to 100000: of the hole
fn disk(ray: Ray, center: vec3f, normal: vec3f, radius: f32, inner_radius: f32) -> f32 {
    let approach = dot(normal, ray.direction);
    if abs(approach) < 1e-20 {
        return NO_HIT;
    }
    let middle = nearestApproach(ray, center);
    let nearest = ray.origin - center + middle * ray.direction;
    let t = -dot(normal, nearest) / approach;
    let q = nearest + t * ray.direction;
    let apart2 = dot(q, q);
    let within = apart2 <= radius * radius && apart2 >= inner_radius * inner_radius;
    return select(NO_HIT, onRay(ray, middle + t), within);
}

fn diskSurface(
    p: vec3f, center: vec3f, normal: vec3f, radius: f32, inner_radius: f32,
) -> Surface {
    let n = normalize(normal);
    let q = p - center - dot(n, p - center) * n;
    return surface(center + q, n, q * flatTangents(n));
}
