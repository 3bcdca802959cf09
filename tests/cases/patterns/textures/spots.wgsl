/// Dots of one color on a ground of another, in rows.
///
/// size = 0.3, 0 to 0.5: radius of a dot, as a share of its cell
/// grid = (1, 1): cells per scene unit
/// shape = round of round, square: outline of a dot
/// shift = 0, -8 to 8: cells by which every other row is moved
/// inverted = false: whether dots and ground change places
/// tint = (1, 1, 1, 1): factor of the dots' color, and their opacity
/// dot = "tomato": color of the spots
/// ground = "#f2efe6": color around them
/// gives 0 to 4
fn spots(
    at: Surface, size: f32, grid: vec2f, shape: u32, shift: i32, inverted: bool, tint: vec4f, dot_: vec3f, ground: vec3f,
) -> vec3f {
    let row = floor(at.uv.y * grid.y);
    let cell = fract(at.uv * grid + vec2f(0.5 * f32(shift) * (row - 2.0 * floor(0.5 * row)), 0.0)) - 0.5;
    let distance = select(length(cell), max(abs(cell.x), abs(cell.y)), shape == 1u);
    let on = (distance < size) != inverted;
    return mix(ground, dot_ * tint.rgb, select(0.0, tint.a, on));
}
