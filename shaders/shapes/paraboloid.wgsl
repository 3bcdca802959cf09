/// A dome: a parabola turned around its axis, closed by a disc.
/// moves with base, top
/// base differs from top
///
/// base = (0, 0, 0): the middle of the disc
/// top = (0, 1, 0): the highest point
/// radius = 1, 0.00001 to 100000: of the disc
fn paraboloid(ray: Ray, base: vec3f, top: vec3f, radius: f32) -> f32 {
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
    let limit = (size + 2.0 * radius) / length(ray.direction);
    let enter = max(halfway - reach, -limit);
    let leave = min(halfway + reach, limit);
    if enter > leave {
        return NO_HIT;
    }
    // Solved from where the ray is nearest to the axis, nothing large cancels.
    let drift = ray.direction - rise * axis;
    let a = max(dot(drift, drift), 1e-24);
    let start = clamp(-dot(nearest, drift) / a, enter, leave);
    let p = nearest + start * ray.direction;
    let height = dot(p, axis);
    let across = p - height * axis;
    // |across + t drift|² = opening (depth - t rise): a t² + 2 b t + c = 0.
    let opening = radius * radius / size;
    let depth = 0.5 * size - height;
    let b = dot(across, drift) + 0.5 * opening * rise;
    let c = dot(across, across) - opening * depth;
    let discriminant = b * b - a * c;
    if discriminant < 0.0 {
        return NO_HIT;
    }
    let root = select(-1.0, 1.0, b >= 0.0) * sqrt(discriminant);
    // As in cone.wgsl: c / outer where the outer root is far off, as along the axis.
    let outer = -b - root;
    let is_far = outer * outer > a * (dot(across, across) + opening * abs(depth));
    let inner_t = select(root - b, c, is_far) / select(a, outer, is_far);
    let side = select(vec2f(inner_t, outer / a), vec2f(outer / a, inner_t), b >= 0.0);
    let near = max(start + side.x, enter);
    let far = min(start + side.y, leave);
    if near > far {
        return NO_HIT;
    }
    return firstOnRay(ray, middle + near, middle + far);
}

fn paraboloidSurface(p: vec3f, base: vec3f, top: vec3f, radius: f32) -> Surface {
    let size = max(distance(base, top), 1e-20);
    // Turned over, so that around y the angle goes from +x towards +z, as on a sphere.
    let frame = frameAround((base - top) / size);
    let q = (p - top) * frame;
    let apart = length(q.xy);
    let opening = radius * radius / size;
    let slope = 2.0 * apart / opening;
    let stretch = sqrt(1.0 + slope * slope);
    let depth = (q.z - apart * apart / opening) / stretch;
    if size - q.z < abs(depth) {
        return surface(p + (size - q.z) * frame[2], frame[2], q.xy);
    }
    let outward = q.xy / max(apart, 1e-20);
    let angle = atan2(outward.y, select(outward.x, 1e-20, abs(outward.x) < 1e-20));
    // v is the length of the meridian, from the highest point down.
    let uv = vec2f(radius * angle, -0.5 * apart * stretch - 0.25 * opening * asinh(slope));
    let normal = frame * vec3f(slope * outward, -1.0) / stretch;
    return surface(p + depth * normal, normal, uv);
}
