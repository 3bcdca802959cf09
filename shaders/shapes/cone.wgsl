/// A cone, whole or cut off, closed by two discs.
/// moves with base, top
/// base differs from top
///
/// base = (0, 0, 0): the middle of one disc
/// top = (0, 1, 0): the middle of the other, or the tip
/// base_radius = 1, 0.00001 to 100000: of the disc at the base
/// top_radius = 0, 0 to 100000: of the disc at the top; 0 makes a tip
fn cone(ray: Ray, base: vec3f, top: vec3f, base_radius: f32, top_radius: f32) -> f32 {
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
    let drift2 = max(dot(drift, drift), 1e-24);
    let closest = -dot(across, drift) / drift2;
    let offset = across + closest * drift;
    let climb = select(rise, 1e-20, abs(rise) < 1e-20);
    let halfway = -height / climb;
    let reach = abs(0.5 * size / climb);
    let enter = halfway - reach;
    let leave = halfway + reach;

    // Solved from where the ray is closest to the axis between the discs: from farther off, what is left
    // near a tip is the rounding of large terms, and the mirrored cone beyond the tip may be met.
    let start = clamp(closest, enter, leave);
    let speed = sqrt(drift2);
    let along = (start - closest) * speed;
    let widening = (top_radius - base_radius) / size;
    let radius = 0.5 * (base_radius + top_radius) + widening * (height + start * rise);
    let growth = widening * rise;
    // |offset|² + (along + t speed)² = (radius + t growth)²: a t² + 2 b t + c = 0. The discriminant is
    // Lagrange's identity: b² - a c would cancel.
    let curvature = (speed - growth) * (speed + growth);
    let offset2 = dot(offset, offset);
    let slant = radius * speed - growth * along;
    let discriminant = slant * slant - curvature * offset2;
    if discriminant < 0.0 || abs(along) > max(base_radius, top_radius) {
        return NO_HIT;
    }
    // Along a generator a, b and the root are 0 or rounding: the crossings must be far off, not 0 / 0.
    let a = curvature + select(1e-25, -1e-25, curvature < 0.0);
    let b = along * speed - radius * growth;
    let c = offset2 + (along - radius) * (along + radius);
    let root = select(-1.0, 1.0, b >= 0.0) * (sqrt(discriminant) + 1e-20);
    // c / outer keeps its digits where the outer root is far off; where both are close, c has lost them.
    let outer = -b - root;
    let is_far = outer * outer >= abs(curvature) * offset2;
    let inner_t = select(root - b, c, is_far) / select(a, outer, is_far);
    let side = start + select(vec2f(inner_t, outer / a), vec2f(outer / a, inner_t), b >= 0.0);
    // A ray steeper than the side crosses it once, and the mirrored cone beyond the tip once.
    let steep = a < 0.0;
    let near = max(select(side.x, enter, steep && growth < 0.0), enter);
    let far = min(select(side.y, leave, steep && growth > 0.0), leave);
    if near > far {
        return NO_HIT;
    }
    return firstOnRay(ray, middle + near, middle + far);
}

fn coneSurface(
    p: vec3f, base: vec3f, top: vec3f, base_radius: f32, top_radius: f32,
) -> Surface {
    let size = max(distance(base, top), 1e-20);
    // Turned over, so that around y the angle goes from +x towards +z, as on a sphere.
    let frame = frameAround((base - top) / size);
    let q = (p - base) * frame;
    let height = -q.z;
    let apart = length(q.xy);
    let widening = (top_radius - base_radius) / size;
    let stretch = sqrt(1.0 + widening * widening);
    let depth = (base_radius + widening * height - apart) / stretch;
    let end_depth = min(height, size - height);
    if end_depth < abs(depth) {
        let normal = select(-frame[2], frame[2], height < 0.5 * size);
        return surface(p + end_depth * normal, normal, q.xy);
    }
    let outward = q.xy / max(apart, 1e-20);
    let angle = atan2(outward.y, select(outward.x, 1e-20, abs(outward.x) < 1e-20));
    let uv = vec2f(max(base_radius, top_radius) * angle, stretch * height);
    let normal = frame * vec3f(outward, widening) / stretch;
    return surface(p + depth * normal, normal, uv);
}
