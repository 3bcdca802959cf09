// Moved objects: the ray goes into the object's space, its surface comes back.

/// The affine map from the world into an object's space, by rows.
struct Space {
    x: vec4f,
    y: vec4f,
    z: vec4f,
}

fn pointInto(space: Space, p: vec3f) -> vec3f {
    let q = vec4f(p, 1.0);
    return vec3f(dot(space.x, q), dot(space.y, q), dot(space.z, q));
}

/// The same ray in an object's space. Its t is the world's, so its direction changes length.
fn rayInto(space: Space, ray: Ray) -> Ray {
    let d = vec4f(ray.direction, 0.0);
    let direction = vec3f(dot(space.x, d), dot(space.y, d), dot(space.z, d));
    return Ray(pointInto(space, ray.origin), ray.t_min, direction, ray.t_max);
}

/// A surface of a moved object. A normal goes back by the transpose of the map that points come by.
fn placedFrom(space: Space, at: Surface, world: vec3f) -> Placed {
    let to_world = mat3x3f(space.x.xyz, space.y.xyz, space.z.xyz);
    let volume = abs(dot(space.x.xyz, cross(space.y.xyz, space.z.xyz)));
    var seen = at;
    seen.world = world;
    let normal = normalize(to_world * at.normal);
    let geometric = to_world * at.geometric_normal;
    let unit = 1.0 / length(geometric);
    let gap = dot(at.position - pointInto(space, world), at.geometric_normal) * unit;
    return Placed(seen, normal, geometric * unit, pow(volume, 1.0 / 3.0), gap, at.rise * unit);
}
