/// Round dots of one size in straight or staggered rows.
///
/// scale = 2, 0.01 to 100: dots per scene unit
/// radius = 0.3, 0 to 0.5: radius of a dot, as a share of the way to the next
/// softness = 0, 0 to 1: how much of the radius its edge takes to fade
/// arrangement = staggered of square, staggered: whether every other row is half a dot ahead
/// color = "#b5483a": color of the dots
/// ground = "#efe6d5": color between them
fn dots(
    at: Surface, scale: f32, radius: f32, softness: f32, arrangement: u32, color: vec3f, ground: vec3f,
) -> vec3f {
    let p = at.uv * scale;
    let width = at.density * at.footprint * scale;
    // Rows of equilateral triangles: all neighbors of a staggered dot are equally far.
    let staggered = arrangement == 1u;
    let height = select(1.0, 0.8660254, staggered);
    let coarse = width / max(radius, 1e-6);
    var discs = 0.0;
    if coarse < 1.9 {
        let n = footprintParts(coarse, 3.0);
        let part = width / f32(n);
        // The variances of the soft edge and of the footprint add.
        let fade = softness * radius;
        let edge = max(sqrt(fade * fade + part * part), 1e-20);
        for (var i = 0u; i < n * n; i++) {
            let q = p + footprintPart(i, n, width);
            let away = dotsDistance(q, height, staggered);
            discs += saturate(0.5 + (radius - 0.5 * fade - away) / edge) / f32(n * n);
        }
    }
    // Where the footprint hides its shape, a dot is the square of its area, which filters exactly.
    let side = radius * sqrt(3.14159265 * (1.0 - softness + softness * softness / 3.0));
    let across = dutyShare(vec2f(p.x, p.x - 0.5) + 0.5 * side, vec2f(width), side);
    let period = 2.0 * height;
    let up = dutyShare(
        (vec2f(p.y, p.y - height) + 0.5 * side) / period, vec2f(width / period), side / period);
    let squares = across.x * up.x + select(across.x, across.y, staggered) * up.y;
    let share = mix(discs, squares, smoothstep(1.3, 1.9, coarse));
    return ground * (1.0 - share) + color * share;
}

/// The way to the nearest center of a dot.
fn dotsDistance(p: vec2f, height: f32, staggered: bool) -> f32 {
    let period = vec2f(1.0, select(height, 2.0 * height, staggered));
    let near = p - period * round(p / period);
    let ahead = p - 0.5 * period;
    let other = ahead - period * round(ahead / period);
    return select(length(near), min(length(near), length(other)), staggered);
}
