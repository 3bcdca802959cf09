/// The skins of an onion: thin shells around a center, each shaded from its inside out.
///
/// scale = 3, 0.01 to 100: shells per scene unit
/// center = (0, 0, 0): what the shells lie around, in scene units
/// warp = 0.3, 0 to 2: how far they stray from spheres, in shells
fn onion(at: Surface, scale: f32, center: vec3f, warp: f32) -> f32 {
    let p = (at.position - center) * scale;
    let width = clamp(at.footprint * scale, 1e-20, 16.0);
    let x = length(p) + 2.0 * warp * (fractalNoise(p * 0.3, 2u, 2.0, 0.5, 0.3 * width) - 0.5);
    // The mean of fract over the width is that of x less that of floor, which is a sum of steps.
    let f = x - floor(x);
    let ends = vec2f(f - 0.5 * width, f + 0.5 * width);
    let steps = floor(ends) * (ends - 0.5 * floor(ends) - 0.5);
    return clamp(f - (steps.y - steps.x) / width, 0.0, 1.0);
}
