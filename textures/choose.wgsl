/// One color where a pattern lies below a level, another where it lies above.
///
/// by = 0.7, 0 to 1: the pattern
/// level = 0.5, 0 to 1: where the colors meet
/// softness = 0.02, 0 to 1: width of the passage, in the pattern's values
/// a = "#d8c9a8": color below the level
/// b = "#3c5a4e": color above it
fn choose(at: Surface, by: f32, level: f32, softness: f32, a: vec3f, b: vec3f) -> vec3f {
    let reach = 0.5 * max(softness, 1e-6);
    let share = smoothstep(-reach, reach, by - level);
    return a * (1.0 - share) + b * share;
}
