/// Pushes a texture along by the value of another one.
///
/// by = (1, 0.5, 0.5), 0 to 1: any texture: 0.5 moves nothing; a color moves x, y and z each by itself
/// amount = 0.5, -10 to 10: way from where `by` is 0 to where it is 1, in scene units
/// direction = (1, 1, 1), -10 to 10: which way, times the amount; uv goes by the first two
/// slope = 1, 0 to 20: growth of `by` per scene unit; steeper ones need a wider filter
fn displace(at: Surface, by: vec3f, amount: f32, direction: vec3f, slope: f32) -> Surface {
    let reach = amount * direction;
    let push = (by - 0.5) * reach;
    var moved = at;
    moved.position -= push;
    moved.uv -= push.xy;
    // No derivative of `by` is at hand: the stretch is that of a shear by the slope given, until a
    // pixel holds all that `by` can be.
    let change = slope * at.footprint;
    let spread = dot(reach, reach) * min(0.5 * change * change, 0.2);
    moved.footprint = sqrt(at.footprint * at.footprint + spread);
    return moved;
}
