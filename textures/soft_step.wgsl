/// A smooth passage from 0 where a pattern is at most `low` to 1 where it is at least `high`.
///
/// of = 0.6, 0 to 1: the pattern
/// low = 0.3, -10 to 10: value that becomes 0; above `high`, the passage is turned round
/// high = 0.7, -10 to 10: value that becomes 1
fn softStep(at: Surface, of_: f32, low: f32, high: f32) -> f32 {
    let span = high - low;
    // Equal ends make a hard edge, not a division by zero.
    let safe = select(span, 1e-6, abs(span) < 1e-6);
    let share = clamp((of_ - low) / safe, 0.0, 1.0);
    return share * share * (3.0 - 2.0 * share);
}
