/// A box along the axes whose edges and corners are rounded off.
/// moves with min, max
/// min differs from max along two axes
///
/// min = (-1, -1, -1): the corner with the smallest coordinates, before rounding
/// max = (1, 1, 1): the corner opposite
/// radius = 0.1, 0 to 100000: of the edges; at most half the shortest side
fn roundedBox(ray: Ray, min_: vec3f, max_: vec3f, radius: f32) -> f32 {
    let center = 0.5 * (min_ + max_);
    let extent = 0.5 * abs(max_ - min_);
    let rounding = roundedBoxRadius(extent, radius);
    let middle = nearestApproach(ray, center);
    let nearest = ray.origin - center + middle * ray.direction;
    let d = select(ray.direction, vec3f(1e-20), abs(ray.direction) < vec3f(1e-20));
    let halfway = -nearest / d;
    let reach = abs(extent / d);
    let enter = halfway - reach;
    let leave = halfway + reach;
    let near = max(enter.x, max(enter.y, enter.z));
    let far = min(leave.x, min(leave.y, leave.z));
    if near > far || middle + near >= ray.t_max || middle + far <= ray.t_min {
        return NO_HIT;
    }
    // Along a ray the distance to a convex solid is convex. So Newton's method, started outside,
    // never steps over the surface, and a slope away from it means a miss. The crossing sought is
    // the one ahead of `near`, else the one behind `far`.
    let enough = 1e-7 * (extent.x + extent.y + extent.z);
    var t = near;
    var heading = 1.0;
    for (var i = 0; i < 48; i++) {
        let p = nearest + t * d;
        let beyond = max(abs(p) - (extent - rounding), vec3f());
        let gap = length(beyond) - rounding;
        if gap > enough {
            let slope = dot(sign(p) * beyond, d) / (gap + rounding);
            if slope * heading > -1e-12 {
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

fn roundedBoxSurface(p: vec3f, min_: vec3f, max_: vec3f, radius: f32) -> Surface {
    let center = 0.5 * (min_ + max_);
    let extent = 0.5 * abs(max_ - min_);
    let rounding = roundedBoxRadius(extent, radius);
    let q = p - center;
    let depth = abs(q) - extent;
    // What the outermost coordinate gains decides only where a radius of 0 leaves nothing else.
    let outermost = depth >= vec3f(max(depth.x, max(depth.y, depth.z)));
    let beyond = max(depth + rounding, vec3f()) + select(vec3f(), vec3f(1e-12), outermost);
    let outward = select(vec3f(-1.0), vec3f(1.0), q >= vec3f());
    let normal = outward * normalize(beyond);
    let core = clamp(q, rounding - extent, extent - rounding);
    let snapped = center + core + rounding * normal;
    let along_y = beyond.y >= max(beyond.x, beyond.z);
    let uv = select(snapped.xy, snapped.zy, beyond.x > beyond.z);
    return surface(snapped, normal, select(uv, snapped.xz, along_y));
}

fn roundedBoxRadius(extent: vec3f, radius: f32) -> f32 {
    return min(radius, min(extent.x, min(extent.y, extent.z)));
}
