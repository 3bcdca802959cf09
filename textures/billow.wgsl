/// Puffy clouds: round bright heaps of every size with dark creases between them.
///
/// scale = 1, 0.01 to 100: largest heaps per scene unit
/// octaves = 5, 1 to 12: how many layers of ever smaller heaps
/// lacunarity = 2, 1 to 4: how much finer each layer is than the last
/// gain = 0.5, 0 to 1: how strong each layer is beside the last
fn billow(at: Surface, scale: f32, octaves: u32, lacunarity: f32, gain: f32) -> f32 {
    var q = at.position * scale;
    var width = at.footprint * scale;
    var amplitude = 1.0;
    var sum = vec2f(0.0);
    for (var i = 0u; i < clamp(octaves, 1u, 16u); i++) {
        q = OCTAVE_TURN * q + OCTAVE_SHIFT;
        let heap = abs(2.0 * perlinNoise(q) - 1.0);
        // The mean of a heap, and what is left of it in the mean over a box, as measured.
        sum += amplitude * vec2f(mix(0.375, heap, 1.0 / (1.0 + 2.1 * width * width)), 1.0);
        amplitude *= gain;
        width *= lacunarity;
        q *= lacunarity;
    }
    return sum.x / sum.y;
}
