// Where a ray meets a surface, from near and far.

/// How far beside the surface a point may lie, as a share of its way from the world's origin.
const MAX_SLIP: f32 = 1e-6;

/// The bits of a number that its first twelve digits are in.
const HIGH_HALF: u32 = 0xfffff000u;

/// The ray's point at `t`.
fn rayPoint(ray: Ray, t: f32) -> vec3f {
    return rayPointFrom(ray, t, vec3f(0.0));
}

/// The same as seen from `center`. Far from the ray's origin the product needs more digits than a number has.
/// So the factors are cut in halves, whose products are exact (after Dekker, A Floating-Point Technique,
/// 1971). With fma it would be one line, but Mesa's software driver rounds twice there too.
fn rayPointFrom(ray: Ray, t: f32, center: vec3f) -> vec3f {
    let t_high = bitcast<f32>(bitcast<u32>(t) & HIGH_HALF);
    let t_low = t - t_high;
    let high = bitcast<vec3f>(bitcast<vec3u>(ray.direction) & vec3u(HIGH_HALF));
    let low = ray.direction - high;
    let way = t_high * high;
    // What is left of two large numbers is exact, so the two that leave less come first.
    let there = ray.origin + way;
    let apart = ray.origin - center;
    let point = select(there - center, apart + way, abs(apart) < abs(there));
    return point + t_low * high + t_high * low + t_low * low;
}

/// The way along `ray` from its point at `t` to the surface `there`, which was asked for at that point: a
/// step of Newton's method. From far away t itself has too few digits for it.
fn slipAlong(ray: Ray, t: f32, there: Placed) -> vec3f {
    let approach = dot(there.geometric_normal, ray.direction);
    let slip = there.gap / select(approach, 1e-20, abs(approach) < 1e-20);
    // More than its rounding it cannot be; what is more comes of a surface seen edge on.
    let most = 4e-6 * t;
    return clamp(slip, -most, most) * ray.direction;
}
