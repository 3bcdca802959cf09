/// A parallelogram, seen from both sides.
/// encloses nothing, so that it cannot be a part of a solid
/// moves with corner
/// u is not along v
///
/// corner: the corner where both sides start
/// u: one side, from the corner
/// v: the other side, from the corner
fn quad(ray: Ray, corner: vec3f, u: vec3f, v: vec3f) -> f32 {
    let across = cross(u, v);
    let approach = dot(across, ray.direction);
    if abs(approach) < 1e-20 {
        return NO_HIT;
    }
    let middle = nearestApproach(ray, corner);
    let nearest = ray.origin - corner + middle * ray.direction;
    let t = -dot(across, nearest) / approach;
    let share = quadShare(nearest + t * ray.direction, u, v);
    // A millionth beyond the edge still counts: no ray slips between quads that share it.
    let within = all(abs(share - 0.5) < vec2f(0.500001));
    return select(NO_HIT, onRay(ray, middle + t), within);
}

fn quadSurface(p: vec3f, corner: vec3f, u: vec3f, v: vec3f) -> Surface {
    let across = cross(u, v);
    let normal = across / max(length(across), 1e-30);
    let q = p - corner - dot(normal, p - corner) * normal;
    return surface(corner + q, normal, quadShare(q, u, v) * vec2f(length(u), length(v)));
}

/// How far along u and along v the point q of their plane lies; the sides' ends are at 1.
fn quadShare(q: vec3f, u: vec3f, v: vec3f) -> vec2f {
    let across = cross(u, v);
    let area2 = max(dot(across, across), 1e-36);
    return vec2f(dot(cross(q, v), across), dot(cross(u, q), across)) / area2;
}
