/// A ball whose outlines are anything from nearly square through round to a diamond.
/// moves with center
///
/// center = (0, 0, 0): the middle
/// radii = (1, 1, 1), 0.00001 to 100000: from the middle to the surface along x, y and z
/// east_west = 0.4, 0.2 to 2: the outline from above; towards 0 a square, 1 round, 2 a diamond
/// north_south = 0.4, 0.2 to 2: the outlines from the side, likewise
fn superellipsoid(
    ray: Ray, center: vec3f, radii: vec3f, east_west: f32, north_south: f32,
) -> f32 {
    let approach = nearestApproach(ray, center);
    let far_off = (ray.origin - center + approach * ray.direction) / radii;
    let d = ray.direction / radii;
    // The nearest approach again, now to a solid within -1..1.
    let closest = -dot(far_off, d) / dot(d, d);
    let middle = approach + closest;
    let nearest = far_off + closest * d;
    let away = select(d, vec3f(1e-20), abs(d) < vec3f(1e-20));
    let halfway = -nearest / away;
    let reach = abs(1.0 / away);
    let enter = halfway - reach;
    let leave = halfway + reach;
    let near = max(enter.x, max(enter.y, enter.z));
    let far = min(leave.x, min(leave.y, leave.z));
    if near > far || middle + near >= ray.t_max || middle + far <= ray.t_min {
        return NO_HIT;
    }
    // With exponents up to 2 the gauge is a norm, so it is convex along a ray: Newton's method,
    // started outside, never steps over the surface, and a tangent that stays outside means a miss.
    var t = near;
    var heading = 1.0;
    for (var i = 0; i < 48; i++) {
        let gauge = superellipsoidGauge(nearest + t * d, east_west, north_south);
        let gap = gauge.w - 1.0;
        if gap > 5e-7 {
            let slope = dot(gauge.xyz, d);
            let remaining = select(t - near, far - t, heading > 0.0);
            if gap + slope * heading * remaining > 0.0 {
                return NO_HIT;
            }
            t -= gap / slope;
        } else {
            let hit = onRay(ray, middle + t);
            if hit < NO_HIT || heading < 0.0 {
                return hit;
            }
            heading = -1.0;
            t = far;
        }
    }
    return NO_HIT;
}

/// The gradient and, in w, the factor by which the solid must grow to have p on its surface: the
/// inside-outside function of Barr, Superquadrics and Angle-Preserving Transformations, 1981, as a norm.
fn superellipsoidGauge(p: vec3f, east_west: f32, north_south: f32) -> vec4f {
    let level = superellipsoidNorm(abs(p.xz), 2.0 / east_west);
    let whole = superellipsoidNorm(vec2f(level.x, abs(p.y)), 2.0 / north_south);
    let slope = vec3f(whole.y * level.y, whole.z, whole.y * level.z);
    return vec4f(sign(p) * slope, whole.x);
}

/// (x^power + y^power)^(1/power) and its derivatives by x and y, neither of which is negative.
fn superellipsoidNorm(v: vec2f, power: f32) -> vec3f {
    let most = max(max(v.x, v.y), 1e-20);
    let share = max(min(v.x, v.y) / most, 1e-20);
    let rest = pow(share, power);
    let stretch = pow(1.0 + rest, 1.0 / power);
    let slope = vec2f(1.0, rest / share) * stretch / (1.0 + rest);
    return vec3f(most * stretch, select(slope.yx, slope, v.x >= v.y));
}

fn superellipsoidSurface(
    p: vec3f, center: vec3f, radii: vec3f, east_west: f32, north_south: f32,
) -> Surface {
    let q = (p - center) / radii;
    let gauge = superellipsoidGauge(q, east_west, north_south);
    let at = q / gauge.w;
    let longitude = atan2(at.z, select(at.x, 1e-20, abs(at.x) < 1e-20));
    let latitude = atan2(at.y, max(length(at.xz), 1e-20));
    let uv = vec2f(0.5 * (radii.x + radii.z) * longitude, radii.y * latitude);
    return surface(center + radii * at, normalize(gauge.xyz / radii), uv);
}
