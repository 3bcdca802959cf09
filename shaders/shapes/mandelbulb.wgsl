/// A fractal with buds on its buds: the Mandelbrot set's rule, on directions of space.
/// moves with center
///
/// center = (0, 0, 0): the middle
/// size = 1, 0.00001 to 100000: about its radius
/// power = 8, 2 to 16: how many buds go around
/// iterations = 5, 1 to 16: how fine the buds get
///
/// has a rough surface
fn mandelbulbDistance(p: vec3f, center: vec3f, size: f32, power: f32, iterations: u32) -> f32 {
    // White and Nylander's power of a point; the distance is Hubbard and Douady's potential over its slope.
    let unit = 0.8 * size;
    let c = (p - center) / unit;
    var z = c;
    var slope = 1.0;
    var r = length(z);
    for (var i = 0u; i < min(iterations, 16u) && r < 2.0; i++) {
        let across = length(z.xz);
        let polar = mandelbulbPower(vec2f(z.y, across), power);
        let turn = mandelbulbPower(select(vec2f(1.0, 0.0), z.zx / across, across > 0.0), power);
        slope = power * length(polar) / max(r, 1e-9) * slope + 1.0;
        z = vec3f(polar.y * turn.y, polar.x, polar.y * turn.x) + c;
        r = length(z);
    }
    return 0.5 * log(max(r, 1e-9)) * r / slope * unit;
}

fn mandelbulbBounds(center: vec3f, size: f32, power: f32, iterations: u32) -> Bounds {
    return Bounds(center - size, center + size);
}

/// A complex number to a power. By squares: drivers' sines differ in their last digits, and each round of
/// buds multiplies that.
fn mandelbulbPower(number: vec2f, power: f32) -> vec2f {
    let part = fract(power);
    var result = vec2f(1.0, 0.0);
    if part > 0.0 {
        let angle = part * atan2(number.y, number.x + select(0.0, 1e-9, all(number == vec2f(0.0))));
        result = pow(max(length(number), 1e-9), part) * vec2f(cos(angle), sin(angle));
    }
    var square = number;
    for (var bits = u32(min(power, 31.0)); bits > 0u; bits >>= 1u) {
        if (bits & 1u) == 1u {
            result = vec2f(dot(result * square, vec2f(1.0, -1.0)), dot(result, square.yx));
        }
        square = vec2f(dot(square * square, vec2f(1.0, -1.0)), 2.0 * square.x * square.y);
    }
    return result;
}
