/// Cells as in foam, skin or scales: how far it is to scattered points or to the walls between them.
///
/// scale = 2, 0.01 to 100: points per scene unit
/// jitter = 1, 0 to 1: how far the points stray from a lattice
/// feature = f1 of f1, f2, difference, edge, cell: nearest point, the next, f2 - f1, nearest wall, or a shade
/// metric = euclidean of euclidean, manhattan, chebyshev: round cells, or two ways to angular ones
fn voronoi(at: Surface, scale: f32, jitter: f32, feature: u32, metric: u32) -> f32 {
    let pixel = max(at.footprint * scale, 1e-6);
    // Each value's mean, and the width from which a pixel shows only that.
    var afar = vec2f(0.515, 6.5);
    switch feature {
        case 1u: { afar = vec2f(0.705, 6.5); }
        case 2u: { afar = vec2f(0.19, 4.5); }
        case 3u: { afar = vec2f(select(0.19, 0.252, metric == 0u), 4.5); }
        case 4u: { afar = vec2f(0.5, 10.0); }
        default: {}
    }
    let seen = 1.0 - smoothstep(0.3 * afar.y, afar.y, pixel);
    if seen == 0.0 {
        return afar.x;
    }
    // Manhattan's distances are long and Chebyshev's short: so all of them fill 0 to 1.
    let unit = select(select(1.0, 0.67, metric == 1u), 1.2, metric == 2u);
    let sides = flatTangents(at.normal);
    let n = select(1u, 2u, pixel > 0.7);
    let part = pixel / f32(n);
    var sum = 0.0;
    for (var i = 0u; i < n * n; i++) {
        let p = at.position * scale + sides * footprintPart(i, n, pixel);
        let found = nearestCells(p, 0.25 * part * sides, jitter, metric, vec3f(0.0), feature == 3u);
        var value = found.f1 * unit;
        switch feature {
            case 1u: { value = found.f2 * unit; }
            case 2u: { value = (found.f2 - found.f1) * unit; }
            case 3u: { value = 2.0 * found.edge * unit; }
            case 4u: { value = vec4f(cellShade(found, 0.35 * part)); }
            default: {}
        }
        sum += dot(saturate(value), vec4f(0.25));
    }
    return mix(afar.x, sum / f32(n * n), seen);
}
