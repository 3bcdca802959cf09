/// Octagonal paving stones with small squares set on edge between their corners.
///
/// scale = 2, 0.01 to 100: octagons per scene unit
/// corner = 0.29, 0.1 to 0.4: how much of an octagon's half side the squares cut off
/// gap = 0.06, 0 to 0.3: width of a joint, as a share of an octagon
/// octagon = "#e5dfd1": color of the octagons
/// square = "#353b40": color of the squares
/// joint = "#9a9184": color of the joints
fn pavement(
    at: Surface, scale: f32, corner: f32, gap: f32, octagon: vec3f, square: vec3f, joint: vec3f,
) -> vec3f {
    // A joint also takes its part of what the square has cut off.
    let cut = corner - 0.29289322 * gap;
    let side = max(1.4142136 * corner - gap, 0.0);
    let mean = vec2f((1.0 - gap) * (1.0 - gap) - 2.0 * cut * cut, side * side);
    let width = at.density * at.footprint * scale;
    var shares = mean;
    if width < 3.0 {
        let n = footprintParts(width, 4.0);
        let part = width / f32(n);
        var sum = vec2f(0.0);
        for (var i = 0u; i < n * n; i++) {
            let q = at.uv * scale + footprintPart(i, n, width);
            sum += pavementStones(q, max(part, 1e-20), corner, gap);
        }
        shares = mix(sum / f32(n * n), mean, smoothstep(1.4, 3.0, width));
    }
    return octagon * shares.x + square * shares.y + joint * (1.0 - shares.x - shares.y);
}

/// The shares of octagon and of square.
fn pavementStones(p: vec2f, width: f32, corner: f32, gap: f32) -> vec2f {
    // Seen from the middle of a square, its sides lie along the diagonals.
    let r = abs(p - round(p));
    let away = vec2f(r.x + r.y, abs(r.x - r.y)) * 0.70710678;
    let reach = max(vec2f(corner * 0.70710678) + vec2f(0.5, -0.5) * gap, vec2f(0.0));
    let limit = min(2.0 * reach / width, vec2f(1.0));
    let along = clamp(0.5 + (reach - away.x) / width, vec2f(0.0), limit);
    let across = clamp(0.5 + (reach - away.y) / width, vec2f(0.0), limit);
    let squares = along * across;
    // The joints between octagons run into those around the squares: where the footprint blurs
    // both, the overlap must not count twice.
    let end = corner + 0.20710678 * gap + clamp(width - 0.25 * gap, 0.0, 0.25 * gap);
    let past = 1.0 - clamp(0.5 + (end - r) / width, vec2f(0.0), vec2f(min(2.0 * end / width, 1.0)));
    let lines = saturate(0.5 + (r + 0.5 * gap) / width) - saturate(0.5 + (r - 0.5 * gap) / width);
    return vec2f(max(1.0 - squares.x - dot(lines, past.yx), 0.0), squares.y);
}
