// Rays, surfaces, and the few steps that every shape takes with them.

/// What a shape returns for a ray that it does not meet; every real t is smaller.
const NO_HIT: f32 = 1e30;

/// What is shorter has no direction: raytoy refuses ends that are as near.
const LEAST_SIZE: f32 = 1e-9;

/// The points origin + t·direction with t_min < t < t_max.
/// direction need not have length 1: t counts in it.
struct Ray {
    origin: vec3f,
    t_min: f32,
    direction: vec3f,
    t_max: f32,
}

/// A point of a surface, as a texture sees it.
struct Surface {
    /// In the object's space, scene units.
    position: vec3f,
    /// Outward, length 1, in the object's space: of the smooth surface, where a model stands for one.
    normal: vec3f,
    /// The same of the surface itself, by which inside is told from outside.
    geometric_normal: vec3f,
    /// On the surface, scene units where the surface can be unrolled.
    uv: vec2f,
    /// The same point in world space.
    world: vec3f,
    /// Width of a pixel at the point, in the object's units; 0 when unknown.
    footprint: f32,
    /// The uv of a whole surface, where that has an end: the corner at which a picture that covers it has
    /// its lower left one, and from there the way to the upper right one, in which u is negative where it
    /// grows to the left. Else all is 0.
    whole: vec4f,
    /// How high above the point, along geometric_normal, the smooth surface lies that a model stands for.
    rise: f32,
    /// How far uv goes on one of the object's units there: 1 but on models.
    density: f32,
}

/// What the pixel's rays have cost so far: tests of shapes, boxes and triangles of models, steps of marches.
var<private> work: u32;

/// The surface at `position`, before anything is known of the world and the pixel.
fn surface(position: vec3f, normal: vec3f, uv: vec2f) -> Surface {
    return Surface(position, normal, normal, uv, position, 0.0, vec4f(0.0), 0.0, 1.0);
}

/// `t` where it lies on the ray, else NO_HIT.
fn onRay(ray: Ray, t: f32) -> f32 {
    return select(NO_HIT, t, t > ray.t_min && t < ray.t_max);
}

/// The first of two ordered crossings that lies on the ray: `near` from outside, `far` from inside.
fn firstOnRay(ray: Ray, near: f32, far: f32) -> f32 {
    return onRay(ray, select(far, near, near > ray.t_min));
}

/// The t of the ray's point nearest to `center`. Solve for t from there: a root near zero keeps its digits.
fn nearestApproach(ray: Ray, center: vec3f) -> f32 {
    // The reciprocal is one for all shapes that a ray is asked about.
    return dot(center - ray.origin, ray.direction) * (1.0 / dot(ray.direction, ray.direction));
}

/// A right-handed frame whose columns are two tangents and `axis`, which has length 1
/// (Duff et al., Building an Orthonormal Basis, Revisited, 2017).
fn frameAround(axis: vec3f) -> mat3x3f {
    let s = select(-1.0, 1.0, axis.z >= 0.0);
    let a = -1.0 / (s + axis.z);
    let b = axis.x * axis.y * a;
    return mat3x3f(
        vec3f(1.0 + s * axis.x * axis.x * a, s * b, -s * axis.x),
        vec3f(b, s + axis.y * axis.y * a, -axis.y),
        axis,
    );
}
