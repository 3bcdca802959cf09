/// Endless winding lines of quarter circles, each square turned at random, between two colors.
///
/// scale = 2, 0.01 to 100: squares per scene unit
/// width = 0.14, 0 to 0.4: width of a line, as a share of a square
/// seed = 0, 0 to 1000: picks another pattern
/// line = "#f3ecdc": color of the lines
/// even = "#2c5364": color on one side of them
/// odd = "#c8785a": color on the other side
fn truchet(
    at: Surface, scale: f32, width: f32, seed: u32, line: vec3f, even: vec3f, odd: vec3f,
) -> vec3f {
    let drawn = 1.5707963 * width;
    let mean = vec2f(0.5 - 0.5 * drawn);
    let footprint = at.density * at.footprint * scale;
    var sides = mean;
    if footprint < 4.5 {
        let n = footprintParts(footprint, 4.0);
        let part = max(footprint / f32(n), 1e-20);
        var sum = vec2f(0.0);
        for (var i = 0u; i < n * n; i++) {
            let q = at.uv * scale + footprintPart(i, n, footprint);
            sum += truchetSides(q, part, 0.5 * width, seed);
        }
        sides = mix(sum / f32(n * n), mean, smoothstep(1.5, 4.5, footprint));
    }
    return even * sides.x + odd * sides.y + line * (1.0 - sides.x - sides.y);
}

/// The shares of the two colors beside the lines (Smith, The Tiling Patterns of Sebastien Truchet,
/// 1987): a color fills every other corner of the squares, so both find it wherever they meet.
fn truchetSides(p: vec2f, part: f32, reach: f32, seed: u32) -> vec2f {
    let cell = floor(p);
    let turned = cellCorners(vec3f(cell, f32(seed))).near.x >> 31u;
    let f = p - cell;
    let q = vec2f(select(f.x, 1.0 - f.x, turned == 1u), f.y);
    let inward = 0.5 - min(length(q), length(1.0 - q));
    let shares = saturate(0.5 + (vec2f(inward, -inward) - reach) / part);
    let swapped = ((u32(i32(cell.x) + i32(cell.y)) + turned) & 1u) == 1u;
    return select(shares, shares.yx, swapped);
}
