/// Puffy clouds: round bright heaps of every size with dark creases between them.
///
/// scale = 1, 0.01 to 100: largest heaps per scene unit
/// octaves = 5, 1 to 12: how many layers of ever smaller heaps
/// lacunarity = 2, 1 to 4: how much finer each layer is than the last
/// gain = 0.5, 0 to 1: how strong each layer is beside the last
fn billow(at: Surface, scale: f32, octaves: u32, lacunarity: f32, gain: f32) -> f32 {
    var octave = firstOctave(at.position * scale, at.footprint * scale);
    var sum = vec2f(0.0);
    for (var i = 0u; i < clamp(octaves, 1u, 16u); i++) {
        let heap = abs(2.0 * perlinNoise(octave.p) - 1.0);
        // The mean of a heap, and what is left of it in the mean over a box, as measured.
        let seen = 1.0 / (1.0 + 2.1 * octave.width * octave.width);
        sum += octave.amplitude * vec2f(mix(0.375, heap, seen), 1.0);
        octave = nextOctave(octave, lacunarity, gain);
    }
    return sum.x / sum.y;
}
