/// Overlapping scales in staggered rows, like a fish's or a tiled roof's, darker where they emerge.
///
/// scale = 3, 0.01 to 100: scales per scene unit, counted along a row
/// height = 0.5, 0.5 to 1.5: how far one row shows under the next, in widths of a scale
/// line = 0.06, 0 to 0.2: width of the rim, as a share of a scale's width
/// variation = 0.3, 0 to 1: how much the scales differ in brightness
/// tip = "#c3dec4": color of a scale's round end
/// base = "#337a7d": color where it comes out from under the next row
/// rim = "#173d44": color of the rims
fn scales(
    at: Surface, scale: f32, height: f32, line: f32, variation: f32, tip: vec3f, base: vec3f, rim: vec3f,
) -> vec3f {
    // Half a ring and two straight sides, whose upper ends the next row rounds off.
    let drawn = (1.5707963 * line * (1.0 - line) + (2.0 * height - 1.0) * line
        + 0.6666667 * line * line * line) / height;
    // A scale's mean depth less that of its rim, the constants from numerical integration.
    let depth = 0.5 * height + 0.02148 / height - drawn * (0.5 * height + 0.14 - 0.2 * line);
    let bright = depth / (height + 0.5);
    let toned = 1.0 - 0.5 * variation;
    let mean = vec3f(toned * (1.0 - drawn - bright), toned * bright, drawn);
    let width = at.density * at.footprint * scale;
    var shares = mean;
    let coarse = width / max(height, 1.0);
    if coarse < 1.4 {
        let n = footprintParts(width, 6.0);
        let part = width / f32(n);
        var sum = vec3f(0.0);
        for (var i = 0u; i < n * n; i++) {
            let q = at.uv * scale + footprintPart(i, n, width);
            sum += scalesShares(q, max(part, 1e-20), height, line, variation);
        }
        shares = mix(sum / f32(n * n), mean, smoothstep(0.7, 1.4, coarse));
    }
    return base * shares.x + tip * shares.y + rim * shares.z;
}

/// The shares of base, of tip and of rim.
fn scalesShares(p: vec2f, width: f32, height: f32, line: f32, variation: f32) -> vec3f {
    // Only the scales of two rows lie here: the upper one's round end covers the lower one's middle.
    let row = floor(p.y / height);
    let shift = vec2f(0.0, 0.5);
    let ahead = select(shift, shift.yx, (i32(row) & 1) == 1);
    let column = round(p.x - ahead);
    let aside = p.x - ahead - column;
    let above = row + 1.0;
    // The next one beside it and the tip of one in the row above come near enough for a footprint.
    let x = vec3f(aside.y, 1.0 - abs(aside.y), aside.x);
    let y = p.y - height * vec3f(above, above, above + 1.0);
    let inward = 0.5 - sqrt(x * x + y * y);
    let covers = saturate(0.5 + inward / width);
    let upper = min(covers.x + covers.y + covers.z, 1.0);
    let rings = covers - saturate(0.5 + (inward - line) / width);
    let border = 0.5 - abs(aside.x);
    let sides = saturate(0.5 + (border + line) / width) - saturate(0.5 + (border - line) / width);
    // What the rims leave of the lower scale and of the upper one.
    let open = vec2f((1.0 - upper) * (1.0 - sides), max(upper - rings.x - rings.y - rings.z, 0.0));

    // How far below the next row's edge a point lies on the lower and on the upper scale.
    let arch = sqrt(max(0.25 - aside * aside, vec2f(0.0))).yx;
    let depth = saturate((vec2f(above, above + 1.0) * height - arch - p.y) / (height + 0.5));
    let name = select(vec2f(column.x, row), vec2f(column.y, above), inward.x > 0.0);
    let tone = tenBits(cellCorners(vec3f(name, 0.0)).near, 10u).x;
    // Halfway into the neighbor, two tones have no tone on average.
    let shade = 1.0 - 0.5 * variation * (1.0 - tone * saturate(4.0 * abs(inward.x) / width));
    let lit = open.x + open.y;
    let bright = dot(open, depth);
    return vec3f(shade * (lit - bright), shade * bright, 1.0 - lit);
}
