// A texture of your own. In a scene beside this folder, write
//
//     material: (color: MyTexture(scale: 3, light: "gold"))
//
// and each save of this file shows at once. What follows `fn myTexture` in the signature is what a scene may
// say. The doc lines, with three strokes, give it defaults, limits and help; the first of them says what the
// texture is. LANGUAGE.md has the whole story under "Write a texture".

/// Soft stripes that noise bends.
///
/// scale = 2, 0.01 to 100: stripes per scene unit
/// bend = 0.5, 0 to 5: how far the noise pushes a stripe, in stripes
/// light = "#f2e6cf": color of the stripes
/// dark = "#7a4b3a": color between them
fn myTexture(at: Surface, scale: f32, bend: f32, light: vec3f, dark: vec3f) -> vec3f {
    let p = at.position * scale;
    // Noise from 0 to 1, about one feature a unit.
    let pushed = p.x + bend * (2.0 * perlinNoise(p) - 1.0);
    let wave = 0.5 + 0.5 * cos(6.2831853 * fract(pushed));
    // Stripes narrower than a pixel become their mean, or a picture would flicker.
    let width = at.footprint * scale;
    return mix(dark, light, mix(wave, 0.5, smoothstep(0.3, 1.0, width)));
}
