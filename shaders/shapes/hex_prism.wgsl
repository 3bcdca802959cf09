/// A six-sided prism, as the cells of a honeycomb.
/// moves with center
///
/// center = (0, 0, 0): the middle
/// axis = (0, 1, 0), nonzero: the way from end to end; where it is y, two corners lie along x
/// radius = 1, 0.00001 to 100000: from the middle to the corners, as long as a side
/// height = 1, 0.00001 to 100000: from end to end
fn hexPrism(ray: Ray, center: vec3f, axis: vec3f, radius: f32, height: f32) -> f32 {
    let up = normalize(axis);
    let flat = flatTangents(up);
    let across = mat4x3f(flat * HEX_PRISM_FIRST, flat[1], flat * HEX_PRISM_LAST, up);
    let middle = nearestApproach(ray, center);
    // A slab for each pair of sides, and one for the ends.
    let nearest = (ray.origin - center + middle * ray.direction) * across;
    let speed = ray.direction * across;
    let d = select(speed, vec4f(1e-20), abs(speed) < vec4f(1e-20));
    let halfway = -nearest / d;
    let reach = abs(vec4f(vec3f(HEX_PRISM_FIRST.x * radius), 0.5 * height) / d);
    let enter = halfway - reach;
    let leave = halfway + reach;
    let near = max(max(enter.x, enter.y), max(enter.z, enter.w));
    let far = min(min(leave.x, leave.y), min(leave.z, leave.w));
    // Two ulp of slack: no ray slips between prisms that share a side, as in box.wgsl.
    if near > far + 4e-7 * abs(far) {
        return NO_HIT;
    }
    return firstOnRay(ray, middle + near, middle + far);
}

/// The way that the first side faces, 30 degrees from a corner, and the third, 150 degrees from it.
const HEX_PRISM_FIRST: vec2f = vec2f(0.8660254, 0.5);
const HEX_PRISM_LAST: vec2f = vec2f(-0.8660254, 0.5);

fn hexPrismSurface(p: vec3f, center: vec3f, axis: vec3f, radius: f32, height: f32) -> Surface {
    let up = normalize(axis);
    let flat = flatTangents(up);
    let q = (p - center) * flat;
    let level = dot(p - center, up);
    let beyond = vec3f(dot(q, HEX_PRISM_FIRST), q.y, dot(q, HEX_PRISM_LAST));
    let apart = max(abs(beyond.x), max(abs(beyond.y), abs(beyond.z)));
    let depth = HEX_PRISM_FIRST.x * radius - apart;
    let end_depth = 0.5 * height - abs(level);
    if end_depth < depth {
        let normal = select(-up, up, level >= 0.0);
        return surface(p + end_depth * normal, normal, q);
    }
    let is_first = abs(beyond.x) >= apart;
    let is_second = !is_first && abs(beyond.y) >= apart;
    let side = select(select(2.0, 1.0, is_second), 0.0, is_first);
    let facing = select(select(HEX_PRISM_LAST, vec2f(0.0, 1.0), is_second), HEX_PRISM_FIRST, is_first);
    let outward = select(-facing, facing, dot(q, facing) >= 0.0);
    // u goes around all six sides.
    let lap = select(side + 3.5, side + 0.5, dot(q, facing) >= 0.0);
    let u = radius * lap + dot(q, vec2f(-outward.y, outward.x));
    let normal = flat * outward;
    return surface(p + depth * normal, normal, vec2f(u, level + 0.5 * height));
}
