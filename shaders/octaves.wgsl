// Noise over noise: octaves, each finer and fainter than the last.

/// One layer of noise: where to ask for it, how wide the footprint is there, and how much it counts.
struct Octave {
    p: vec3f,
    width: f32,
    amplitude: f32,
}

fn firstOctave(p: vec3f, footprint: f32) -> Octave {
    return Octave(OCTAVE_TURN * p + OCTAVE_SHIFT, footprint, 1.0);
}

fn nextOctave(last: Octave, lacunarity: f32, gain: f32) -> Octave {
    let p = OCTAVE_TURN * (lacunarity * last.p) + OCTAVE_SHIFT;
    return Octave(p, lacunarity * last.width, gain * last.amplitude);
}

/// Octaves of noise in 0 to 1, mean 0.5; those too fine for the footprint fade to their mean.
fn fractalNoise(p: vec3f, octaves: u32, lacunarity: f32, gain: f32, footprint: f32) -> f32 {
    var octave = firstOctave(p, footprint);
    var sum = vec2f(0.0);
    for (var i = 0u; i < clamp(octaves, 1u, 16u); i++) {
        // About what a box as wide as the footprint leaves of this noise.
        let seen = 1.0 / (1.0 + 0.7 * octave.width * octave.width * octave.width);
        sum += octave.amplitude * vec2f(seen * (perlinNoise(octave.p) - 0.5), 1.0);
        octave = nextOctave(octave, lacunarity, gain);
    }
    return 0.5 + sum.x / sum.y;
}

/// Octaves of three independent noises, mean 0, and their variances.
struct VectorOctaves {
    /// As much of the noises as the footprint leaves.
    field: vec3f,
    whole: vec3f,
    /// The part of `whole` that the footprint hides: there the field is chance.
    lost: vec3f,
}

/// Each octave is twice as fine as the last and `gain` times as strong.
fn vectorOctaves(p: vec3f, octaves: u32, gain: vec3f, footprint: f32) -> VectorOctaves {
    var octave = firstOctave(p, footprint);
    var amplitude = vec3f(1.0);
    var sum = VectorOctaves(vec3f(0.0), vec3f(0.0), vec3f(0.0));
    for (var i = 0u; i < octaves; i++) {
        let blur = 0.35 * octave.width * octave.width;
        let seen = exp(-blur);
        sum.field += amplitude * seen * vectorNoise(octave.p);
        // vectorNoise has a deviation of 0.4.
        let variance = 0.16 * amplitude * amplitude;
        sum.whole += variance;
        // For next to no width, 1 - seen² is the rounding of the exponential, and its root would show.
        sum.lost += variance * select(1.0 - seen * seen, 2.0 * blur * (1.0 - blur), blur < 1e-3);
        amplitude *= gain;
        octave = nextOctave(octave, 2.0, 1.0);
    }
    return sum;
}
