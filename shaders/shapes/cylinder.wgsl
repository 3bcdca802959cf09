/// A cylinder, closed by two discs.
/// moves with base, top
/// base differs from top
///
/// base = (0, 0, 0): the middle of one disc
/// top = (0, 1, 0): the middle of the other
/// radius = 1, 0.00001 to 100000: of the discs
fn cylinder(ray: Ray, base: vec3f, top: vec3f, radius: f32) -> f32 {
    let center = 0.5 * (base + top);
    let size = distance(base, top);
    if size < LEAST_SIZE {
        return NO_HIT;
    }
    let axis = (top - base) / size;
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
    let side_reach = sqrt(inside / drift2);
    let climb = select(rise, 1e-20, abs(rise) < 1e-20);
    let halfway = -height / climb;
    let reach = abs(0.5 * size / climb);
    let near = max(closest - side_reach, halfway - reach);
    let far = min(closest + side_reach, halfway + reach);
    if near > far {
        return NO_HIT;
    }
    return firstOnRay(ray, middle + near, middle + far);
}

fn cylinderSurface(p: vec3f, base: vec3f, top: vec3f, radius: f32) -> Surface {
    let size = distance(base, top);
    // Turned over, so that around y the angle goes from +x towards +z, as on a sphere.
    let frame = frameAround((base - top) / max(size, 1e-20));
    let q = (p - base) * frame;
    let height = -q.z;
    let apart = length(q.xy);
    let depth = radius - apart;
    let end_depth = min(height, size - height);
    if end_depth < abs(depth) {
        let normal = select(-frame[2], frame[2], height < 0.5 * size);
        return surface(p + end_depth * normal, normal, q.xy);
    }
    let outward = q.xy / max(apart, 1e-20);
    let angle = atan2(outward.y, select(outward.x, 1e-20, abs(outward.x) < 1e-20));
    let normal = frame * vec3f(outward, 0.0);
    return surface(p + depth * normal, normal, vec2f(radius * angle, height));
}
