/// A texture with a parameter that nobody explains.
fn missingDocLine(at: Surface, scale: f32) -> f32 {
    return fract(at.uv.x * scale);
}
