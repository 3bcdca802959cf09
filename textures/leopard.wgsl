/// A spotted coat: round dark spots in slanting rows, some bold and some faint.
///
/// scale = 2, 0.01 to 100: bold spots per scene unit, along a row
/// contrast = 2, 0.5 to 8: how far the bold spots fill out
/// fur = "#d0a568": color between the spots
/// spot = "#33241a": color of the boldest spots
fn leopard(at: Surface, scale: f32, contrast: f32, fur: vec3f, spot: vec3f) -> vec3f {
    // Floors and walls cut the lattice of spots askew, so that all of its sizes show.
    let p = (at.position + 0.37) * frameAround(vec3f(0.48, 0.6, 0.64)) * scale;
    let s = sin((p - round(p)) * 6.2831853);
    // What a box leaves of a sine, and of one twice as fine. 0.82 of a slanting axis lies in the surface.
    let x = 3.14159265 * clamp(at.footprint * scale * vec2f(0.82, 1.64), vec2f(1e-3), vec2f(1.0));
    let left = sin(x) / x;
    // The square of three sines' sum (the pattern of that name in POV-Ray), each product filtered.
    let sum = dot(s, vec3f(left.x));
    let squares = (left.y - left.x * left.x) * dot(s, s) + 1.5 * (1.0 - left.y);
    let share = clamp(contrast * (sum * sum + squares) / 9.0, 0.0, 1.0);
    return fur * (1.0 - share) + spot * share;
}
