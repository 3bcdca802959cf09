/// A mosaic of flat stones without joints, each in a mixture of its own of two colors.
///
/// scale = 2.5, 0.01 to 100: stones per scene unit
/// jitter = 1, 0 to 1: how irregular they are
/// first = "#d9c7a3": one color of the mixture
/// second = "#4b6a63": the other
fn cells(at: Surface, scale: f32, jitter: f32, first: vec3f, second: vec3f) -> vec3f {
    let pixel = max(at.footprint * scale, 1e-6);
    let near = nearestCells(at.position * scale, jitter, 0u, at.normal, false);
    // At a wall the pixel holds both stones.
    let tones = 0.5 + 0.5 * tenBits(pcg(near.id.xyxy), 0u);
    var share = mix(tones.y, tones.x, min(0.5 + near.edge / pixel, 1.0));
    if pixel > 0.3 {
        share = mix(share, cellsMean(at, scale, jitter, pixel), smoothstep(0.3, 1.0, pixel));
    }
    return first * (1.0 - share) + second * share;
}

/// The mean over a pixel that holds several stones.
fn cellsMean(at: Surface, scale: f32, jitter: f32, pixel: f32) -> f32 {
    // The stones of nearestCells, each counted by how far its point is along the surface and away from
    // it: what lies deep down hardly shows, however wide the pixel. Fitted to true means.
    let p = at.position * scale + CELL_SHIFT;
    let wide = 0.22 * pixel + 0.08 * pixel * pixel * pixel;
    let deep = 0.25 * pixel * inverseSqrt(pixel * pixel + 0.65);
    var sum = vec2f(0.0);
    for (var i = 0u; i < 27u; i++) {
        let cell = floor(p) + cellNeighbor(i);
        let word = cellCorners(cell).near.x;
        let point = cellPoint(cell - p, word, jitter);
        let depth = dot(point, at.normal);
        let aside = point - depth * at.normal;
        let weight = exp(-dot(aside, aside) / wide - depth * depth / deep);
        sum += weight * vec2f(tenBits(pcg(vec4u(word)), 0u).x, 1.0);
    }
    // A wider pixel holds stones that are not asked.
    let beyond = pixel * pixel / 18.5;
    return 0.5 + 0.5 * sum.x / sum.y / (1.0 + beyond * beyond);
}
