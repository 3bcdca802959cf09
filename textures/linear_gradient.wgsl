/// A smooth passage from one color to another along a direction, constant beyond both ends.
///
/// axis = (1, 1, 0), nonzero: direction of the passage, of any length
/// from = -1, -10 to 10: where `start` ends, in scene units along the axis
/// to = 1.5, -10 to 10: where `end` begins
/// start = "#2b4c7e": color before the passage
/// end = "#f6c28b": color after it
fn linearGradient(
    at: Surface, axis: vec3f, from_: f32, to: f32, start: vec3f, end: vec3f,
) -> vec3f {
    let span = to - from_;
    // Equal ends make a hard edge, not a division by zero.
    let safe = select(span, 1e-6, abs(span) < 1e-6);
    let share = clamp((dot(at.position, normalize(axis)) - from_) / safe, 0.0, 1.0);
    return start * (1.0 - share) + end * share;
}
