// Triangles of a surface that lets no ray slip through between them.

/// Where `ray` crosses the triangle a b c. The columns of `frame` are a frame around the ray, whose direction
/// is 1 / `unit` long.
///
/// In the frame the corners are taken one by one, and the ray is its third axis (Woop, Benthin and Wald,
/// Watertight Ray/Triangle Intersection, 2013, which shears where this rotates). On which side of an edge it
/// passes is told by two products, and rounding never says that the lesser is the greater. So triangles that
/// share an edge agree about it, and a ray through the edge itself meets both. The products must not be
/// subtracted first: drivers fuse that with one of them.
fn crossedTriangle(ray: Ray, frame: mat3x3f, unit: f32, a: vec3f, b: vec3f, c: vec3f) -> f32 {
    let p = (a - ray.origin) * frame;
    let q = (b - ray.origin) * frame;
    let r = (c - ray.origin) * frame;
    let left = vec3f(q.x * r.y, r.x * p.y, p.x * q.y);
    let right = vec3f(q.y * r.x, r.y * p.x, p.y * q.x);
    if any(left < right) && any(left > right) {
        return NO_HIT;
    }
    let weights = abs(left - right);
    let total = weights.x + weights.y + weights.z;
    if total == 0.0 {
        return NO_HIT;
    }
    return onRay(ray, dot(weights / total, vec3f(p.z, q.z, r.z)) * unit);
}
