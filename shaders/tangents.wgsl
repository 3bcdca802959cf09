// Directions along a plane.

/// The directions of u and v on a flat surface. Along y: x and z. Along x: z and y. Along z: x and y.
/// Tilted: these, laid into the surface.
fn flatTangents(n: vec3f) -> mat2x3f {
    let a = abs(n);
    let level = a.y >= max(a.x, a.z);
    let first = select(vec3f(1.0, 0.0, 0.0), vec3f(0.0, 0.0, 1.0), !level && a.x > a.z);
    let second = select(vec3f(0.0, 1.0, 0.0), vec3f(0.0, 0.0, 1.0), level);
    let u = normalize(first - dot(first, n) * n);
    let v = cross(n, u);
    return mat2x3f(u, select(v, -v, dot(v, second) < 0.0));
}
