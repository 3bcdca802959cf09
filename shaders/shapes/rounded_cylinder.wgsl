/// A cylinder whose two rims are rounded off.
/// moves with base, top
/// base differs from top
///
/// base = (0, 0, 0): the middle of one end
/// top = (0, 1, 0): the middle of the other
/// radius = 1, 0.00001 to 100000: of the cylinder
/// rounding = 0.1, 0 to 100000: radius of the rims; at most that of the cylinder and half its height
fn roundedCylinder(ray: Ray, base: vec3f, top: vec3f, radius: f32, rounding: f32) -> f32 {
    let center = 0.5 * (base + top);
    let size = distance(base, top);
    if size < LEAST_SIZE {
        return NO_HIT;
    }
    let axis = (top - base) / size;
    let middle = nearestApproach(ray, center);
    let nearest = ray.origin - center + middle * ray.direction;
    let height = dot(nearest, axis);
    let rise = dot(ray.direction, axis);
    let across = nearest - height * axis;
    let drift = ray.direction - rise * axis;
    let drift2 = max(dot(drift, drift), 1e-24);
    let closest = -dot(across, drift) / drift2;
    let offset = across + closest * drift;
    let inside = radius * radius - dot(offset, offset);
    if inside < 0.0 {
        return NO_HIT;
    }
    let side_reach = sqrt(inside / drift2);
    let climb = select(rise, 1e-20, abs(rise) < 1e-20);
    let halfway = -height / climb;
    let reach = abs(0.5 * size / climb);
    let near = max(closest - side_reach, halfway - reach);
    let far = min(closest + side_reach, halfway + reach);
    if near > far || middle + near >= ray.t_max || middle + far <= ray.t_min {
        return NO_HIT;
    }
    // As in rounded_box.wgsl: along a ray the distance to a convex solid is convex, so Newton's
    // method never steps over the surface, and a tangent that stays outside means a miss.
    let bevel = roundedCylinderBevel(size, radius, rounding);
    let core = vec2f(radius, 0.5 * size) - bevel;
    let enough = 2e-7 * (radius + size);
    var t = near;
    var heading = 1.0;
    for (var i = 0; i < 48; i++) {
        let level = height + t * rise;
        let radial = across + t * drift;
        let apart = length(radial);
        let beyond = max(vec2f(apart, abs(level)) - core, vec2f());
        let gap = length(beyond) - bevel;
        if gap > enough {
            let outward = vec2f(dot(radial, drift) / max(apart, 1e-20), sign(level) * rise);
            let slope = dot(beyond, outward) / (gap + bevel);
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

fn roundedCylinderSurface(p: vec3f, base: vec3f, top: vec3f, radius: f32, rounding: f32) -> Surface {
    let size = distance(base, top);
    // Turned over, so that around y the angle goes from +x towards +z, as on a sphere.
    let frame = frameAround((base - top) / max(size, 1e-20));
    let center = 0.5 * (base + top);
    let q = (p - center) * frame;
    let level = -q.z;
    let apart = length(q.xy);
    let bevel = roundedCylinderBevel(size, radius, rounding);
    let depth = vec2f(apart - radius, abs(level) - 0.5 * size);
    // What the outermost gains decides only where a rounding of 0 leaves nothing else.
    let outermost = depth >= vec2f(max(depth.x, depth.y));
    let beyond = normalize(max(depth + bevel, vec2f()) + select(vec2f(), vec2f(1e-12), outermost));
    let outward = select(q.xy / max(apart, 1e-20), vec2f(1.0, 0.0), apart < 1e-20);
    let up = select(-beyond.y, beyond.y, level >= 0.0);
    let normal = frame * vec3f(beyond.x * outward, -up);
    let ring = min(apart, radius - bevel);
    let end = clamp(level, bevel - 0.5 * size, 0.5 * size - bevel);
    let snapped = center + frame * vec3f(ring * outward, -end) + bevel * normal;
    let angle = atan2(outward.y, select(outward.x, 1e-20, abs(outward.x) < 1e-20));
    // The height goes on over the rims as the length of their arc, until they are an end's.
    let side = vec2f(radius * angle, end + 0.5 * size + bevel * atan2(up, max(beyond.x, 1e-20)));
    return surface(snapped, normal, select(side, q.xy, beyond.y > beyond.x));
}

fn roundedCylinderBevel(size: f32, radius: f32, rounding: f32) -> f32 {
    return min(rounding, min(radius, 0.5 * size));
}
