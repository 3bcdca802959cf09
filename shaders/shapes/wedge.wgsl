/// A ramp: the half of a box below a diagonal.
/// moves with min, max
/// min differs from max along two axes
///
/// min = (-1, -1, -1): the corner with the smallest coordinates, at the foot of the ramp
/// max = (1, 1, 1): the corner opposite; the ramp rises along x up to it
fn wedge(ray: Ray, min_: vec3f, max_: vec3f) -> f32 {
    let center = 0.5 * (min_ + max_);
    let extent = 0.5 * abs(max_ - min_);
    let middle = nearestApproach(ray, center);
    let nearest = ray.origin - center + middle * ray.direction;
    let d = select(ray.direction, vec3f(1e-20), abs(ray.direction) < vec3f(1e-20));
    let halfway = -nearest / d;
    let reach = abs(extent / d);
    let enter = halfway - reach;
    let leave = halfway + reach;
    // The ramp goes through the middle of the box.
    let up = wedgeNormal(extent);
    let ascent = dot(up, ray.direction);
    let climb = select(ascent, 1e-20, abs(ascent) < 1e-20);
    let ramp = -dot(up, nearest) / climb;
    let ramp_enter = select(ramp, -NO_HIT, climb > 0.0);
    let ramp_leave = select(NO_HIT, ramp, climb > 0.0);
    let near = max(max(enter.x, enter.y), max(enter.z, ramp_enter));
    let far = min(min(leave.x, leave.y), min(leave.z, ramp_leave));
    // Two ulp of slack: no ray slips between a wedge and a box that share a face, as in box.wgsl.
    if near > far + 4e-7 * abs(far) {
        return NO_HIT;
    }
    return firstOnRay(ray, middle + near, middle + far);
}

fn wedgeSurface(p: vec3f, min_: vec3f, max_: vec3f) -> Surface {
    let center = 0.5 * (min_ + max_);
    let extent = 0.5 * abs(max_ - min_);
    let q = p - center;
    let up = wedgeNormal(extent);
    // The face nearest by: the wall, the floor, either end or the ramp.
    let depth = vec4f(extent.x - q.x, extent.y + q.y, extent.z - abs(q.z), -dot(up, q));
    let least = min(min(depth.x, depth.y), min(depth.z, depth.w));
    let end = vec3f(0.0, 0.0, select(-1.0, 1.0, q.z >= 0.0));
    var normal = select(up, end, depth.z <= least);
    normal = select(normal, vec3f(0.0, -1.0, 0.0), depth.y <= least);
    normal = select(normal, vec3f(1.0, 0.0, 0.0), depth.x <= least);
    let snapped = p + least * normal;
    return surface(snapped, normal, snapped * flatTangents(normal));
}

fn wedgeNormal(extent: vec3f) -> vec3f {
    let size = max(length(extent.xy), 1e-20);
    return vec3f(-extent.y, extent.x, 0.0) / size;
}
