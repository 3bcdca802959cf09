// Solids made of solids: where a ray goes into them and out of them.

/// The most times that a ray goes into or out of the parts of one solid.
const MAX_CROSSINGS: u32 = 64u;

/// Where a ray goes through a surface.
struct Crossing {
    t: f32,
    object: u32,
    /// Whether the ray is inside until then.
    leaves: bool,
}

fn crossing(ray: Ray, t: f32, object: u32, normal: vec3f) -> Crossing {
    work++;
    return Crossing(t, object, t < NO_HIT && dot(normal, ray.direction) > 0.0);
}

/// A crossing that no ray has been asked for yet: before all others.
fn notAsked() -> Crossing {
    return Crossing(-NO_HIT, NO_OBJECT, false);
}

/// A point of the ray by which a solid without end tells that the rest of the ray is inside.
fn pointBeyond(ray: Ray) -> vec3f {
    return ray.origin + (max(ray.t_min, 0.0) + 1.0) * ray.direction;
}

fn pointAt(ray: Ray, t: f32) -> vec3f {
    return ray.origin + select(0.0, t, t < NO_HIT) * ray.direction;
}

/// Up to where crossings are the same as the one at `t`: else a hole that ends in a face leaves a film on it.
fn sameUpTo(ray: Ray, t: f32) -> f32 {
    return t + abs(t) * SAME_PLACE + slackOf(ray);
}

fn nearerCrossing(hit: Hit, crossing: Crossing) -> Hit {
    return nearer(hit, crossing.t, crossing.object);
}

/// A surface seen from behind: that of a solid where another one is cut away.
fn inverted(at: Surface) -> Surface {
    var behind = at;
    behind.normal = -at.normal;
    behind.geometric_normal = -at.geometric_normal;
    behind.rise = 0.0;
    return behind;
}
