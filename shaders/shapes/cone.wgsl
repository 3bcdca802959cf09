/// A cone, whole or cut off, closed by two discs.
///
/// base = (0, 0, 0): the middle of one disc
/// top = (0, 1, 0): the middle of the other, or the tip
/// base_radius = 1, 0.00001 to 100000: of the disc at the base
/// top_radius = 0, 0 to 100000: of the disc at the top; 0 makes a tip
fn cone(ray: Ray, base: vec3f, top: vec3f, base_radius: f32, top_radius: f32) -> f32 {
    let center = 0.5 * (base + top);
    let size = max(distance(base, top), 1e-20);
    let axis = (top - base) / size;
    let middle = nearestApproach(ray, center);
    let nearest = ray.origin - center + middle * ray.direction;
    let height = dot(nearest, axis);
    let rise = dot(ray.direction, axis);
    let across = nearest - height * axis;
    let drift = ray.direction - rise * axis;
    let widening = (top_radius - base_radius) / size;
    let radius = 0.5 * (base_radius + top_radius) + widening * height;
    let growth = widening * rise;

    // |across + t drift| = radius + t growth, squared: a t² + 2 b t + c = 0. The discriminant is
    // Lagrange's identity with one negative square: b² - a c would cancel.
    let c = dot(across, across) - radius * radius;
    let b = dot(across, drift) - radius * growth;
    let curvature = dot(drift, drift) - growth * growth;
    let a = select(curvature, 1e-20, abs(curvature) < 1e-20);
    let slant = radius * drift - growth * across;
    let swirl = cross(across, drift);
    let discriminant = dot(slant, slant) - dot(swirl, swirl) - (a - curvature) * c;
    if discriminant < 0.0 && a > 0.0 {
        return NO_HIT;
    }
    let root = select(-1.0, 1.0, b >= 0.0) * sqrt(max(discriminant, 0.0));
    // c / outer keeps its digits where the outer root is far off, as along a generator; where both
    // are close, c is what has lost them.
    let outer = -b - root;
    let is_far = outer * outer > abs(a) * (dot(across, across) + radius * radius);
    let inner_t = select(root - b, c, is_far) / select(a, outer, is_far);
    let side = select(vec2f(inner_t, outer / a), vec2f(outer / a, inner_t), b >= 0.0);
    // A ray steeper than the side crosses it once, and the mirrored cone beyond the tip once.
    let steep = a < 0.0;
    let side_near = select(side.x, -NO_HIT, steep && growth < 0.0);
    let side_far = select(side.y, NO_HIT, steep && growth > 0.0);

    let climb = select(rise, 1e-20, abs(rise) < 1e-20);
    let halfway = -height / climb;
    let reach = abs(0.5 * size / climb);
    let near = max(side_near, halfway - reach);
    let far = min(side_far, halfway + reach);
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
    if min(height, size - height) * stretch < abs(base_radius + widening * height - apart) {
        return surface(p, select(-frame[2], frame[2], height < 0.5 * size), q.xy);
    }
    let outward = q.xy / max(apart, 1e-20);
    let angle = atan2(outward.y, select(outward.x, 1e-20, abs(outward.x) < 1e-20));
    let uv = vec2f(max(base_radius, top_radius) * angle, stretch * height);
    return surface(p, normalize(frame * vec3f(outward, widening)), uv);
}
