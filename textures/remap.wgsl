/// A pattern whose values are stretched and shifted from one range to another.
///
/// of = 0.7, 0 to 1: the pattern
/// from_low = 0, -10 to 10: value that becomes `to_low`
/// from_high = 1, -10 to 10: value that becomes `to_high`
/// to_low = 0.2, -10 to 10: what `from_low` becomes
/// to_high = 0.9, -10 to 10: what `from_high` becomes
/// clamped = true: whether values beyond the first range stay at the ends of the second
/// gives -2.2e8 to 2.2e8
fn remap(
    at: Surface, of_: f32, from_low: f32, from_high: f32, to_low: f32, to_high: f32, clamped: bool,
) -> f32 {
    let span = from_high - from_low;
    // An empty range makes a hard edge, not a division by zero.
    let safe = select(span, 1e-6, abs(span) < 1e-6);
    let share = (of_ - from_low) / safe;
    let kept = select(share, clamp(share, 0.0, 1.0), clamped);
    return to_low * (1.0 - kept) + to_high * kept;
}
