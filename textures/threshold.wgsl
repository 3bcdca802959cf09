/// 0 where a pattern lies below a level, 1 where it lies above.
///
/// of = 0.7, 0 to 1: the pattern
/// level = 0.5, 0 to 1: where it passes from 0 to 1
/// softness = 0.02, 0 to 1: width of the passage, in the pattern's values
fn threshold(at: Surface, of_: f32, level: f32, softness: f32) -> f32 {
    let reach = 0.5 * max(softness, 1e-6);
    return smoothstep(-reach, reach, of_ - level);
}
