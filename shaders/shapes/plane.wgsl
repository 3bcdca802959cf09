/// A plane without end: the points p with dot(normal, p) = offset.
///
/// normal = (0, 1, 0), nonzero: the way the plane faces; any length
/// offset = 0: distance from the origin, where the normal has length 1
fn plane(ray: Ray, normal: vec3f, offset: f32) -> f32 {
    let approach = dot(normal, ray.direction);
    if abs(approach) < 1e-20 {
        return NO_HIT;
    }
    return onRay(ray, (offset - dot(normal, ray.origin)) / approach);
}

fn planeSurface(p: vec3f, normal: vec3f, offset: f32) -> Surface {
    let size = length(normal);
    let n = normal / size;
    // A pattern in space would flicker where the plane runs along one of its borders, as y = 0
    // often does, if rounding left the point on either side.
    let snapped = p - (dot(n, p) - offset / size) * n;
    return surface(snapped, n, snapped * flatTangents(n));
}

fn planeContains(p: vec3f, normal: vec3f, offset: f32) -> bool {
    return dot(normal, p) < offset;
}
