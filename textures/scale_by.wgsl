/// Stretches a texture about the origin: 2 makes its features twice as large, 0.5 half as large.
///
/// amount = (2, 2, 2), 0.01 to 100: growth along x, y and z; uv grows by the first two
fn scaleBy(at: Surface, amount: vec3f) -> Surface {
    // A pattern may give the amount, and so 0.
    let growth = max(amount, vec3f(1e-3));
    var moved = at;
    moved.position /= growth;
    moved.uv /= growth.xy;
    moved.normal = normalize(at.normal * growth);
    // The root mean square of the stretch over all directions of the surface, and over those of uv.
    let crowding = 1.0 / (growth * growth);
    let stretch = max(dot(crowding, 1.0 - at.normal * at.normal), crowding.x + crowding.y);
    moved.footprint *= sqrt(0.5 * stretch);
    return moved;
}
