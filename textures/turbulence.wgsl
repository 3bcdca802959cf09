/// Stirs a texture: pushes every point a random but smooth way.
///
/// amount = 0.3, 0 to 4: how far points move, in scene units; uv moves by the first two components
/// scale = 1, 0.01 to 100: eddies per scene unit
/// octaves = 4, 1 to 12: how many layers of ever smaller eddies
fn turbulence(at: Surface, amount: f32, scale: f32, octaves: u32) -> Surface {
    var octave = firstOctave(at.position * scale, at.footprint * scale);
    var push = vec3f(0.0);
    var steepness = 0.0;
    var blur = 0.0;
    for (var i = 0u; i < clamp(octaves, 1u, 16u); i++) {
        let seen = 1.0 - smoothstep(0.25, 1.0, octave.width);
        let reach = amount * octave.amplitude;
        push += reach * seen * vectorNoise(octave.p);
        steepness += seen * seen;
        blur += reach * reach * (1.0 - seen) * (1.0 - seen);
        octave = nextOctave(octave, 2.0, 0.5);
    }
    var moved = at;
    moved.position += push;
    moved.uv += push.xy;
    // 0.58 is the mean square of vectorNoise's slope, the same for each octave: what the eddies draw
    // out. Those too small to see leave a blur, as a box that has their variance: 12 times 0.16.
    let slope = amount * scale;
    let stretch = 1.0 + 0.58 * slope * slope * steepness;
    moved.footprint = sqrt(at.footprint * at.footprint * stretch + 1.92 * blur);
    return moved;
}
