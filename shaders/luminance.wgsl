// How bright a color looks.

/// Brightness of a linear color (Rec. 709).
fn luminance(color: vec3f) -> f32 {
    return dot(color, vec3f(0.2126, 0.7152, 0.0722));
}
