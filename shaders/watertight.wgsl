// Triangles of a surface that lets no ray slip through between them.

/// Where `ray` crosses the triangle a b c. The columns of `frame` are a frame around the ray, whose direction
/// is 1 / `unit` long.
///
/// In the frame the corners are taken one by one, so two triangles that share an edge agree about it (Woop,
/// Benthin and Wald, Watertight Ray/Triangle Intersection, 2013, which shears where this rotates).
fn crossedTriangle(ray: Ray, frame: mat3x3f, unit: f32, a: vec3f, b: vec3f, c: vec3f) -> f32 {
    let p = (a - ray.origin) * frame;
    let q = (b - ray.origin) * frame;
    let r = (c - ray.origin) * frame;
    let weights = vec3f(edgeSide(q.xy, r.xy), edgeSide(r.xy, p.xy), edgeSide(p.xy, q.xy));
    let total = weights.x + weights.y + weights.z;
    if total == 0.0 || any(weights * sign(total) < vec3f()) {
        return NO_HIT;
    }
    return onRay(ray, dot(weights / total, vec3f(p.z, q.z, r.z)) * unit);
}

/// Twice the cross product of two corners: on which side of their edge the ray passes. Swapped, they give the
/// opposite to the last bit, also where a driver fuses a product and a sum.
fn edgeSide(q: vec2f, r: vec2f) -> f32 {
    let across = q - r;
    let sum = q + r;
    return across.x * sum.y - across.y * sum.x;
}
