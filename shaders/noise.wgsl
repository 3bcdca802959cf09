// What textures share: integer hashes, noise over them, and the box filter of a periodic pattern.
// No hash goes through sin: its digits are the driver's own, and so would the picture be.

/// Keeps the zeros of one octave off the zeros of the next, and floors and walls off the lattice's
/// own planes: the rotation of the quaternion (6, 1, 2, 3), whose entries are short decimals.
const OCTAVE_TURN = mat3x3f(0.48, 0.8, -0.36, -0.64, 0.6, 0.48, 0.6, 0.0, 0.8);
const OCTAVE_SHIFT = vec3f(7.31, -3.57, 5.83);

/// Random bits for the corners of a lattice cell, x before y; `far` lies one up in z.
struct Corners { near: vec4u, far: vec4u }

/// One step of PCG-RXS-M-XS (Jarzynski and Olano, Hash Functions for GPU Rendering, 2020).
fn pcg(v: vec4u) -> vec4u {
    let state = v * 747796405u + 2891336453u;
    let word = ((state >> ((state >> vec4u(28u)) + 4u)) ^ state) * 277803737u;
    return (word >> vec4u(22u)) ^ word;
}

/// `cell` holds whole numbers of either sign; the bitcast keeps the negative ones apart.
fn cellCorners(cell: vec3f) -> Corners {
    let base = bitcast<vec3u>(vec3i(cell));
    let x = vec2u(base.x, base.x + 1u) * 0x9e3779b1u;
    let y = vec2u(base.y, base.y + 1u) * 0x85ebca77u;
    let z = vec2u(base.z, base.z + 1u) * 0xc2b2ae3du;
    let column = x.xyxy ^ y.xxyy;
    return Corners(pcg(column ^ z.xxxx), pcg(column ^ z.yyyy));
}

/// Ten bits of each word as numbers in -1 to 1: one hash is worth three of them.
fn tenBits(word: vec4u, shift: u32) -> vec4f {
    return vec4f((word >> vec4u(shift)) & vec4u(1023u)) / 511.5 - 1.0;
}

fn cornerMix(near: vec4f, far: vec4f, f: vec3f) -> f32 {
    // Perlin, Improving Noise, 2002: no jump in the second derivative, so none in a bump.
    let share = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    let row = mix(near, far, share.z);
    let pair = mix(row.xy, row.zw, share.y);
    return mix(pair.x, pair.y, share.x);
}

/// Gradient noise in 0 to 1, mean 0.5, about one feature per unit.
fn perlinNoise(p: vec3f) -> f32 {
    let f = p - floor(p);
    let g = f - 1.0;
    let c = cellCorners(floor(p));
    let x = vec4f(f.x, g.x, f.x, g.x);
    let y = vec4f(f.y, f.y, g.y, g.y);
    let near = tenBits(c.near, 0u) * x + tenBits(c.near, 10u) * y + tenBits(c.near, 20u) * f.z;
    let far = tenBits(c.far, 0u) * x + tenBits(c.far, 10u) * y + tenBits(c.far, 20u) * g.z;
    // Gradient noise seldom leaves the middle of its range: spread it, without ever clipping.
    let spread = 3.0 * cornerMix(near, far, f);
    return 0.5 + 0.5 * spread * inverseSqrt(1.0 + spread * spread);
}

/// Three independent smooth noises in -1 to 1, mean 0: a displacement.
fn vectorNoise(p: vec3f) -> vec3f {
    let f = p - floor(p);
    let c = cellCorners(floor(p));
    return vec3f(
        cornerMix(tenBits(c.near, 0u), tenBits(c.far, 0u), f),
        cornerMix(tenBits(c.near, 10u), tenBits(c.far, 10u), f),
        cornerMix(tenBits(c.near, 20u), tenBits(c.far, 20u), f),
    );
}

/// `b` where `which` is true, else `a`: select, which GLSL ES 3.00 has only for numbers with a fraction.
fn chosenBits(a: vec4u, b: vec4u, which: vec4<bool>) -> vec4u {
    return a ^ ((a ^ b) & (vec4u(0u) - vec4u(which)));
}

/// How much of the interval of `width` around x has fract(x) < duty, in closed form.
fn dutyShare(x: vec2f, width: vec2f, duty: f32) -> vec2f {
    let f = x - floor(x);
    let a = f - 0.5 * width;
    let b = f + 0.5 * width;
    let w = max(width, vec2f(1e-20));
    let ends = min(b - floor(b), vec2f(duty)) - min(a - floor(a), vec2f(duty));
    let wide = ((floor(b) - floor(a)) * duty + ends) / w;
    // The integrals' difference loses its digits as the width shrinks; the way to an edge does not.
    let inside = f < vec2f(duty);
    let edge = select(max(duty - f, f - 1.0), min(f, duty - f), inside);
    let narrow = clamp(0.5 + edge / w, vec2f(0.0), vec2f(1.0));
    let soft = select(wide, narrow, width < vec2f(min(duty, 1.0 - duty)));
    return select(soft, vec2f(inside), width == vec2f(0.0));
}
