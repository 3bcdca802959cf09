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
    let noise = vectorOctaves(at.position * scale, clamp(octaves, 1u, 12u), vec3f(0.5), at.footprint * scale);
    let channels = 0.5 + 0.7 * contrast * noise.field;
    return mix(low, high, smoothstep(vec3f(0.0), vec3f(1.0), channels));
}
