/// Terrazzo: stone chips of three colors and many sizes in a polished ground.
///
/// scale = 3, 0.01 to 1000: large chips per scene unit
/// size = 0.7, 0.1 to 1: size of the chips, beside the room that they have
/// variation = 0.25, 0 to 1: how much the chips differ in brightness
/// ground = "#e4ddd0": color between the chips
/// first = "#b0674c": color of one kind of chip
/// second = "#5d7068": color of another
/// third = "#43484d": color of the last
fn terrazzo(
    at: Surface, scale: f32, size: f32, variation: f32,
    ground: vec3f, first: vec3f, second: vec3f, third: vec3f,
) -> vec3f {
    // The smallest chips come first: larger ones lie over them.
    var p = at.uv * scale * 3.2;
    var pixel = max(at.footprint * scale * 3.2, 1e-6);
    var color = ground;
    for (var i = 0u; i < 3u; i++) {
        p = vec2f(0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y) + vec2f(3.71, 1.27);
        // The pixel's overlap with a square as large as the chip, along d and across it. d is too short
        // beyond a corner; the divisor takes back what that adds up to over the square.
        let fit = 0.566 * size / pixel;
        let most = min(fit, 1.0);
        let even = min(fit, 1.0 / fit);
        let gain = most / (1.0 + even * even / 3.0);
        var chips = vec4f(0.0);
        for (var j = 0u; j < 4u; j++) {
            let cell = floor(p - 0.5) + vec2f(f32(j & 1u), f32(j >> 1u));
            let word = pcg(cellCorners(vec3f(cell, f32(i))).near.xxxx + vec4u(0u, 1u, 2u, 3u));
            let chance = tenBits(word, 0u);
            let cut = 0.3 + 0.1 * tenBits(word, 10u);
            // A chip is what five straight cuts leave; d is the way to the nearest, inside negative.
            let q = (p - cell - 0.5 - 0.14 * chance.xy) * sign(tenBits(word, 20u).xy);
            let a = 0.309017 * q.x + vec2f(0.951057, -0.951057) * q.y;
            let b = -0.809017 * q.x + vec2f(0.587785, -0.587785) * q.y;
            let ways = vec4f(a, b) - size * cut;
            let d = max(max(max(ways.x, ways.y), max(ways.z, ways.w)), q.x - size * 0.3);
            let share = clamp(0.5 - d / pixel, 0.0, most) * gain;
            let pick = select(select(first, second, chance.z > -0.333), third, chance.z > 0.333);
            chips += vec4f(min(pick * (1.0 + variation * chance.w), vec3f(1.0)), 1.0) * share;
        }
        chips /= max(chips.w, 1.0);
        let mean = 0.32 * size * size * vec4f((first + second + third) / 3.0, 1.0);
        chips = mix(chips, mean, smoothstep(0.8, 1.8, pixel));
        color = color * (1.0 - chips.w) + chips.rgb;
        p /= 1.8;
        pixel /= 1.8;
    }
    return color;
}
