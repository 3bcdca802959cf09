/// A sweep around the y axis from black to white, like the hand of a radar.
///
/// sweeps = 1, 1 to 64: how many times it runs from black to white in a turn
/// start_deg = 0, -360 to 360: where the first one starts, from +x towards +z
fn conicGradient(at: Surface, sweeps: u32, start_deg: f32) -> f32 {
    let p = at.position.xz;
    let away = length(p);
    // The angle of no direction is whatever the driver likes.
    let q = select(p, vec2f(1.0, 0.0), away < 1e-12);
    let x = f32(sweeps) * (atan2(q.y, q.x) / 6.2831853 - start_deg / 360.0);
    let f = x - floor(x);
    // The mean of fract over the width is that of x less that of floor, which is a sum of steps.
    let width = clamp(f32(sweeps) * at.footprint / max(6.2831853 * away, 1e-12), 1e-20, 16.0);
    let ends = vec2f(f - 0.5 * width, f + 0.5 * width);
    let steps = floor(ends) * (ends - 0.5 * floor(ends) - 0.5);
    return clamp(f - (steps.y - steps.x) / width, 0.0, 1.0);
}
