// A number as a color: blue below 0, white at 0, red above, with lines at its tenths.

const BELOW: vec3f = vec3f(0.08, 0.28, 0.72);
const ABOVE: vec3f = vec3f(0.75, 0.12, 0.1);

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
