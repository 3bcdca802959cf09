/// Agate: fine bands of stone around warped nodules.
///
/// scale = 0.8, 0.01 to 100: nodules per scene unit
/// bands = 11, 1 to 100: broad bands from the heart of a nodule to its rim
/// warp = 0.25, 0 to 1: how much the bands waver
/// pale = "#efe3d2": color of the light bands
/// warm = "#b9673a": color of the broad bands
/// dark = "#4a2a26": color of the fine lines
fn agate(
    at: Surface, scale: f32, bands: f32, warp: f32, pale: vec3f, warm: vec3f, dark: vec3f,
) -> vec3f {
    var octave = firstOctave(at.position * scale, at.footprint * scale);
    var field = 0.0;
    var lost = 0.0;
    for (var i = 0u; i < 3u; i++) {
        let seen = exp(-0.6 * octave.width * octave.width);
        field += octave.amplitude * seen * (perlinNoise(octave.p) - 0.5);
        lost += octave.amplitude * octave.amplitude * (1.0 - seen * seen);
        octave = nextOctave(octave, 2.2, warp);
    }
    // Waves of unlike length never repeat. What the footprint hides of the field is chance of deviation
    // 0.22 √lost, and the mean of a wave over a normal chance is that wave, fainter.
    let rate = vec3f(0.37, 1.0, 3.3) * bands;
    let phase = rate * field;
    let blur = rate * rate * lost;
    let wave = cos((phase - round(phase)) * 6.2831853) * exp(-0.95 * blur);
    let share = 0.5 + 0.5 * wave;
    let base = mix(pale, warm, 0.3 * share.x + 0.7 * share.y);
    return mix(base, dark, share.z * share.x);
}
