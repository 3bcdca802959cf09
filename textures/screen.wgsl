/// Two colors as from two projectors, brighter than either, never past white; clamped to 0 to 1.
///
/// a = "#7a3b2e": one color
/// b = "#2e5a7a": the other
fn screen(at: Surface, a: vec3f, b: vec3f) -> vec3f {
    let dark = (1.0 - clamp(a, vec3f(0.0), vec3f(1.0))) * (1.0 - clamp(b, vec3f(0.0), vec3f(1.0)));
    return 1.0 - dark;
}
