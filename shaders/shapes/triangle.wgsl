/// A triangle, seen from both sides.
/// encloses nothing, so that it cannot be a part of a solid
///
/// a: a corner
/// b: the next corner
/// c: the last corner
fn triangle(ray: Ray, a: vec3f, b: vec3f, c: vec3f) -> f32 {
    // In a frame around the ray the corners are taken one by one, so two triangles that share an
    // edge agree about it and no ray slips through (Woop, Benthin and Wald, Watertight
    // Ray/Triangle Intersection, 2013, which shears where this rotates).
    let frame = frameAround(normalize(ray.direction));
    let p = (a - ray.origin) * frame;
    let q = (b - ray.origin) * frame;
    let r = (c - ray.origin) * frame;
    let weights = vec3f(
        q.x * r.y - q.y * r.x,
        r.x * p.y - r.y * p.x,
        p.x * q.y - p.y * q.x,
    );
    let total = weights.x + weights.y + weights.z;
    if total == 0.0 || any(weights * sign(total) < vec3f()) {
        return NO_HIT;
    }
    let depth = dot(weights / total, vec3f(p.z, q.z, r.z));
    return onRay(ray, depth / length(ray.direction));
}

fn triangleSurface(p: vec3f, a: vec3f, b: vec3f, c: vec3f) -> Surface {
    let across = cross(b - a, c - a);
    let normal = across / max(length(across), 1e-30);
    let u = (b - a) / max(distance(a, b), 1e-20);
    let q = p - a - dot(normal, p - a) * normal;
    return surface(a + q, normal, vec2f(dot(q, u), dot(q, cross(normal, u))));
}
