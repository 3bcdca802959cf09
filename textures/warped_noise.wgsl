/// Smoke drawn out into folds and streams, in three colors.
///
/// scale = 0.7, 0.01 to 100: largest features per scene unit
/// octaves = 4, 1 to 12: how many layers of detail
/// warp = 1, 0 to 4: how far the folds are drawn out
/// deep = "#2c3e4f": color of the hollows
/// middle = "#a8623f": color of the streams between
/// light = "#e8dcc3": color of the crests
fn warpedNoise(
    at: Surface, scale: f32, octaves: u32, warp: f32, deep: vec3f, middle: vec3f, light: vec3f,
) -> vec3f {
    let p = at.position * scale;
    // Noise moves the point of noise that moves the point of noise (Quilez, Domain Warping, 2002).
    var stir = vec3f(0.0);
    var before = vec3f(0.0);
    for (var i = 0u; i < 3u; i++) {
        before = stir;
        // The last noise is drawn out finer than it is by itself.
        let width = at.footprint * scale * (1.0 + 0.4 * f32(i) * warp * warp);
        stir = warpedNoiseLayers(p + warp * stir + f32(i) * OCTAVE_SHIFT, octaves, width);
    }
    let color = mix(deep, middle, clamp(0.5 + before.x, 0.0, 1.0));
    return mix(color, light, smoothstep(-0.5, 0.7, stir.x));
}

fn warpedNoiseLayers(p: vec3f, octaves: u32, footprint: f32) -> vec3f {
    var octave = firstOctave(p, footprint);
    var sum = vec4f(0.0);
    for (var i = 0u; i < clamp(octaves, 1u, 16u); i++) {
        // What is left of an octave in the mean over a box, as measured.
        let seen = 1.0 / (1.0 + octave.width * octave.width * (0.25 + 0.08 * octave.width));
        sum += octave.amplitude * vec4f(seen * vectorNoise(octave.p), 1.0);
        octave = nextOctave(octave, 2.0, 0.5);
    }
    return sum.xyz / sum.w;
}
