/// A texture whose doc lines are not what they should be.
///
/// scale = four, 0.01 to 1000: a default in words
/// mortar = 0.1, 0.5 to 0: a range upside down
/// clay = "brickish": no color of that name
/// joint = "#fff": a color for a number
/// turn = 1 a line without a colon
/// height = 3: no parameter of that name
fn badDocLine(at: Surface, scale: f32, mortar: f32, clay: vec3f, joint: f32, turn: f32) -> vec3f {
    return clay;
}
