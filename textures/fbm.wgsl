/// Cloudy noise with detail at every size: finer and fainter octaves laid over each other.
///
/// scale = 1, 0.01 to 100: largest features per scene unit
/// octaves = 5, 1 to 12: how many layers of detail
/// lacunarity = 2, 1 to 4: how much finer each layer is than the last
/// gain = 0.5, 0 to 1: how strong each layer is beside the last
fn fbm(at: Surface, scale: f32, octaves: u32, lacunarity: f32, gain: f32) -> f32 {
    return fractalNoise(at.position * scale, octaves, lacunarity, gain, at.footprint * scale);
}
