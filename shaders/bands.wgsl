// Bands as a square pixel sees them at any angle.

/// How much of a square around x has fract(x) < duty, where x grows by `reach` along its two sides.
fn dutySquareShare(x: f32, reach: vec2f, duty: f32) -> f32 {
    // Exact along the longer reach. Over the shorter two places are enough as long as it is less than a band;
    // then four, in the middles of its quarters.
    let wide = vec2f(max(reach.x, reach.y));
    let narrow = min(reach.x, reach.y);
    if narrow < 0.5 {
        let shares = dutyShare(x + vec2f(-0.2887, 0.2887) * narrow, wide, duty);
        return 0.5 * (shares.x + shares.y);
    }
    let shares = dutyShare(x + vec2f(-0.375, -0.125) * narrow, wide, duty)
        + dutyShare(x + vec2f(0.125, 0.375) * narrow, wide, duty);
    return 0.25 * (shares.x + shares.y);
}
