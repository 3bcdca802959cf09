/// A square pyramid, whole or cut off.
/// moves with base, top
/// base differs from top
///
/// base = (0, 0, 0): the middle of one square
/// top = (0, 1, 0): the middle of the other, or the tip
/// base_size = 2, 0.00001 to 100000: sides of the square at the base; upright, they lie along x and z
/// top_size = 0, 0 to 100000: sides of the square at the top; 0 makes a tip
fn pyramid(ray: Ray, base: vec3f, top: vec3f, base_size: f32, top_size: f32) -> f32 {
    let center = 0.5 * (base + top);
    let size = distance(base, top);
    if size < LEAST_SIZE {
        return NO_HIT;
    }
    let axis = (top - base) / size;
    let flat = flatTangents(axis);
    let middle = nearestApproach(ray, center);
    let nearest = ray.origin - center + middle * ray.direction;
    let height = dot(nearest, axis);
    let rise = dot(ray.direction, axis);
    let across = nearest * flat;
    let drift = ray.direction * flat;
    // How far outside of each side the ray is, and how fast it gets there.
    let widening = 0.5 * (top_size - base_size) / size;
    let beyond = vec4f(across, -across) - (0.25 * (base_size + top_size) + widening * height);
    let speed = vec4f(drift, -drift) - widening * rise;
    let away = select(speed, vec4f(1e-20), abs(speed) < vec4f(1e-20));
    let side = -beyond / away;
    let enter = select(side, vec4f(-NO_HIT), away > vec4f());
    let leave = select(vec4f(NO_HIT), side, away > vec4f());
    let climb = select(rise, 1e-20, abs(rise) < 1e-20);
    let halfway = -height / climb;
    let reach = abs(0.5 * size / climb);
    let near = max(max(max(enter.x, enter.y), max(enter.z, enter.w)), halfway - reach);
    let far = min(min(min(leave.x, leave.y), min(leave.z, leave.w)), halfway + reach);
    // Two ulp of slack: no ray slips between pyramids that share a square, as in box.wgsl.
    if near > far + 4e-7 * abs(far) {
        return NO_HIT;
    }
    return firstOnRay(ray, middle + near, middle + far);
}

fn pyramidSurface(p: vec3f, base: vec3f, top: vec3f, base_size: f32, top_size: f32) -> Surface {
    let size = max(distance(base, top), 1e-20);
    let axis = (top - base) / size;
    let flat = flatTangents(axis);
    let height = dot(p - base, axis);
    let q = (p - base) * flat;
    let widening = 0.5 * (top_size - base_size) / size;
    let stretch = sqrt(1.0 + widening * widening);
    let along_first = abs(q.x) >= abs(q.y);
    let depth = (0.5 * base_size + widening * height - max(abs(q.x), abs(q.y))) / stretch;
    let end_depth = min(height, size - height);
    if end_depth < depth {
        let normal = select(axis, -axis, height < 0.5 * size);
        return surface(p + end_depth * normal, normal, q);
    }
    let facing = select(vec2f(-1.0), vec2f(1.0), q >= vec2f());
    let outward = select(vec2f(0.0, facing.y), vec2f(facing.x, 0.0), along_first);
    let normal = (flat * outward - widening * axis) / stretch;
    return surface(p + depth * normal, normal, vec2f(select(q.x, q.y, along_first), stretch * height));
}
