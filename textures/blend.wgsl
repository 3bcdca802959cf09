/// One color where `by` is 0, another where it is 1, and their mixture between; beyond, the nearer one.
///
/// a = "#d9b382": color where `by` is 0
/// b = "#2f5d73": color where it is 1
/// by = 0.5, 0 to 1: share of `b`
fn blend(at: Surface, a: vec3f, b: vec3f, by: f32) -> vec3f {
    let share = clamp(by, 0.0, 1.0);
    return a * (1.0 - share) + b * share;
}
