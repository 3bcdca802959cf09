/// Lines ruled both ways over a plain ground, every few of them bolder.
///
/// scale = 2, 0.01 to 100: cells per scene unit
/// line = 0.06, 0 to 0.9: width of a line, as a share of a cell
/// every = 5, 0 to 20: a bold line after so many cells; 0 for no bold lines
/// bold = 0.12, 0 to 0.9: width of a bold line, as a share of a cell
/// color = "#3f6f8f": color of the lines
/// ground = "#f1ede2": color between them
fn grid(
    at: Surface, scale: f32, line: f32, every: u32, bold: f32, color: vec3f, ground: vec3f,
) -> vec3f {
    let p = at.uv * scale;
    let width = vec2f(at.density * at.footprint * scale);
    var share = dutyShare(p + 0.5 * line, width, line);
    if every > 0u {
        // A bold line hides a fine one, which must not count twice.
        let n = f32(every);
        let heavy = max(bold, line);
        share += dutyShare((p + 0.5 * heavy) / n, width / n, heavy / n)
            - dutyShare((p + 0.5 * line) / n, width / n, line / n);
    }
    let open = (1.0 - share.x) * (1.0 - share.y);
    return ground * open + color * (1.0 - open);
}
