/// A ball stretched along the axes.
/// moves with center
///
/// center = (0, 0, 0): the middle
/// radii = (1, 1, 1), 0.00001 to 100000: from the middle to the surface along x, y and z
fn ellipsoid(ray: Ray, center: vec3f, radii: vec3f) -> f32 {
    let middle = nearestApproach(ray, center);
    let nearest = (ray.origin - center + middle * ray.direction) / radii;
    let direction = ray.direction / radii;
    // The nearest approach again, now to a ball of radius 1.
    let closest = -dot(nearest, direction) / dot(direction, direction);
    let offset = nearest + closest * direction;
    let inside = 1.0 - dot(offset, offset);
    if inside < 0.0 {
        return NO_HIT;
    }
    let reach = sqrt(inside / dot(direction, direction));
    return firstOnRay(ray, middle + closest - reach, middle + closest + reach);
}

fn ellipsoidSurface(p: vec3f, center: vec3f, radii: vec3f) -> Surface {
    let ball = normalize((p - center) / radii);
    let longitude = atan2(ball.z, select(ball.x, 1e-20, abs(ball.x) < 1e-20));
    let latitude = atan2(ball.y, max(length(ball.xz), 1e-20));
    let unrolled = vec2f(0.5 * (radii.x + radii.z), radii.y);
    let normal = normalize(ball / radii);
    var at = surface(center + radii * ball, normal, unrolled * vec2f(longitude, latitude));
    at.whole = 1.5707963 * vec4f(2.0, -1.0, -4.0, 2.0) * unrolled.xyxy;
    return at;
}
