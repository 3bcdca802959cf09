/// Sharp bright ridges that branch into ever finer ones, like mountains seen from above.
///
/// scale = 0.8, 0.01 to 100: largest ridges per scene unit
/// octaves = 6, 1 to 12: how many layers of ever finer ridges
/// lacunarity = 2.1, 1 to 4: how much finer each layer is than the last
/// gain = 0.65, 0 to 1: how strong each layer is beside the last
/// sharpness = 1.2, 0.1 to 8: how quickly detail spreads from the ridges into the valleys
fn ridged(
    at: Surface, scale: f32, octaves: u32, lacunarity: f32, gain: f32, sharpness: f32,
) -> f32 {
    var octave = firstOctave(at.position * scale, at.footprint * scale);
    var weight = 1.0;
    var sum = vec2f(0.0);
    // Ridged multifractal (Musgrave in Ebert et al., Texturing and Modeling, 1994): each layer is
    // weighted by the one before, so valleys stay smooth.
    for (var i = 0u; i < clamp(octaves, 1u, 16u); i++) {
        let crest = 1.0 - abs(2.0 * perlinNoise(octave.p) - 1.0);
        // The mean of a crest, and what is left of it in the mean over a box, as measured.
        let height = weight * mix(0.44, crest * crest, 1.0 / (1.0 + 2.6 * octave.width * octave.width));
        sum += octave.amplitude * vec2f(height, 1.0);
        weight = clamp(sharpness * height, 0.0, 1.0);
        octave = nextOctave(octave, lacunarity, gain);
    }
    return sum.x / sum.y;
}
