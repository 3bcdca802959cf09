/// Equilateral triangles that point up and down by turns, in two colors.
///
/// scale = 1.5, 0.01 to 100: triangles per scene unit, counted along their bases
/// gap = 0.03, 0 to 0.6: width of a joint, as a share of a triangle's height
/// even = "#d8a24a": color of the triangles that point up
/// odd = "#4b5c6b": color of those that point down
/// joint = "#efe9dc": color of the joints
fn triangles(
    at: Surface, scale: f32, gap: f32, even: vec3f, odd: vec3f, joint: vec3f,
) -> vec3f {
    let width = at.density * at.footprint * scale;
    let solid = (1.0 - 1.5 * gap) * (1.0 - 1.5 * gap);
    var shares = vec2f(0.5 * solid);
    if width < 5.0 {
        let soft = trianglesShares(at.uv * scale, max(width, 1e-6), gap);
        shares = mix(soft, shares, smoothstep(2.0, 5.0, width));
    }
    return even * shares.x + odd * shares.y + joint * (1.0 - shares.x - shares.y);
}

/// What the even triangles cover of a box `width` wide, and what the odd ones do.
fn trianglesShares(p: vec2f, width: f32, gap: f32) -> vec2f {
    let height = 0.8660254;
    let y = p.y / height;
    let tall = width / height;
    // Where in a row a kind's corners and bases begin and end.
    let low = vec2f(0.5 * gap, gap);
    let high = 1.0 - low.yx;
    var shares = vec2f(0.0);
    let lowest = ceil(y - 0.5 * tall) - 1.0;
    // Far out one more row is the same number, so rows are counted. Filters are six rows tall at most.
    for (var n = 0; n < 8 && lowest + f32(n) < y + 0.5 * tall; n++) {
        let row = lowest + f32(n);
        let f = y - row;
        let below = 0.5 + (low - f) / tall;
        let above = 0.5 + (f - high) / tall;
        let part = max(1.0 - saturate(below) - saturate(above), vec2f(0.0));
        // A line through a row is in closed form. The mean of two, by Gauss, stands for all of its part.
        let first = clamp(vec2f(f - 0.5 * tall), low, high);
        let last = clamp(vec2f(f + 0.5 * tall), low, high);
        for (var i = 0; i < 2; i++) {
            let place = mix(first, last, select(0.21132487, 0.78867513, i == 1));
            let side = vec2f(1.0 - place.x, place.y) - gap;
            // Each row begins half a side from the last.
            let start = p.x - 0.5 * row - vec2f(0.5, 0.0) + 0.5 * side;
            shares += 0.5 * part * vec2f(dutyShare(start.xx, vec2f(width), side.x).x,
                dutyShare(start.yy, vec2f(width), side.y).x);
        }
    }
    return shares;
}
