/// A triangle, seen from both sides.
/// encloses nothing, so that it cannot be a part of a solid
/// moves with a, b, c
/// no line holds a, b, c
///
/// a: a corner
/// b: the next corner
/// c: the last corner
fn triangle(ray: Ray, a: vec3f, b: vec3f, c: vec3f) -> f32 {
    let unit = 1.0 / length(ray.direction);
    return crossedTriangle(ray, frameAround(ray.direction * unit), unit, a, b, c);
}

fn triangleSurface(p: vec3f, a: vec3f, b: vec3f, c: vec3f) -> Surface {
    let across = cross(b - a, c - a);
    let normal = across / max(length(across), 1e-30);
    let u = (b - a) / max(distance(a, b), 1e-20);
    let q = p - a - dot(normal, p - a) * normal;
    return surface(a + q, normal, vec2f(dot(q, u), dot(q, cross(normal, u))));
}
