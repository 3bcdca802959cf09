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
    let far = smoothstep(0.8, 1.6, pixel);
    var share = 1.0 - pow(1.0 - width, mix(2.0, 2.28, jitter));
    var tone = 0.0;
    if far < 1.0 {
        let part = 0.5 * pixel;
        let spread = 0.5 * part * flatTangents(at.normal);
        let found = nearestCells(at.position * scale, spread, jitter, 0u, at.normal, true);
        // How much of a quarter of the pixel lies in the crack, which goes on behind the wall.
        let half = vec4f(0.5 * width);
        let inside = clamp(found.edge + 0.5 * part, -half, half)
            - clamp(found.edge - 0.5 * part, -half, half);
        // Walls beyond the nearest count too: about so much more, as measured.
        let more = 1.0 + 0.8 * part * part / (part + 2.0 * width + 1e-6);
        let covered = dot(min(inside * more / part, vec4f(1.0)), vec4f(0.25));
        share = mix(covered, share, far);
        tone = variation * (1.0 - far) * dot(tenBits(pcg(found.near), 0u), vec4f(0.25));
    }
    // No plate outshines white, unless its own color does.
    let dried = min(plate * (1.0 + tone), max(plate, vec3f(1.0)));
    return dried * (1.0 - share) + crack * share;
}
