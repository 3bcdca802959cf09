/// Parallel swell that rolls along one way, its crests gently bent.
///
/// scale = 2, 0.01 to 100: crests per scene unit
/// direction = (0.6, 0.3, 1), nonzero: the way across the crests
/// warp = 1, 0 to 8: how far the crests stray from straight lines, in wavelengths
/// octaves = 2, 1 to 12: detail in their course
fn waves(at: Surface, scale: f32, direction: vec3f, warp: f32, octaves: u32) -> f32 {
    let p = at.position * scale;
    let width = at.footprint * scale;
    let stray = fractalNoise(p * 0.3, octaves, 2.0, 0.5, 0.3 * width) - 0.5;
    let crest = dot(p, normalize(direction)) + warp * stray;
    // A box as wide as a wave is long leaves nothing of a sine.
    let x = 3.14159265 * clamp(width, 1e-3, 1.0);
    let height = sin(x) / x;
    return 0.5 + 0.5 * height * sin((crest - round(crest)) * 6.2831853);
}
