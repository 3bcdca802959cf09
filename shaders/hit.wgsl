// Where a ray meets the scene first.

/// Where a ray meets the scene, and which object.
struct Hit {
    t: f32,
    object: u32,
    /// What the rounding of the ray's origin may do to a t.
    slack: f32,
}

/// No object: the ray leaves the scene.
const NO_OBJECT: u32 = 0xffffffffu;

/// Crossings closer than this share of what they are made of are at one place: rounding must not choose.
const SAME_PLACE: f32 = 4e-6;

/// What the rounding of the origin of `ray` may do to a t.
fn slackOf(ray: Ray) -> f32 {
    let origin = abs(ray.origin);
    let direction = abs(ray.direction);
    let size = max(max(origin.x, origin.y), origin.z);
    return SAME_PLACE * size / max(max(direction.x, direction.y), direction.z);
}

fn noHit(ray: Ray) -> Hit {
    return Hit(ray.t_max, NO_OBJECT, slackOf(ray));
}

/// The nearer of `hit` and a crossing of `object` at `t`. Where two surfaces coincide, the first object of
/// the scene has it, or they would be speckled.
fn nearer(hit: Hit, t: f32, object: u32) -> Hit {
    work++;
    if t < hit.t * (1.0 - SAME_PLACE) - hit.slack {
        return Hit(t, object, hit.slack);
    }
    return hit;
}
