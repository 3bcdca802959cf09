/// A fractal with buds on its buds: the Mandelbrot set's rule, on directions of space.
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
        let polar = power * acos(clamp(z.y / max(r, 1e-9), -1.0, 1.0));
        let turn = power * atan2(z.x, z.z + select(0.0, 1e-9, z.x == 0.0 && z.z == 0.0));
        let grown = pow(max(r, 1e-6), power - 1.0);
        slope = power * grown * slope + 1.0;
        let a = polar - 6.2831853 * round(polar / 6.2831853);
        let b = turn - 6.2831853 * round(turn / 6.2831853);
        z = grown * r * vec3f(sin(a) * sin(b), cos(a), sin(a) * cos(b)) + c;
        r = length(z);
    }
    return 0.5 * log(max(r, 1e-9)) * r / slope * unit;
}

fn mandelbulbBounds(center: vec3f, size: f32, power: f32, iterations: u32) -> Bounds {
    return Bounds(center - size, center + size);
}
