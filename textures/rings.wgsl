/// Concentric rings of two colors around the y axis, like a target.
///
/// scale = 1.25, 0.01 to 100: rings of each color per scene unit
/// duty = 0.5, 0 to 1: share of the width that the even rings take
/// even = "#a8473f": color of the disc in the middle and of each other ring
/// odd = "#ece2cf": color of the rings between
fn rings(at: Surface, scale: f32, duty: f32, even: vec3f, odd: vec3f) -> vec3f {
    let width = at.footprint * scale;
    // Near the axis a wide pixel sees the rings bend.
    let p = at.position.xz * scale;
    let n = footprintParts(width / max(length(p), 1e-6), 2.0);
    let part = width / f32(n);
    var share = 0.0;
    for (var i = 0u; i < n * n; i++) {
        let q = p + footprintPart(i, n, width);
        let away = length(q);
        // A square reaches farther across a ring that it meets at an angle.
        let reach = abs(q) / max(away, 1e-12) * part;
        // Nothing lies beyond the axis.
        let ring = max(away, 0.5 * max(reach.x, reach.y));
        share += dutySquareShare(ring, reach, duty) / f32(n * n);
    }
    return even * share + odd * (1.0 - share);
}
