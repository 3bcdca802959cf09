/// Tartan: stripes of four colors woven across themselves in twill.
///
/// scale = 1, 0.01 to 100: repeats of the stripes per scene unit
/// threads = 80, 8 to 1000: threads per repeat
/// weave = 0.7, 0 to 1: how plainly the single threads show
/// ground = "#2f4a3c": color of the widest stripe
/// check = "#1d2a4a": color of the stripe beside it
/// stripe = "#9c2f2c": color of the stripe in the middle of that one
/// line = "#e2c56a": color of the fine line through the ground
fn plaid(
    at: Surface, scale: f32, threads: f32, weave: f32,
    ground: vec3f, check: vec3f, stripe: vec3f, line: vec3f,
) -> vec3f {
    let p = at.uv * scale;
    let width = vec2f(at.density * at.footprint * scale);
    let checks = dutyShare(p, width, 0.44);
    let bars = dutyShare(p - 0.17, width, 0.1);
    let lines = dutyShare(p - 0.705, width, 0.03);
    let warp = ground + (check - ground) * checks.x + (stripe - check) * bars.x + (line - ground) * lines.x;
    let weft = ground + (check - ground) * checks.y + (stripe - check) * bars.y + (line - ground) * lines.y;
    // In a 2/2 twill each thread dives under two and over two, one later than its neighbor.
    let rate = 0.25 * round(threads);
    let ribs = dutyShare(vec2f((p.x + p.y) * rate), 1.3 * width * rate, 0.5).x - 0.5;
    let above = 0.5 + weave * ribs * (1.0 - smoothstep(0.5, 1.5, width.x * rate));
    return warp * above + weft * (1.0 - above);
}
