/// A mosaic of flat stones without joints, each in a mixture of its own of two colors.
///
/// scale = 2.5, 0.01 to 100: stones per scene unit
/// jitter = 1, 0 to 1: how irregular they are
/// first = "#d9c7a3": one color of the mixture
/// second = "#4b6a63": the other
fn cells(at: Surface, scale: f32, jitter: f32, first: vec3f, second: vec3f) -> vec3f {
    let pixel = max(at.footprint * scale, 1e-6);
    let near = nearestCells(at.position * scale, jitter, 0u, at.normal, false);
    // At a wall the pixel holds both stones, and in the distance so many that their mean is left.
    let tones = 0.5 + 0.5 * tenBits(pcg(near.id.xyxy), 0u);
    let tone = mix(tones.y, tones.x, min(0.5 + near.edge / pixel, 1.0));
    let share = mix(0.5, tone, 1.0 / (1.0 + 0.45 * pixel * pixel));
    return first * (1.0 - share) + second * share;
}
