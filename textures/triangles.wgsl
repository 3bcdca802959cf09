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
    let solid = (1.0 - 1.5 * gap) * (1.0 - 1.5 * gap);
    let mean = vec2f(solid, 0.0);
    let width = at.footprint * scale;
    var share = mean;
    if width < 2.0 {
        let n = u32(clamp(ceil(4.0 * width), 1.0, 4.0));
        let part = width / f32(n);
        var sum = vec2f(0.0);
        for (var i = 0u; i < n * n; i++) {
            let q = at.uv * scale + part * (vec2f(vec2u(i % n, i / n)) + 0.5) - 0.5 * width;
            sum += trianglesShare(q, part, gap);
        }
        share = mix(sum / f32(n * n), mean, smoothstep(1.0, 2.0, width));
    }
    let colored = even * (share.x + share.y) + odd * (share.x - share.y);
    return 0.5 * colored + joint * (1.0 - share.x);
}

/// The sum and the difference of what the two kinds of triangles cover.
fn trianglesShare(p: vec2f, width: f32, gap: f32) -> vec2f {
    // A triangle is where three families of stripes cross: even ones all, or one even and two odd.
    // So the product of the families' sums is the tiles', that of their differences the kinds'.
    let height = 0.8660254;
    var share = vec2f(1.0);
    for (var i = 0; i < 3; i++) {
        let slope = f32(i - 1);
        let along = select(vec2f(0.8660254 * slope, 0.5), vec2f(0.0, -1.0), i == 1);
        let stripe = dot(p, along) / height;
        let both = dutyShare((vec2f(stripe, stripe - 1.0) - 0.5 * gap) * 0.5,
            vec2f(0.5 * width / height), 0.5 - 0.5 * gap);
        share *= vec2f(both.x + both.y, both.x - both.y);
    }
    return share;
}
