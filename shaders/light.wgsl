// Lights as one point of the scene sees them.

/// A light's centre from a point, and the area around it.
struct Light {
    /// From the point to the light's centre; length 1 where the light is infinitely far.
    to: vec3f,
    /// The t along `to` at which the light stands.
    reach: f32,
    /// What arrives where nothing is in the way: color · intensity · falloff.
    arriving: vec3f,
    /// Radius of a round light, which shows its disk; negative for a parallelogram.
    radius: f32,
    /// Half the sides of a parallelogram.
    u: vec3f,
    v: vec3f,
}

/// A ball of light, or a point where radius is 0.
fn pointLight(p: vec3f, position: vec3f, radius: f32, color: vec3f) -> Light {
    return Light(position - p, 1.0, color, radius, vec3f(0.0), vec3f(0.0));
}

/// The share of `light` that reaches `origin`.
fn visibleShare(light: Light, origin: vec3f) -> f32 {
    let rays = frame.shadow_samples + zero;
    let n = select(rays, min(rays, 1u), light.radius == 0.0);
    if n == 0u {
        return 1.0;
    }
    let round = light.radius >= 0.0;
    let facing = frameAround(normalize(light.to));
    let u = select(light.u, light.radius * facing[0], round);
    let v = select(light.v, light.radius * facing[1], round);
    // Another turn of the points in each pixel. Its angles are not quite even, which nobody sees.
    let turn = vec2f(f32(seed & 0xffffu), f32(seed >> 16u)) / 65536.0;
    var spoke = normalize(turn - 0.5 + 1e-6);
    // Each ray asks them all, or stops at one; to count that would cost too much.
    work += n * frame.casters;
    var open = 0.0;
    for (var i = 0u; i < n; i++) {
        // A sunflower's seeds on the disk (Vogel, 1979), the R2 sequence on the parallelogram
        // (Roberts, The Unreasonable Effectiveness of Quasirandom Sequences, 2018).
        spoke = -0.73736888 * spoke + 0.67549029 * vec2f(-spoke.y, spoke.x);
        let disk = sqrt((f32(i) + turn.x) / f32(n)) * spoke;
        let square = 2.0 * fract(turn + f32(i) * vec2f(0.7548776662, 0.5698402910)) - 1.0;
        let on = select(square, disk, round);
        let ray = Ray(origin, 0.0, light.to + on.x * u + on.y * v, light.reach);
        open += select(1.0, 0.0, sceneBlocks(ray));
    }
    return open / f32(n);
}
