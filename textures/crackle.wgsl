/// Dried mud: plates of every shape with thin cracks between them.
///
/// scale = 1.8, 0.01 to 100: plates per scene unit
/// jitter = 1, 0 to 1: how irregular the plates are
/// width = 0.05, 0 to 0.5: width of the cracks, as a share of a plate
/// variation = 0.2, 0 to 1: how much the plates differ in brightness
/// plate = "#b39069": color of the plates
/// crack = "#35281e": color of the cracks
fn crackle(
    at: Surface, scale: f32, jitter: f32, width: f32, variation: f32, plate: vec3f, crack: vec3f,
) -> vec3f {
    let pixel = max(at.footprint * scale, 1e-6);
    // Walls of cubes met head on take the square of what is solid, those of other cells a little more.
    let afar = 1.0 - pow(1.0 - width, mix(2.0, 2.28, jitter));
    // A wide pixel holds more plates than are worth asking, and those with narrow cracks are soon all alike.
    let wide = width > 0.07;
    let seen = 1.0 - select(smoothstep(0.8, 1.6, pixel), smoothstep(1.4, 2.6, pixel), wide);
    var share = afar;
    var tone = 0.0;
    if seen > 0.0 {
        let sides = flatTangents(at.normal);
        let n = select(1u, 2u, wide && pixel > 0.4);
        let part = 0.5 * pixel / f32(n);
        // Walls beyond the nearest count too: about so much more, as measured.
        let more = (1.0 + 0.8 * part * part / (part + 2.0 * width + 1e-6)) / part;
        let half = vec4f(0.5 * width);
        var covered = 0.0;
        for (var i = 0u; i < n * n; i++) {
            let p = at.position * scale + sides * footprintPart(i, n, pixel);
            let found = nearestCells(p, 0.5 * part * sides, jitter, 0u, at.normal, true);
            // How much of a quarter of the part lies in the crack, which goes on behind the wall.
            let inside = clamp(found.edge + 0.5 * part, -half, half)
                - clamp(found.edge - 0.5 * part, -half, half);
            covered += dot(min(inside * more, vec4f(1.0)), vec4f(0.25));
            tone += dot(tenBits(pcg(found.near), 0u), vec4f(0.25));
        }
        share = mix(afar, covered / f32(n * n), seen);
        tone *= variation * seen / f32(n * n);
    }
    // No plate outshines white, unless its own color does.
    let dried = min(plate * (1.0 + tone), max(plate, vec3f(1.0)));
    return dried * (1.0 - share) + crack * share;
}
