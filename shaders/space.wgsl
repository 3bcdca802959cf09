// Moved objects: the ray goes into the object's space, its surface comes back.

/// The affine map from the world into an object's space, by rows.
struct Space {
    x: vec4f,
    y: vec4f,
    z: vec4f,
}

/// A point of an object: its own view of it, and the world's.
struct Placed {
    at: Surface,
    /// Outward, length 1, in world space: what light sees, and what tells inside from outside.
    normal: vec3f,
    geometric_normal: vec3f,
    /// Object units to a unit of the world, about.
    scale: f32,
    /// From the point that was asked for to the surface, along `geometric_normal`.
    gap: f32,
    /// From there to the smooth surface that light sees.
    rise: f32,
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

/// A surface at `p` of an object that stands in the world as its shape describes it.
fn placed(at: Surface, p: vec3f) -> Placed {
    let gap = dot(at.position - p, at.geometric_normal);
    return Placed(at, at.normal, at.geometric_normal, 1.0, gap, at.rise);
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

/// The point of the unit sphere in `direction`, which is where a background is asked for its color.
fn skyPoint(direction: vec3f) -> Surface {
    let uv = vec2f(atan2(direction.z, direction.x), asin(clamp(direction.y, -1.0, 1.0)));
    var at = surface(direction, direction, uv);
    at.whole = 1.5707963 * vec4f(-2.0, -1.0, 4.0, 2.0);
    return at;
}

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
