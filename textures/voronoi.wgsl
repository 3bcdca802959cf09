/// Cells as in foam, skin or scales: how far it is to scattered points or to the walls between them.
///
/// scale = 2, 0.01 to 100: points per scene unit
/// jitter = 1, 0 to 1: how far the points stray from a lattice
/// feature = f1 of f1, f2, difference, edge, cell: nearest point, the next, f2 - f1, nearest wall, or a shade
/// metric = euclidean of euclidean, manhattan, chebyshev: round cells, or two ways to angular ones
fn voronoi(at: Surface, scale: f32, jitter: f32, feature: u32, metric: u32) -> f32 {
    let pixel = max(at.footprint * scale, 1e-6);
    let near = nearestCells(at.position * scale, jitter, metric, vec3f(0.0), feature == 3u);
    // Manhattan's distances are long and Chebyshev's short: so all of them fill 0 to 1.
    let unit = select(select(1.0, 0.67, metric == 1u), 1.2, metric == 2u);
    // Each value with its mean, and with how soon a pixel covers enough to show only that.
    var shown = vec3f(near.f1 * unit, 0.5, 1.2);
    switch feature {
        case 1u: { shown = vec3f(near.f2 * unit, 0.7, 1.2); }
        case 2u: { shown = vec3f((near.f2 - near.f1) * unit, 0.2, 2.8); }
        case 3u: { shown = vec3f(2.0 * near.edge * unit, 0.26, 2.8); }
        case 4u: {
            let shades = 0.5 + 0.5 * tenBits(pcg(near.id.xyxy), 0u);
            shown = vec3f(mix(shades.y, shades.x, min(0.5 + near.edge / pixel, 1.0)), 0.5, 0.45);
        }
        default: {}
    }
    return mix(shown.y, clamp(shown.x, 0.0, 1.0), 1.0 / (1.0 + shown.z * pixel * pixel));
}
