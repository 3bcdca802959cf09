/// A checkerboard of two colors that blurs to their mean in the distance instead of flickering.
///
/// scale = 1, 0.01 to 100: squares per scene unit
/// even = "#ece6d8": color where floor(scale u) + floor(scale v) is even
/// odd = "#39424e": color of the other squares
fn checker(at: Surface, scale: f32, even: vec3f, odd: vec3f) -> vec3f {
    // The sign of a checkerboard is the product of two stripes' signs, and so is its integral.
    let half_scale = 0.5 * scale;
    let side = 2.0 * dutyShare(at.uv * half_scale, vec2f(at.density * at.footprint * half_scale), 0.5) - 1.0;
    let share = 0.5 + 0.5 * side.x * side.y;
    return even * share + odd * (1.0 - share);
}
