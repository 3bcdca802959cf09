/// Polished marble: dark veins meander through pale, cloudy stone.
///
/// scale = 1.5, 0.01 to 100: fineness; at 1, bold veins lie some two scene units apart
/// octaves = 6, 1 to 12: detail in the course of the veins
/// warp = 2, 0 to 8: how far the veins stray from straight lines
/// sharpness = 5, 1 to 64: how thin and crisp the veins are
/// stone = "#f2efe9": color of the stone
/// vein = "#4b5058": color of the veins
fn marble(
    at: Surface, scale: f32, octaves: u32, warp: f32, sharpness: f32, stone: vec3f, vein: vec3f,
) -> vec3f {
    let p = at.position * scale;
    let width = at.footprint * scale;
    let cloud = fractalNoise(p * 0.35, octaves, 2.1, 0.48, 0.35 * width) - 0.5;
    // Two families of veins over one turbulence (Perlin, An Image Synthesizer, 1985).
    let phase = vec2f(dot(p, vec3f(0.34, 0.21, 0.29)), dot(p, vec3f(-0.62, 0.47, 0.71)))
        + warp * cloud * vec2f(1.0, -0.8);
    let wave = sin((phase - round(phase)) * 3.14159265);
    // pow is only sure of a positive base.
    let near = max(vec2f(1.0) - abs(wave), vec2f(1e-6));
    let power = sharpness * vec2f(1.0, 2.0);
    // Veins too fine to see leave about the mean that this power has over a period.
    let seen = 1.0 - smoothstep(0.2, 1.0, width);
    let veins = mix(0.65 / (power + 1.0), pow(near, power), seen);
    let share = veins.x * (0.75 + cloud) + 0.4 * veins.y + 0.25 * cloud + 0.03;
    let tint = clamp(share, 0.0, 1.0);
    return stone * (1.0 - tint) + vein * tint;
}
