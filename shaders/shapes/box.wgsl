/// A box along the axes.
/// moves with min, max
/// min differs from max along two axes
///
/// min = (-1, -1, -1): the corner with the smallest coordinates
/// max = (1, 1, 1): the corner opposite
fn box(ray: Ray, min_: vec3f, max_: vec3f) -> f32 {
    let center = 0.5 * (min_ + max_);
    let middle = nearestApproach(ray, center);
    let nearest = ray.origin - center + middle * ray.direction;
    let d = select(ray.direction, vec3f(1e-20), abs(ray.direction) < vec3f(1e-20));
    let inverse = 1.0 / d;
    let halfway = -nearest * inverse;
    let reach = abs(0.5 * (max_ - min_) * inverse);
    let enter = halfway - reach;
    let leave = halfway + reach;
    let near = max(enter.x, max(enter.y, enter.z));
    let far = min(leave.x, min(leave.y, leave.z));
    // Two ulp of slack: no ray slips between boxes that share a face
    // (Ize, Robust BVH Ray Traversal, 2013).
    if near > far + 4e-7 * abs(far) {
        return NO_HIT;
    }
    return firstOnRay(ray, middle + near, middle + far);
}

fn boxSurface(p: vec3f, min_: vec3f, max_: vec3f) -> Surface {
    let center = 0.5 * (min_ + max_);
    let extent = 0.5 * abs(max_ - min_);
    let q = p - center;
    // The face nearest by, not the largest share of the extent: that mistakes the faces of a thin
    // box near its edges.
    let depth = extent - abs(q);
    let along_y = depth.y <= min(depth.x, depth.z);
    let along_x = !along_y && depth.x <= depth.z;
    let face = vec3<bool>(along_x, along_y, !along_x && !along_y);
    let outward = select(vec3f(-1.0), vec3f(1.0), q >= vec3f());
    let snapped = select(p, center + outward * extent, face);
    let uv = select(snapped.xy, snapped.zy, along_x);
    return surface(snapped, select(vec3f(), outward, face), select(uv, snapped.xz, along_y));
}
