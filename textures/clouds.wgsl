/// White clouds adrift on a blue sky.
///
/// scale = 0.8, 0.01 to 100: clouds per scene unit
/// octaves = 5, 1 to 12: layers of ever finer wisps
/// coverage = 0.5, 0.01 to 0.99: share of the sky that is clouded
/// softness = 0.5, 0 to 1: how gently a cloud thins out
/// sky = "#5d88c9": color between the clouds
/// cloud = "#fbfaf7": color of thin clouds
/// shade = "#c3ccd8": color of thick ones
fn clouds(
    at: Surface, scale: f32, octaves: u32, coverage: f32, softness: f32,
    sky: vec3f, cloud: vec3f, shade: vec3f,
) -> vec3f {
    var octave = firstOctave(at.position * scale, at.footprint * scale);
    var field = 0.0;
    var whole = 0.0;
    var lost = 0.0;
    for (var i = 0u; i < clamp(octaves, 1u, 12u); i++) {
        let seen = exp(-0.6 * octave.width * octave.width);
        field += octave.amplitude * seen * (perlinNoise(octave.p) - 0.5);
        let variance = 0.0484 * octave.amplitude * octave.amplitude;
        whole += variance;
        lost += variance * (1.0 - seen * seen);
        octave = nextOctave(octave, 2.0, 0.5);
    }
    // The level that a given share of the noise exceeds, were it normal (its quantile, by the logistic).
    let above = field - 0.55 * sqrt(whole) * log(1.0 / clamp(coverage, 0.01, 0.99) - 1.0);
    // What the footprint hides of the noise is chance: it softens an edge by its deviation.
    let edge = vec2f(0.4 * softness + 1e-3, 0.3);
    let soft = sqrt(edge * edge + 5.0 * lost);
    let share = smoothstep(-soft, soft, vec2f(above, above - 0.25));
    // A sum, not a mix in a mix: the two shares are not independent, and only sums can be averaged apart.
    return sky + (cloud - sky) * share.x + (shade - cloud) * share.y;
}
