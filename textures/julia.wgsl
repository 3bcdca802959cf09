/// A Julia set: filigree between the points that run off to infinity and those that stay.
///
/// c = (0.285, 0.01): the constant of the set, a point near the rim of the Mandelbrot set
/// center = (0, 0): the point of the complex plane at uv = (0, 0)
/// zoom = 2, 0.01 to 10000: scene units per unit of the complex plane
/// iterations = 120, 1 to 200: steps after which a point counts as inside
/// bands = 0.06, 0.01 to 2: turns through the three colors per step
/// first = "#e9e2d3": color far outside
/// second = "#3f7d86": color after it
/// third = "#2a1f3d": color after that one, before the first again
/// interior = "#120d16": color of the set
fn julia(
    at: Surface, c: vec2f, center: vec2f, zoom: f32, iterations: u32, bands: f32,
    first: vec3f, second: vec3f, third: vec3f, interior: vec3f,
) -> vec3f {
    var z = center + at.uv / zoom;
    let width = at.density * at.footprint / zoom;
    var slope = vec2f(1.0, 0.0);
    var steps = 0.0;
    for (var i = 0u; i < min(iterations, 200u) && dot(z, z) < 1e4; i++) {
        // Beyond 1e12 no pixel resolves anything, and the next steps would leave the range of f32.
        if dot(slope, slope) < 1e24 {
            slope = 2.0 * vec2f(z.x * slope.x - z.y * slope.y, z.x * slope.y + z.y * slope.x);
        }
        z = vec2f(z.x * z.x - z.y * z.y, 2.0 * z.x * z.y) + c;
        steps += 1.0;
    }
    let escaped = dot(z, z) >= 1e4;
    let size = max(length(z), 100.0);
    // The potential's logarithm counts steps without jumps, and its gradient is the reciprocal of the
    // distance estimate (Peitgen and Saupe, The Science of Fractal Images, 1988).
    let distance_ = size * log(size) / max(length(slope), 1e-6);
    let phase = max(steps - log2(log(size)), 0.0) * bands;
    let blur = width * bands / (0.693 * distance_);
    let color = juliaWheel(phase, blur, first, second, third);
    // Where the slope grows without the point running off, the set is dust finer than the pixel.
    let dust = smoothstep(0.0, 1.0, width / distance_);
    let inside = mix(interior, (first + second + third) / 3.0, max(dust, smoothstep(0.5, 2.0, width)));
    return select(inside, color, escaped);
}

/// A wheel of three colors, without corners (the Fejér kernel of order 3), averaged over `blur` turns.
fn juliaWheel(turn: f32, blur: f32, first: vec3f, second: vec3f, third: vec3f) -> vec3f {
    let t = vec3f(turn) - vec3f(0.0, 0.3333333, 0.6666667);
    let wave = cos((t - round(t)) * 6.2831853);
    let seen = exp(vec2f(-1.645, -6.58) * blur * blur);
    let weight = (1.0 + 1.3333333 * seen.x * wave + 0.6666667 * seen.y * (2.0 * wave * wave - 1.0)) / 3.0;
    return first * weight.x + second * weight.y + third * weight.z;
}
