/// A texture that adds what cannot be added.
///
/// scale = 4, 0.01 to 1000: cells per scene unit
fn typeError(at: Surface, scale: f32) -> vec3f {
    let cell = floor(at.uv * scale);
    return cell;
}
