// Shapes that give a distance: rays march to them (Hart, Sphere Tracing, 1996).

/// The most distances that a ray asks for.
const MARCH_STEPS: u32 = 192u;

/// The least step, as a share of the shape's size. What is thinner may be missed at a grazing angle.
const LEAST_STEP: f32 = 2e-4;

/// A box that holds all of a shape.
struct Bounds {
    low: vec3f,
    high: vec3f,
}

/// The search along a ray for the first change of a distance's sign.
struct March {
    /// Where the distance is wanted next.
    t: f32,
    end: f32,
    least: f32,
    /// t to a unit of length.
    pace: f32,
    /// The last t on the side where the ray started, the first on the other, and the distances there.
    low: f32,
    high: f32,
    low_distance: f32,
    high_distance: f32,
    /// 1 outside, -1 inside, 0 before the first distance.
    side: f32,
    crosses: bool,
}

fn marchFrom(ray: Ray, bounds: Bounds) -> March {
    let size = length(bounds.high - bounds.low);
    // A little more than the box, so that a ray starts outside.
    let margin = vec3f(1e-3 * size);
    let span = spanInBounds(ray, bounds.low - margin, bounds.high + margin);
    let pace = 1.0 / length(ray.direction);
    let least = LEAST_STEP * size * pace;
    // A ray that starts on the surface is over it when it is asked first.
    let t = max(span.x, ray.t_min + least);
    let end = min(span.y, ray.t_max);
    return March(t, end, least, pace, t, t, 0.0, 0.0, 0.0, false);
}

/// Takes the distance at `march.t`; whether another one is wanted.
fn marches(march: ptr<function, March>, distance: f32) -> bool {
    work++;
    let t = (*march).t;
    if (*march).side == 0.0 {
        (*march).side = select(-1.0, 1.0, distance >= 0.0);
    }
    let ahead = distance * (*march).side;
    if ahead > 0.0 {
        (*march).low = t;
        (*march).low_distance = ahead;
    } else {
        (*march).crosses = true;
        (*march).high = t;
        (*march).high_distance = ahead;
    }
    if !(*march).crosses {
        (*march).t = t + max(ahead * (*march).pace, (*march).least);
        return (*march).t < (*march).end;
    }
    let span = (*march).high - (*march).low;
    let share = (*march).low_distance / max((*march).low_distance - (*march).high_distance, 1e-20);
    (*march).t = (*march).low + clamp(share, 0.1, 0.9) * span;
    return span > 1e-3 * (*march).least + 2e-7 * abs((*march).high);
}

/// Where the march ended.
fn marched(ray: Ray, march: March) -> f32 {
    return onRay(ray, select(NO_HIT, march.t, march.crosses));
}

/// Corner `i` of a tetrahedron: four distances there give a normal (Quilez, Normals for an SDF, 2015).
fn tetrahedronCorner(i: u32) -> vec3f {
    return vec3f(select(-1.0, 1.0, i == 0u || i == 3u), select(-1.0, 1.0, i == 1u || i == 3u),
        select(-1.0, 1.0, i == 2u || i == 3u));
}

/// How far from a point its normal looks around.
fn normalStep(bounds: Bounds) -> f32 {
    return 3e-4 * length(bounds.high - bounds.low);
}
