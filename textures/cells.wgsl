/// A mosaic of flat stones without joints, each in a mixture of its own of two colors.
///
/// scale = 2.5, 0.01 to 100: stones per scene unit
/// jitter = 1, 0 to 1: how irregular they are
/// first = "#d9c7a3": one color of the mixture
/// second = "#4b6a63": the other
fn cells(at: Surface, scale: f32, jitter: f32, first: vec3f, second: vec3f) -> vec3f {
    let pixel = max(at.footprint * scale, 1e-6);
    // A wide pixel holds more stones than are worth asking.
    let seen = 1.0 - smoothstep(3.6, 12.0, pixel);
    var share = 0.5;
    if seen > 0.0 {
        let sides = flatTangents(at.normal);
        let n = 1u + select(0u, 1u, pixel > 0.45) + select(0u, 1u, pixel > 2.0);
        let part = pixel / f32(n);
        var sum = 0.0;
        for (var i = 0u; i < n * n; i++) {
            let p = at.position * scale + sides * footprintPart(i, n, pixel);
            let found = nearestCells(p, 0.25 * part * sides, jitter, 0u, at.normal, false);
            sum += cellShade(found, 0.35 * part);
        }
        share = mix(0.5, sum / f32(n * n), seen);
    }
    return first * (1.0 - share) + second * share;
}
