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
    // Four places in the pixel, each for a quarter of it and in widths of that: chips hide each other
    // place by place.
    var x = vec4f(-0.5, 0.5, -0.5, 0.5);
    var y = vec4f(-0.5, -0.5, 0.5, 0.5);
    // Red, green and blue of the four.
    var color = mat3x4f(vec4f(ground.r), vec4f(ground.g), vec4f(ground.b));
    // The smallest chips come first: larger ones lie over them.
    var p = at.uv * scale * 3.2;
    var pixel = max(at.density * at.footprint * scale * 3.2, 1e-6);
    for (var i = 0u; i < 3u; i++) {
        p = vec2f(0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y) + vec2f(3.71, 1.27);
        let turned = 0.8 * x - 0.6 * y;
        y = 0.6 * x + 0.8 * y;
        x = turned;
        let sharp = 2.0 / pixel;
        // A pixel that hides the shape of a chip takes it for a square along its own sides.
        let coarse = pixel / size;
        let hidden = smoothstep(0.5, 0.9, coarse);
        let along = vec2f(x.y - x.x, y.y - y.x);
        let across = vec2f(x.z - x.x, y.z - y.x);
        // The product of what five cuts leave of a blurred chip sums up to less than the chip: fitted.
        let gain = (1.0 - hidden) * (1.0 + 0.1 * coarse * coarse);
        // Chips stay in their cells.
        let far = smoothstep(1.8, 3.0, pixel);
        let n = select(2u + u32(min(1.15 * pixel, 2.0)), 0u, far == 1.0);
        let corner = floor(p - 0.5 * f32(n) + 0.5);
        var chips = mat3x4f();
        var share = vec4f(0.0);
        for (var j = 0u; j < n * n; j++) {
            let cell = corner + vec2f(vec2u(j % n, j / n));
            let word = pcg(cellCorners(vec3f(cell, f32(i))).near.xxxx + vec4u(0u, 1u, 2u, 3u));
            let chance = tenBits(word, 0u);
            let cut = size * (0.3 + 0.1 * tenBits(word, 10u));
            // A chip, mirrored at random, is what five straight cuts leave.
            let side = sign(tenBits(word, 20u).xy);
            let q = (p - cell - 0.5 - 0.14 * chance.xy) * side;
            var seen = vec4f(0.0);
            if hidden < 1.0 {
                let depths = 0.5 + (cut - vec4f(0.309017 * q.x + vec2f(0.951057, -0.951057) * q.y,
                    -0.809017 * q.x + vec2f(0.587785, -0.587785) * q.y)) * sharp;
                let u = side.x * x;
                let v = side.y * y;
                seen = gain * saturate(0.5 + (0.3 * size - q.x) * sharp - u)
                    * saturate(depths.x - 0.309017 * u - 0.951057 * v)
                    * saturate(depths.y - 0.309017 * u + 0.951057 * v)
                    * saturate(depths.z + 0.809017 * u - 0.587785 * v)
                    * saturate(depths.w + 0.809017 * u + 0.587785 * v);
            }
            if hidden > 0.0 {
                // The five cuts lie around this middle; the square is as large as what they leave.
                let leaning = vec4f(0.309017, 0.309017, -0.809017, -0.809017);
                let middle = 0.4 * vec2f(0.3 * size + dot(cut, leaning),
                    dot(cut, vec4f(0.951057, -0.951057, 0.587785, -0.587785)));
                let reach = 0.189 * (0.3 * size + dot(cut, vec4f(1.0))) * sharp;
                let away = (middle - q) * side * sharp;
                let columns = terrazzoHalves(dot(away, along), reach);
                let rows = terrazzoHalves(dot(away, across), reach);
                seen += hidden * columns.xyxy * rows.xxyy;
            }
            let pick = select(select(first, second, chance.z > -0.333), third, chance.z > 0.333);
            let tone = min(pick * (1.0 + variation * chance.w), vec3f(1.0));
            chips += mat3x4f(tone.r * seen, tone.g * seen, tone.b * seen);
            share += seen;
        }
        let whole = max(share, vec4f(1.0));
        let covered = 0.323 * size * size;
        let mean = far * covered * (first + second + third) / 3.0;
        let near = (1.0 - far) / whole;
        let open = 1.0 - mix(share / whole, vec4f(covered), far);
        color[0] = color[0] * open + chips[0] * near + mean.r;
        color[1] = color[1] * open + chips[1] * near + mean.g;
        color[2] = color[2] * open + chips[2] * near + mean.b;
        p /= 1.8;
        pixel /= 1.8;
    }
    return vec4f(0.25) * color;
}

/// How much of -1 to 0 and of 0 to 1 lies within `reach` of `middle`.
fn terrazzoHalves(middle: f32, reach: f32) -> vec2f {
    let low = max(vec2f(middle - reach), vec2f(-1.0, 0.0));
    let high = min(vec2f(middle + reach), vec2f(0.0, 1.0));
    return max(high - low, vec2f(0.0));
}
