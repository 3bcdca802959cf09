/// Cells as in foam, skin or scales: how far it is to scattered points or to the walls between them.
///
/// scale = 2, 0.01 to 100: points per scene unit
/// jitter = 1, 0 to 1: how far the points stray from a lattice
/// feature = f1 of f1, f2, difference, edge, cell: nearest point, the next, f2 - f1, nearest wall, or a shade
/// metric = euclidean of euclidean, manhattan, chebyshev: round cells, or two ways to angular ones
fn voronoi(at: Surface, scale: f32, jitter: f32, feature: u32, metric: u32) -> f32 {
    let p = at.position * scale;
    let pixel = max(at.footprint * scale, 1e-6);
    // From this width on a pixel shows only the mean: of walls, which are fine, sooner than of whole cells.
    let is_shade = feature == 4u;
    var last = 6.5;
    switch feature {
        case 2u: { last = 4.5; }
        case 3u: { last = 3.5; }
        case 4u: { last = 12.0; }
        default: {}
    }
    let seen = 1.0 - smoothstep(0.3 * last, last, pixel);
    var mean = 0.5;
    if seen < 1.0 && !is_shade {
        let across = min(pixel, 1e6) * sqrt(1.0 - min(at.normal * at.normal, vec3f(1.0)));
        mean = voronoiMean(p, across * across, jitter, feature, metric);
    }
    if seen == 0.0 {
        return mean;
    }
    // Manhattan's distances are long and Chebyshev's short: so all of them fill 0 to 1.
    let unit = select(select(1.0, 0.67, metric == 1u), 1.2, metric == 2u);
    let n = 1u + select(0u, 1u, pixel > 0.45) + select(0u, 1u, is_shade && pixel > 2.0);
    // Rows and columns of places lean, lest they keep step with those of a lattice.
    let lean = select(0.5 / f32(n), 0.0, is_shade);
    let sides = flatTangents(at.normal) * mat2x2f(1.0, lean, -lean, 1.0);
    let part = pixel / f32(n);
    var sum = 0.0;
    for (var i = 0u; i < n * n; i++) {
        let q = p + sides * footprintPart(i, n, pixel);
        let found = nearestCells(q, 0.25 * part * sides, jitter, metric, vec3f(0.0), feature == 3u);
        var value = found.f1 * unit;
        switch feature {
            case 1u: { value = found.f2 * unit; }
            case 2u: { value = (found.f2 - found.f1) * unit; }
            case 3u: { value = 2.0 * found.edge * unit; }
            case 4u: { value = vec4f(cellShade(found, 0.35 * part / unit)); }
            default: {}
        }
        sum += dot(saturate(value), vec4f(0.25));
    }
    return mix(mean, sum / f32(n * n), seen);
}

/// The mean over a wide pixel; `spread` is its width squared, as it lies along each axis.
fn voronoiMean(p: vec3f, spread: vec3f, jitter: f32, feature: u32, metric: u32) -> f32 {
    // The mean over all space at jitter 0, and how much it grows to jitter 1: from numerical integration, and
    // off by 0.01 at most between. Then the first two waves of the lattice along each axis at jitter 0: a
    // floor may lie all in their troughs.
    var waves = vec4f(0.477, 0.042, -0.11, 0.018);
    // f1 in three metrics, then f2, difference and edge.
    switch feature * 3u + metric {
        case 1u: { waves = vec4f(0.499, 0.008, -0.136, 0.0); }
        case 2u: { waves = vec4f(0.449, 0.055, -0.072, 0.03); }
        case 3u: { waves = vec4f(0.704, 0.013, 0.011, -0.02); }
        case 4u: { waves = vec4f(0.671, 0.035, -0.055, -0.033); }
        case 5u: { waves = vec4f(0.748, -0.056, 0.07, -0.033); }
        case 6u: { waves = vec4f(0.225, -0.027, 0.121, -0.038); }
        case 7u, 10u: { waves = vec4f(0.179, 0.017, 0.081, -0.034); }
        case 8u, 11u: { waves = vec4f(0.298, -0.107, 0.144, -0.061); }
        case 9u: { waves = vec4f(0.253, 0.003, 0.12, -0.051); }
        default: {}
    }
    let q = p + CELL_SHIFT + 0.5;
    let phase = (q - round(q)) * 6.2831853;
    // Jitter is a box: it leaves of the first wave a sinc, and of the second about the square of that. So is
    // the pixel; near enough to its sinc is exp(-π²w²/6).
    let x = 3.14159265 * max(jitter, 1e-3);
    let kept = sin(x) / x;
    return waves.x + waves.y * jitter
        + kept * waves.z * dot(cos(phase), exp(-1.645 * spread))
        + kept * kept * waves.w * dot(cos(2.0 * phase), exp(-6.58 * spread));
}
