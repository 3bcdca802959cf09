/// Soft random blotches, all about the same size.
///
/// scale = 1.5, 0.01 to 100: blotches per scene unit
fn noise(at: Surface, scale: f32) -> f32 {
    return fractalNoise(at.position * scale, 1u, 2.0, 0.5, at.footprint * scale);
}
