/// Even bands along a direction or over any pattern: smooth, pointed, hard or arched ones.
///
/// frequency = 2, 0.01 to 100: bands for each 1 that `along` and `of` grow, taken together
/// along = (1, 0, 0): growth per scene unit of x, y and z; (0, 0, 0) bands the pattern alone
/// of = 0, -10 to 10: the pattern that is banded; in the distance it has to smooth itself
/// phase = 0, -1 to 1: shift of all bands, in bands
/// shape = sine of sine, triangle, square, saw, scallop: profile of a band; scallop is an arch
fn wave(at: Surface, frequency: f32, along: vec3f, of_: f32, phase: f32, shape: u32) -> f32 {
    let x = frequency * (of_ + dot(at.position, along)) + phase;
    let f = x - floor(x);
    let width = at.footprint * frequency * length(along);
    // A small difference of the integrals has few digits left.
    if width < 2.5e-4 {
        return waveProfile(f, shape);
    }
    // Whole bands leave nothing but their mean, so wider is not needed.
    let w = min(width, 16.0);
    let ends = waveIntegral(vec2f(f - 0.5 * w, f + 0.5 * w), shape);
    return clamp((ends.y - ends.x) / w, 0.0, 1.0);
}

fn waveProfile(f: f32, shape: u32) -> f32 {
    switch shape {
        case 1u: { return 1.0 - abs(2.0 * f - 1.0); }
        case 2u: { return select(0.0, 1.0, f < 0.5); }
        case 3u: { return min(f, 1.0); }
        case 4u: { return sin(3.14159265 * f); }
        default: { return 0.5 + 0.5 * cos(6.2831853 * (f - 0.5)); }
    }
}

/// The area under the profile from 0 to x.
fn waveIntegral(x: vec2f, shape: u32) -> vec2f {
    let n = floor(x);
    let f = x - n;
    let c = f - 0.5;
    switch shape {
        case 1u: { return 0.5 * n + 0.25 + c - c * abs(c); }
        case 2u: { return 0.5 * n + min(f, vec2f(0.5)); }
        case 3u: { return 0.5 * n + 0.5 * f * f; }
        case 4u: { return (2.0 * n + 1.0 - cos(3.14159265 * f)) / 3.14159265; }
        default: { return 0.5 * x + sin(6.2831853 * c) / 12.566371; }
    }
}
