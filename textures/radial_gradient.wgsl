/// A soft well of shade around the y axis, from black at the axis to white at a distance.
///
/// from = 0, 0 to 20: distance from the axis where the pattern is 0, in scene units
/// to = 5, 0 to 20: distance where it is 1
/// repeat = false: whether it starts anew beyond each end, instead of staying as it is there
fn radialGradient(at: Surface, from_: f32, to: f32, repeat: bool) -> f32 {
    let span = to - from_;
    // Equal ends make a hard edge, not a division by zero.
    let safe = select(span, 1e-4, abs(span) < 1e-4);
    let p = at.position.xz;
    // A pixel on the axis has points off it: this is the root of their mean square.
    let away = sqrt(dot(p, p) + at.footprint * at.footprint / 6.0);
    let x = (away - from_) / safe;
    if !repeat {
        return clamp(x, 0.0, 1.0);
    }
    // The mean of fract over the width is that of x less that of floor, which is a sum of steps.
    let width = clamp(at.footprint / abs(safe), 1e-20, 16.0);
    let f = x - floor(x);
    let ends = vec2f(f - 0.5 * width, f + 0.5 * width);
    let steps = floor(ends) * (ends - 0.5 * floor(ends) - 0.5);
    return clamp(f - (steps.y - steps.x) / width, 0.0, 1.0);
}
