/// A ring: a circle swept around an axis.
/// moves with center
///
/// center = (0, 0, 0): the middle of the hole
/// axis = (0, 1, 0), nonzero: the ring's axis
/// major_radius = 1, 0.00001 to 100000: from the middle to the middle of the tube
/// minor_radius = 0.25, 0.00001 to 100000: of the tube
fn torus(ray: Ray, center: vec3f, axis: vec3f, major_radius: f32, minor_radius: f32) -> f32 {
    // In units of the ball around the ring, along a direction of length 1.
    let size = major_radius + minor_radius;
    let major = major_radius / size;
    let minor = minor_radius / size;
    let unit = size / length(ray.direction);
    let direction = normalize(ray.direction);
    let guess = nearestApproach(ray, center);
    // From afar the guess is off by an ulp of the way. The point may not be: to a grazing ray a hair is much.
    let near = rayPointFrom(ray, guess, center) / size;
    let rest = dot(near, direction);
    let nearest = near - rest * direction;
    let middle = guess - rest * unit;
    // The ball is a hair larger, so that no crossing lies where the search starts or ends.
    let reach = sqrt(max(1.001 - dot(nearest, nearest), 0.0)) * unit;
    let first = max(-reach, ray.t_min - middle) / unit;
    let last = min(reach, ray.t_max - middle) / unit;
    if first >= last {
        return NO_HIT;
    }
    let up = normalize(axis);
    let height = dot(nearest, up);
    let rise = dot(direction, up);
    let across = nearest - height * up;
    let drift = direction - rise * up;
    let p = dot(nearest, nearest) - minor * minor - major * major * (1.0 - 2.0 * rise * rise);
    var turns = torusTurns(p, 2.0 * major * major * height * rise);
    // Between two turns the quartic is monotone: at most one crossing, with a change of sign. The distance
    // keeps the digits that the quartic loses, so it alone is solved, by Newton's method within the bracket.
    var t = first;
    var low = first;
    var high = last;
    var start_side = 0.0;
    var bracketed = false;
    for (var i = 0; i < 40; i++) {
        let y = height + t * rise;
        let radial = across + t * drift;
        let ring = max(length(radial), 1e-20);
        let span = max(length(vec2f(ring - major, y)), 1e-20);
        let gap = span - minor;
        let slope = (dot(radial, drift) * (ring - major) / ring + y * rise) / span;
        if start_side == 0.0 {
            // A ray that starts on the surface goes where it is heading, whatever rounding says.
            start_side = select(-1.0, 1.0, select(gap, slope, abs(gap) < 5e-7) > 0.0);
        } else if gap * start_side < 0.0 {
            high = t;
            bracketed = true;
        } else if t >= last {
            return NO_HIT;
        } else {
            low = t;
        }
        if !bracketed {
            t = clamp(turns.x, t, last);
            turns = vec3f(turns.yz, last);
        } else if abs(gap) < 1e-7 {
            break;
        } else {
            let newton = t - gap / select(slope, 1e-20, abs(slope) < 1e-20);
            t = select(0.5 * (low + high), newton, newton > low && newton < high);
        }
    }
    return onRay(ray, middle + t * unit);
}

/// The real roots of t³ + p t + q, in order: where the quartic t⁴ + 2 p t² + 4 q t + ... turns.
fn torusTurns(p: f32, q: f32) -> vec3f {
    // Newton's steps from beyond all roots lead to the outermost. Cosines would take drivers long to compile.
    var outer = select(3.0, -3.0, q > 0.0);
    var step = outer;
    for (var i = 0; i < 40 && abs(step) > 1e-6; i++) {
        step = (outer * (outer * outer + p) + q) / max(3.0 * outer * outer + p, 1e-12);
        outer -= step;
    }
    let middle = -0.5 * outer;
    let apart = sqrt(max(-3.0 * middle * middle - p, 0.0));
    let inner = vec2f(middle - apart, middle + apart);
    return select(vec3f(outer, inner), vec3f(inner, outer), outer > 0.0);
}

fn torusSurface(p: vec3f, center: vec3f, axis: vec3f, major_radius: f32, minor_radius: f32) -> Surface {
    // Turned over, so that around y the angle goes from +x towards +z, as on a sphere.
    let frame = frameAround(-normalize(axis));
    let q = (p - center) * frame;
    let apart = length(q.xy); // 0 is on a ring without a hole
    let outward = select(q.xy / max(apart, 1e-20), vec2f(1.0, 0.0), apart < 1e-20);
    let tube = normalize(vec2f(apart - major_radius, -q.z));
    let n = frame * vec3f(tube.x * outward, -tube.y);
    let around = atan2(outward.y, select(outward.x, 1e-20, abs(outward.x) < 1e-20));
    let about = atan2(tube.y, select(tube.x, 1e-20, abs(tube.x) < 1e-20));
    let snapped = center + frame * vec3f(major_radius * outward, 0.0) + minor_radius * n;
    return surface(snapped, n, vec2f(major_radius * around, minor_radius * about));
}
