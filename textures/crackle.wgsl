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
    // Walls of cubes cross the surface in three sets of lines. Those of scattered cells leave what some 2.2
    // sets would: measured at widths from 0.02 to 0.5, to within 0.005.
    let open = 1.0 - width * sqrt(1.0 - min(at.normal * at.normal, vec3f(1.0)));
    let regular = log(max(open.x * open.y * open.z, 1e-9));
    let scattered = (2.24 - 0.1 * width) * log(1.0 - width);
    let afar = 1.0 - exp(mix(regular, scattered, jitter * jitter));
    // A wide pixel holds more plates than are worth asking, and those with narrow cracks are soon all alike.
    let wide = width > 0.07;
    let seen = 1.0 - select(smoothstep(0.8, 1.6, pixel), smoothstep(2.0, 3.2 + 1.6 * jitter, pixel), wide);
    var share = afar;
    var tone = 0.0;
    if seen > 0.0 {
        let sides = flatTangents(at.normal);
        let n = 1u + select(0u, 1u, wide && pixel > 0.4) + select(0u, 1u, wide && pixel > 0.9);
        let part = 0.5 * pixel / f32(n);
        // Walls beyond the nearest count too: about so much more, as measured.
        let more = 1.0 + 0.8 * part * part * (1.0 / (part + 2.0 * width) + part);
        let half = vec4f(0.5 * width * more);
        var covered = 0.0;
        for (var i = 0u; i < n * n; i++) {
            let p = at.position * scale + sides * footprintPart(i, n, pixel);
            let found = nearestCells(p, 0.5 * part * sides, jitter, 0u, at.normal, true);
            // How much of a quarter of the part lies in the crack, which goes on behind the wall.
            let inside = saturate(0.5 + (half - found.edge) / part)
                - saturate(0.5 - (half + found.edge) / part);
            covered += dot(inside, vec4f(0.25));
            tone += dot(tenBits(pcg(found.near), 0u), vec4f(0.25));
        }
        share = mix(afar, covered / f32(n * n), seen);
        tone *= variation * seen / f32(n * n);
    }
    // No plate outshines white, unless its own color does.
    let dried = min(plate * (1.0 + tone), max(plate, vec3f(1.0)));
    return dried * (1.0 - share) + crack * share;
}
