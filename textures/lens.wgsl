/// Lays a magnifying glass onto a texture, or one that makes small.
///
/// strength = 0.7, -1 to 1: above 0 the middle bulges, below 0 it is pinched
/// center = (0, 0, 0), -10 to 10: middle of the glass; of uv, the first two
/// radius = 2.5, 0.01 to 100: where its effect ends, in scene units
fn lens(at: Surface, strength: f32, center: vec3f, radius: f32) -> Surface {
    let bend = clamp(strength, -1.0, 1.0);
    let d = at.position - center;
    let e = at.uv - center.xy;
    // (1 - t)^2 of the squared distance ends without a crease, and folds nothing for |bend| <= 1.
    let t = min(vec2f(dot(d, d), dot(e, e)) / max(radius * radius, 1e-8), vec2f(1.0));
    let around = 1.0 - bend * (1.0 - t) * (1.0 - t);
    let outwards = around + 4.0 * bend * t * (1.0 - t);
    // The root mean square of both.
    let stretch = sqrt(0.5 * (around * around + outwards * outwards));
    var moved = at;
    moved.position = center + d * around.x;
    moved.uv = center.xy + e * around.y;
    moved.footprint *= max(stretch.x, stretch.y);
    return moved;
}
