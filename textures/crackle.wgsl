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
    let near = nearestCells(at.position * scale, jitter, 0u, at.normal, true);
    // How much of the pixel lies in the crack, which goes on behind the wall.
    let ends = clamp(near.edge + vec2f(-0.5, 0.5) * pixel, vec2f(-0.5 * width), vec2f(0.5 * width));
    // A pixel over several plates has more walls: those of cubes take this share of space, and
    // those of other cells nearly the same.
    let solid = 1.0 - width;
    let seen = 1.0 - smoothstep(0.4, 1.5, pixel);
    let covered = min((ends.y - ends.x) / pixel, 1.0);
    let share = mix(1.0 - solid * solid * solid, covered, seen);
    let tone = variation * seen * tenBits(pcg(near.id.xxxx), 0u).x;
    // No plate outshines white, unless its own color does.
    let dried = min(plate * (1.0 + tone), max(plate, vec3f(1.0)));
    return dried * (1.0 - share) + crack * share;
}
