// Boxes along the axes.

/// The t at which a ray's line enters the box between two corners, and leaves it: in the wrong order if it
/// misses.
fn spanInBounds(ray: Ray, low: vec3f, high: vec3f) -> vec2f {
    let tiny = vec3f(1e-20);
    let d = select(ray.direction, tiny, abs(ray.direction) < tiny);
    let a = (low - ray.origin) / d;
    let b = (high - ray.origin) / d;
    let near = min(a, b);
    let far = max(a, b);
    return vec2f(max(max(near.x, near.y), near.z), min(min(far.x, far.y), far.z));
}

/// Whether a ray comes through the box between two corners.
fn meetsBounds(ray: Ray, low: vec3f, high: vec3f) -> bool {
    let span = spanInBounds(ray, low, high);
    // Two units in the last place close the gaps that rounding leaves (Ize, Robust BVH Ray Traversal, 2013).
    return max(span.x, ray.t_min) <= min(1.0000004 * span.y, ray.t_max);
}
