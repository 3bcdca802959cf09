// A pixel: its ray, and what that sees.

/// What a pixel sees: its light, and what its first ray met.
struct Seen {
    radiance: vec3f,
    /// Along the first ray, scene units; negative where it leaves the scene.
    depth: f32,
    /// What a debug view shows of the first surface.
    value: vec3f,
    object: u32,
    /// Depth of the deepest ray.
    bounces: u32,
}

/// What this sample sees of the pixel with its middle at `pixel`, which counts from the top left corner.
fn seenAt(pixel: vec2f) -> Seen {
    let place = (2.0 * (pixel + frame.jitter) / frame.resolution - 1.0)
        * vec2f(frame.resolution.x / frame.resolution.y, -1.0);
    let direction = normalize(frame.forward + place.x * frame.right + place.y * frame.up);
    let at = vec2u(pixel);
    seed = hashed(at.x + hashed(at.y + hashed(frame.sample)));
    return traceTree(frame.eye, direction);
}
