/// Twists a texture around the y axis, and its uv around their origin, like cream in a cup.
///
/// strength = 1.5, -10 to 10: growth of the turn at the axis, radians per scene unit
/// radius = 2, 0.1 to 20: distance over which it levels off, in scene units
fn swirl(at: Surface, strength: f32, radius: f32) -> Surface {
    var moved = at;
    let turned = swirlTurn(at.position.xz, strength, radius);
    moved.position = vec3f(turned.x, at.position.y, turned.y);
    moved.uv = swirlTurn(at.uv, strength, radius);
    // A turn that grows outwards is a shear; of its stretch, the root mean square over all directions.
    let away = vec2f(length(at.position.xz), length(at.uv));
    let shear = strength * away * exp(-away / max(radius, 1e-3));
    let stretch = sqrt(1.0 + 0.5 * shear * shear);
    moved.footprint *= max(stretch.x, stretch.y);
    return moved;
}

fn swirlTurn(p: vec2f, strength: f32, radius: f32) -> vec2f {
    // Without an end to its growth, the twist would tear a far floor into dots finer than a pixel.
    let level = max(radius, 1e-3);
    let turns = strength * level * (1.0 - exp(-length(p) / level)) / 6.2831853;
    // sin and cos are only sure between -pi and pi.
    let angle = (turns - round(turns)) * 6.2831853;
    let c = cos(angle);
    let s = sin(angle);
    return vec2f(c * p.x - s * p.y, s * p.x + c * p.y);
}
