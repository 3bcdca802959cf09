// Surfaces in the world.

/// A point of an object: its own view of it, and the world's.
struct Placed {
    at: Surface,
    /// Outward, length 1, in world space: what light sees, and what tells inside from outside.
    normal: vec3f,
    geometric_normal: vec3f,
    /// Object units to a unit of the world, about.
    scale: f32,
    /// From the point that was asked for to the surface, along `geometric_normal`.
    gap: f32,
    /// From there to the smooth surface that light sees.
    rise: f32,
}

/// A surface at `p` of an object that stands in the world as its shape describes it.
fn placed(at: Surface, p: vec3f) -> Placed {
    let gap = dot(at.position - p, at.geometric_normal);
    return Placed(at, at.normal, at.geometric_normal, 1.0, gap, at.rise);
}
