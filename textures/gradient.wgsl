/// A clear sky: the horizon's color at and below eye level, the zenith's straight above.
///
/// zenith = "#5d88c9": color straight up
/// horizon = "#e6eef6": color at and below the horizon
fn gradient(at: Surface, zenith: vec3f, horizon: vec3f) -> vec3f {
    // As a background, the position is the direction of the ray.
    let height = clamp(at.position.y, 0.0, 1.0);
    return horizon * (1.0 - height) + zenith * height;
}
