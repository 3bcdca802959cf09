/// A cylinder with a half ball on either end.
/// moves with base, top
///
/// base = (0, 0, 0): the middle of one ball
/// top = (0, 1, 0): the middle of the other
/// radius = 0.5, 0.00001 to 100000: of the balls and of the cylinder
fn capsule(ray: Ray, base: vec3f, top: vec3f, radius: f32) -> f32 {
    let center = 0.5 * (base + top);
    let size = distance(base, top);
    let axis = (top - base) / max(size, 1e-20);
    let middle = nearestApproach(ray, center);
    let nearest = ray.origin - center + middle * ray.direction;
    let height = dot(nearest, axis);
    let rise = dot(ray.direction, axis);
    let across = nearest - height * axis;
    let drift = ray.direction - rise * axis;
    // A ray along the axis stays inside for very long, or never gets there.
    let drift2 = max(dot(drift, drift), 1e-24);
    let closest = -dot(across, drift) / drift2;
    let offset = across + closest * drift;
    let inside = radius * radius - dot(offset, offset);
    if inside < 0.0 {
        return NO_HIT;
    }
    let reach = sqrt(inside / drift2);
    // First where the ray enters the endless cylinder, then where it leaves: beyond an end, the
    // ball there takes over, and a ray that misses that ball has missed everything.
    for (var heading = -1.0; heading < 2.0; heading += 2.0) {
        var t = closest + heading * reach;
        let level = height + t * rise;
        let end = clamp(level, -0.5 * size, 0.5 * size);
        if level != end {
            let to_end = end * axis - nearest;
            let direction2 = dot(ray.direction, ray.direction);
            let ball = dot(to_end, ray.direction) / direction2;
            let miss = to_end - ball * ray.direction;
            let ball_inside = radius * radius - dot(miss, miss);
            if ball_inside < 0.0 {
                return NO_HIT;
            }
            t = ball + heading * sqrt(ball_inside / direction2);
        }
        let hit = onRay(ray, middle + t);
        if hit < NO_HIT {
            return hit;
        }
    }
    return NO_HIT;
}

fn capsuleSurface(p: vec3f, base: vec3f, top: vec3f, radius: f32) -> Surface {
    let size = distance(base, top);
    // Turned over, so that around y the angle goes from +x towards +z, as on a sphere; size 0 is one.
    let down = (base - top) / max(size, 1e-20);
    let frame = frameAround(select(down, vec3f(0.0, -1.0, 0.0), size < LEAST_SIZE));
    let q = (p - base) * frame;
    let end = clamp(-q.z, 0.0, size);
    let n = normalize(vec3f(q.xy, q.z + end));
    let angle = atan2(n.y, select(n.x, 1e-20, abs(n.x) < 1e-20));
    // The height goes on over the balls as the length of their meridians.
    let bow = atan2(-n.z, max(length(n.xy), 1e-20));
    let normal = frame * n;
    let snapped = base - end * frame[2] + radius * normal;
    return surface(snapped, normal, vec2f(radius * angle, end + radius * bow));
}
