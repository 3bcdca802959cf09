// Numbers as colors.

/// What `signedColor` ends in.
const BELOW: vec3f = vec3f(0.08, 0.28, 0.72);
const ABOVE: vec3f = vec3f(0.75, 0.12, 0.1);

/// A color for each number, far from its neighbours' in hue (steps of the golden angle).
fn falseColor(index: u32) -> vec3f {
    let hue = fract(f32(index) * 0.61803399 + 0.05) * 6.0;
    let wheel = clamp(abs(vec3f(hue) - vec3f(3.0, 2.0, 4.0)) * vec3f(1.0, -1.0, -1.0)
        + vec3f(-1.0, 2.0, 2.0), vec3f(0.0), vec3f(1.0));
    return mix(vec3f(0.35), wheel, 0.75);
}

/// A color for a number from 0 to 1, brighter for more: a quarter each to violet, red, orange, pale yellow.
fn heatColor(x: f32) -> vec3f {
    let quarters = clamp(vec4f(4.0 * x) - vec4f(0.0, 1.0, 2.0, 3.0), vec4f(0.0), vec4f(1.0));
    var color = vec3f(0.34, 0.06, 0.43) * quarters.x;
    color = mix(color, vec3f(0.73, 0.21, 0.33), quarters.y);
    color = mix(color, vec3f(0.98, 0.56, 0.04), quarters.z);
    return mix(color, vec3f(0.99, 1.0, 0.64), quarters.w);
}

/// `x` from -1 to 1, and what is beyond in the colors of these; `slope` is by how much it changes from pixel
/// to pixel. A dark line lies at each tenth, a black one at 0.
fn signedColor(x: f32, slope: f32) -> vec3f {
    let color = mix(vec3f(1.0), select(BELOW, ABOVE, x > 0.0), min(abs(x), 1.0));
    let tenths = 10.0 * x;
    let away = abs(fract(tenths + 0.5) - 0.5);
    let line = 0.4 * lineShare(away, 10.0 * slope);
    return color * (1.0 - max(line, lineShare(abs(x), slope)));
}

/// How much of a pixel the line covers that is `away` from it, where `slope` is one pixel: lines are a pixel
/// and a half wide. They fade where they come too close to each other, and there are none where all is level.
fn lineShare(away: f32, slope: f32) -> f32 {
    if slope < 1e-4 {
        return 0.0;
    }
    return clamp(1.25 - away / slope, 0.0, 1.0) * clamp(2.0 - 8.0 * slope, 0.0, 1.0);
}
