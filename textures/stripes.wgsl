/// Straight stripes of two colors along v that blur to their mean in the distance.
///
/// scale = 1, 0.01 to 100: stripes per scene unit
/// even = "#f0ebe0": color where floor(scale u) is even
/// odd = "#2f5d73": color of the stripes between
fn stripes(at: Surface, scale: f32, even: vec3f, odd: vec3f) -> vec3f {
    let half_scale = 0.5 * scale;
    let share = dutyShare(at.uv.xx * half_scale, vec2f(at.density * at.footprint * half_scale), 0.5).x;
    return even * share + odd * (1.0 - share);
}
