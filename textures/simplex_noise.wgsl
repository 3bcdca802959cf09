/// Soft random spots without a preferred direction, a little rounder than those of plain noise.
///
/// scale = 1, 0.01 to 100: largest spots per scene unit
/// octaves = 1, 1 to 12: how many layers of detail
/// gain = 0.5, 0 to 1: how strong each layer is beside the last, which is half as fine
fn simplexNoise(at: Surface, scale: f32, octaves: u32, gain: f32) -> f32 {
    var octave = firstOctave(at.position * scale, at.footprint * scale);
    var sum = vec2f(0.0);
    for (var i = 0u; i < clamp(octaves, 1u, 16u); i++) {
        // What is left of an octave in the mean over a box, as measured.
        let seen = 1.0 / (1.0 + 3.2 * octave.width * octave.width * octave.width);
        sum += octave.amplitude * vec2f(seen * simplexNoiseOctave(octave.p), 1.0);
        octave = nextOctave(octave, 2.0, gain);
    }
    return 0.5 + 0.5 * sum.x / sum.y;
}

/// Noise on a lattice of tetrahedra, in -1 to 1 (Perlin, Noise Hardware, 2001;
/// the order of the coordinates as in McEwan et al., Efficient Computational Noise in GLSL, 2012).
fn simplexNoiseOctave(p: vec3f) -> f32 {
    let cell = floor(p + dot(p, vec3f(1.0 / 3.0)));
    let a = p - cell + dot(cell, vec3f(1.0 / 6.0));
    // One comparison is strict, so that equal coordinates too have an order.
    let first = vec3f(vec3<bool>(a.x >= a.y, a.y >= a.z, a.z > a.x));
    let one = min(first, 1.0 - first.zxy);
    let two = max(first, 1.0 - first.zxy);
    let b = a - one + 1.0 / 6.0;
    let c = a - two + 1.0 / 3.0;
    let d = a - 0.5;
    let x = vec4f(a.x, b.x, c.x, d.x);
    let y = vec4f(a.y, b.y, c.y, d.y);
    let z = vec4f(a.z, b.z, c.z, d.z);
    let columns = bitcast<vec4u>(vec4i(cell.x + vec4f(0.0, one.x, two.x, 1.0))) * 0x9e3779b1u;
    let rows = bitcast<vec4u>(vec4i(cell.y + vec4f(0.0, one.y, two.y, 1.0))) * 0x85ebca77u;
    let layers = bitcast<vec4u>(vec4i(cell.z + vec4f(0.0, one.z, two.z, 1.0))) * 0xc2b2ae3du;
    let word = pcg(columns ^ rows ^ layers);
    let slope = tenBits(word, 0u) * x + tenBits(word, 10u) * y + tenBits(word, 20u) * z;
    let near = max(0.5 - x * x - y * y - z * z, vec4f(0.0));
    let spread = 110.0 * dot(near * near * near * near, slope);
    return spread * inverseSqrt(1.0 + spread * spread);
}
