/// Soft random colors that drift into each other.
///
/// scale = 1, 0.01 to 100: patches of color per scene unit
/// octaves = 2, 1 to 12: layers of ever finer patches
/// contrast = 0.9, 0 to 4: how far the colors stray from the middle
/// low = "#4a6d8f": red, green and blue at their lowest
/// high = "#efd3b0": red, green and blue at their highest
fn colorNoise(
    at: Surface, scale: f32, octaves: u32, contrast: f32, low: vec3f, high: vec3f,
) -> vec3f {
    var q = at.position * scale;
    var width = at.footprint * scale;
    var amplitude = 0.7;
    var channels = vec3f(0.5);
    for (var i = 0u; i < clamp(octaves, 1u, 12u); i++) {
        q = OCTAVE_TURN * q + OCTAVE_SHIFT;
        channels += amplitude * exp(-0.35 * width * width) * contrast * vectorNoise(q);
        amplitude *= 0.5;
        width *= 2.0;
        q *= 2.0;
    }
    return mix(low, high, smoothstep(vec3f(0.0), vec3f(1.0), channels));
}
