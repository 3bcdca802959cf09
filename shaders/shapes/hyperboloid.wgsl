/// A cooling tower or an hourglass: a hyperbola turned around its axis, closed by two discs.
/// moves with base, top
/// base differs from top
///
/// base = (0, 0, 0): the middle of one disc
/// top = (0, 1, 0): the middle of the other
/// end_radius = 1, 0.00001 to 100000: of the discs
/// waist_radius = 0.5, 0 to 100000: halfway between them; wider than the ends, it makes a barrel
fn hyperboloid(ray: Ray, base: vec3f, top: vec3f, end_radius: f32, waist_radius: f32) -> f32 {
    let center = 0.5 * (base + top);
    let size = distance(base, top);
    if size < LEAST_SIZE {
        return NO_HIT;
    }
    let axis = (top - base) / size;
    let middle = nearestApproach(ray, center);
    let nearest = ray.origin - center + middle * ray.direction;
    let rise = dot(ray.direction, axis);
    let climb = select(rise, 1e-20, abs(rise) < 1e-20);
    let halfway = -dot(nearest, axis) / climb;
    let reach = abs(0.5 * size / climb);
    let limit = (size + 2.0 * (end_radius + waist_radius)) / length(ray.direction);
    let enter = max(halfway - reach, -limit);
    let leave = min(halfway + reach, limit);
    if enter > leave {
        return NO_HIT;
    }
    // Solved from where the ray is nearest to the axis, nothing large cancels.
    let drift = ray.direction - rise * axis;
    let start = clamp(-dot(nearest, drift) / max(dot(drift, drift), 1e-24), enter, leave);
    let p = nearest + start * ray.direction;
    let height = dot(p, axis);
    let across = p - height * axis;
    // |across + t drift|² = waist² + opening (height + t rise)²: a t² + 2 b t + c = 0.
    let waist2 = waist_radius * waist_radius;
    let opening = hyperboloidOpening(size, end_radius, waist_radius);
    let curvature = dot(drift, drift) - opening * rise * rise;
    let a = select(curvature, 1e-20, abs(curvature) < 1e-20);
    let b = dot(across, drift) - opening * height * rise;
    let c = dot(across, across) - waist2 - opening * height * height;
    let discriminant = b * b - a * c;
    if discriminant < 0.0 {
        // A steep ray that never meets the side is inside all the way.
        return select(firstOnRay(ray, middle + enter, middle + leave), NO_HIT, a > 0.0);
    }
    let root = select(-1.0, 1.0, b >= 0.0) * sqrt(discriminant);
    // As in cone.wgsl: c / outer where the outer root is far off, as along a generator.
    let outer = -b - root;
    let is_far = outer * outer > abs(a) * (dot(across, across) + waist2 + abs(opening) * height * height);
    let inner_t = select(root - b, c, is_far) / select(a, outer, is_far);
    let side = start + select(vec2f(inner_t, outer / a), vec2f(outer / a, inner_t), b >= 0.0);
    // Inside is what lies between the roots; for a steep ray, where they are in the other order,
    // what lies before and what lies behind.
    let steep = a < 0.0;
    let first = vec2f(select(max(side.x, enter), enter, steep), min(side.y, leave));
    let second = vec2f(max(side.x, enter), leave);
    var hit = NO_HIT;
    if first.x <= first.y {
        hit = firstOnRay(ray, middle + first.x, middle + first.y);
    }
    if steep && hit == NO_HIT && second.x <= second.y {
        hit = firstOnRay(ray, middle + second.x, middle + second.y);
    }
    return hit;
}

/// How fast the square of the radius grows with that of the height.
fn hyperboloidOpening(size: f32, end_radius: f32, waist_radius: f32) -> f32 {
    return 4.0 * (end_radius - waist_radius) * (end_radius + waist_radius) / (size * size);
}

fn hyperboloidSurface(
    p: vec3f, base: vec3f, top: vec3f, end_radius: f32, waist_radius: f32,
) -> Surface {
    let size = max(distance(base, top), 1e-20);
    // Turned over, so that around y the angle goes from +x towards +z, as on a sphere.
    let frame = frameAround((base - top) / size);
    let q = (p - 0.5 * (base + top)) * frame;
    let apart = length(q.xy);
    let opening = hyperboloidOpening(size, end_radius, waist_radius);
    let slope = vec2f(apart, -opening * q.z);
    let off = 0.5 * (apart * apart - waist_radius * waist_radius - opening * q.z * q.z);
    let steepness = length(slope);
    let end_depth = 0.5 * size - abs(q.z);
    if end_depth * steepness < abs(off) {
        let normal = select(-frame[2], frame[2], q.z >= 0.0);
        return surface(p + end_depth * normal, normal, q.xy);
    }
    let outward = select(q.xy / max(apart, 1e-20), vec2f(1.0, 0.0), apart < 1e-20); // a waist of 0
    let angle = atan2(outward.y, select(outward.x, 1e-20, abs(outward.x) < 1e-20));
    let tilt = normalize(slope + vec2f(1e-12, 0.0));
    // v as on the cone from the waist to an end.
    let stretch = length(vec2f(0.5 * size, end_radius - waist_radius)) / (0.5 * size);
    let uv = vec2f(max(end_radius, waist_radius) * angle, stretch * (0.5 * size - q.z));
    let normal = frame * vec3f(tilt.x * outward, tilt.y);
    return surface(p - off / max(steepness, 1e-6) * normal, normal, uv);
}
