// Ways from one stop of a ramp to the next.

/// How far `x` has come from `low` to `high`, 0 to 1; a step where they are equal.
fn rampStep(low: f32, high: f32, x: f32) -> f32 {
    return select(step(high, x), clamp((x - low) / (high - low), 0.0, 1.0), high > low);
}

/// The same, level at both ends.
fn rampSmooth(low: f32, high: f32, x: f32) -> f32 {
    let share = rampStep(low, high, x);
    return share * share * (3.0 - 2.0 * share);
}

/// Nothing until `high`.
fn rampConstant(low: f32, high: f32, x: f32) -> f32 {
    return step(high, x);
}
