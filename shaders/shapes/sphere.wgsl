/// A ball.
/// moves with center
///
/// center = (0, 0, 0): the middle of the ball
/// radius = 1, 0.00001 to 100000: from the middle to the surface
fn sphere(ray: Ray, center: vec3f, radius: f32) -> f32 {
    let middle = nearestApproach(ray, center);
    let nearest = ray.origin - center + middle * ray.direction;
    let inside = radius * radius - dot(nearest, nearest);
    if inside < 0.0 {
        return NO_HIT;
    }
    // Seen from the nearest approach the chord is symmetric, so nothing cancels
    // (Haines et al., Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems ch. 7).
    let reach = sqrt(inside / dot(ray.direction, ray.direction));
    return firstOnRay(ray, middle - reach, middle + reach);
}

fn sphereSurface(p: vec3f, center: vec3f, radius: f32) -> Surface {
    let normal = normalize(p - center);
    // WGSL leaves atan2 open where its second argument is 0: the poles and the meridian above z.
    let longitude = atan2(normal.z, select(normal.x, 1e-20, abs(normal.x) < 1e-20));
    // Unlike asin, this keeps its digits near the poles.
    let latitude = atan2(normal.y, max(length(normal.xz), 1e-20));
    var at = surface(center + radius * normal, normal, radius * vec2f(longitude, latitude));
    // Seen from outside, longitude grows to the left.
    at.whole = 1.5707963 * radius * vec4f(2.0, -1.0, -4.0, 2.0);
    return at;
}
