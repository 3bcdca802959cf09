/// A ball at either end and the cone that touches both.
/// moves with base, top
///
/// base = (0, 0, 0): the middle of one ball
/// top = (0, 1, 0): the middle of the other
/// base_radius = 0.5, 0.00001 to 100000: of the ball at the base
/// top_radius = 0.25, 0 to 100000: of the ball at the top; 0 makes a tip
fn roundedCone(ray: Ray, base: vec3f, top: vec3f, base_radius: f32, top_radius: f32) -> f32 {
    let center = 0.5 * (base + top);
    let half_axis = 0.5 * (top - base);
    let middle = nearestApproach(ray, center);
    let nearest = ray.origin - center + middle * ray.direction;
    // The balls and the cone between the circles where it touches them are convex, and so is their
    // union: a ray comes into it where it comes into the first, and leaves it with the last.
    var span = roundedConeSide(nearest, ray.direction, half_axis, vec2f(base_radius, top_radius));
    let direction2 = dot(ray.direction, ray.direction);
    for (var end = -1.0; end < 2.0; end += 2.0) {
        let radius = select(base_radius, top_radius, end > 0.0);
        let to_ball = end * half_axis - nearest;
        let ball = dot(to_ball, ray.direction) / direction2;
        let miss = to_ball - ball * ray.direction;
        let inside = radius * radius - dot(miss, miss);
        if inside >= 0.0 {
            let reach = sqrt(inside / direction2);
            span = vec2f(min(span.x, ball - reach), max(span.y, ball + reach));
        }
    }
    return select(NO_HIT, firstOnRay(ray, middle + span.x, middle + span.y), span.x <= span.y);
}

/// Where a ray enters the cone between the two circles, and where it leaves: in the wrong order if it misses.
fn roundedConeSide(nearest: vec3f, direction: vec3f, half_axis: vec3f, radii: vec2f) -> vec2f {
    let nowhere = vec2f(NO_HIT, -NO_HIT);
    let size = max(2.0 * length(half_axis), 1e-20);
    let axis = 2.0 * half_axis / size;
    // Of the angle between the side and the axis; 1 or -1 where one ball holds the other.
    let sine = clamp((radii.x - radii.y) / size, -1.0, 1.0);
    let cosine = sqrt((1.0 - sine) * (1.0 + sine));
    let mean = 0.5 * (radii.x + radii.y);
    let rise = dot(direction, axis);
    let climb = select(rise, 1e-20, abs(rise) < 1e-20);
    let halfway = (mean * sine - dot(nearest, axis)) / climb;
    let reach = abs(0.5 * size * cosine * cosine / climb);
    let limit = (size + 4.0 * mean) / length(direction);
    let enter = max(halfway - reach, -limit);
    let leave = min(halfway + reach, limit);
    if enter > leave || cosine == 0.0 {
        return nowhere;
    }
    // Solved as in cone.wgsl, with all that is across seen along the side: times its cosine.
    let height = dot(nearest, axis);
    let across = nearest - height * axis;
    let drift = direction - rise * axis;
    let closest = -dot(across, drift) / max(dot(drift, drift), 1e-24);
    let offset = cosine * (across + closest * drift);
    let start = clamp(closest, enter, leave);
    let speed = cosine * max(length(drift), 1e-12);
    let along = (start - closest) * speed;
    let radius = mean - sine * (height + start * rise);
    let growth = -sine * rise;
    let curvature = (speed - growth) * (speed + growth);
    let offset2 = dot(offset, offset);
    let slant = radius * speed - growth * along;
    let discriminant = slant * slant - curvature * offset2;
    // Along the side a, b and the root are 0 or rounding: the crossings must be far off, not 0 / 0.
    let a = curvature + select(1e-25, -1e-25, curvature < 0.0);
    let b = along * speed - radius * growth;
    let c = offset2 + (along - radius) * (along + radius);
    let root = select(-1.0, 1.0, b >= 0.0) * (sqrt(max(discriminant, 0.0)) + 1e-20);
    let outer = -b - root;
    let is_far = outer * outer >= abs(curvature) * offset2;
    let inner_t = select(root - b, c, is_far) / select(a, outer, is_far);
    let side = start + select(vec2f(inner_t, outer / a), vec2f(outer / a, inner_t), b >= 0.0);
    // A ray steeper than the side crosses it once, and the mirrored cone beyond the tip once.
    let near = select(side.x, enter, a < 0.0 && growth < 0.0);
    let far = select(side.y, leave, a < 0.0 && growth > 0.0);
    let ends = vec2f(max(near, enter), min(far, leave));
    return select(nowhere, ends, ends.x <= ends.y && (discriminant >= 0.0 || a < 0.0));
}

fn roundedConeSurface(p: vec3f, base: vec3f, top: vec3f, base_radius: f32, top_radius: f32) -> Surface {
    let size = max(distance(base, top), 1e-20);
    // Turned over, so that around y the angle goes from +x towards +z, as on a sphere; size 0 is one.
    let frame = frameAround(select((base - top) / size, vec3f(0.0, -1.0, 0.0), size < LEAST_SIZE));
    let q = (p - base) * frame;
    let apart = max(length(q.xy), 1e-20);
    let sine = clamp((base_radius - top_radius) / size, -1.0, 1.0);
    let cosine = sqrt((1.0 - sine) * (1.0 + sine));
    // The surface is that of a ball which rolls along the axis while its radius changes.
    let rolled = clamp((-q.z * cosine - apart * sine) / max(cosine, 1e-20), 0.0, size);
    let end = select(rolled, size, cosine == 0.0 && sine < 0.0);
    let ball = vec3f(q.xy, q.z + end - 1e-12);
    let n = normalize(select(ball, vec3f(cosine / apart * q.xy, -sine), end > 0.0 && end < size));
    let normal = frame * n;
    let angle = atan2(n.y, select(n.x, 1e-20, abs(n.x) < 1e-20));
    // The height goes on over the balls as the length of their meridians.
    let bow = atan2(-n.z, max(length(n.xy), 1e-20));
    let uv = vec2f(max(base_radius, top_radius) * angle, cosine * end + (base_radius - sine * end) * bow);
    return surface(base - end * frame[2] + (base_radius - sine * end) * normal, normal, uv);
}
