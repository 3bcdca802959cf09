/// Brickwork with mortar joints, every brick a little different.
///
/// scale = 4, 0.01 to 1000: courses per scene unit
/// aspect = 3, 1 to 8: length of a brick, in courses
/// bond = running of running, stack, third: shift of a course: half a brick, none, or a third
/// mortar = 0.1, 0 to 0.5: width of a joint, as a share of a course
/// variation = 0.15, 0 to 1: how much the bricks differ in brightness
/// clay = "#a4523a": color of the bricks
/// joint = "#cfc7ba": color of the mortar
fn brick(
    at: Surface, scale: f32, aspect: f32, bond: u32, mortar: f32, variation: f32,
    clay: vec3f, joint: vec3f,
) -> vec3f {
    let p = at.uv * scale;
    let width = at.density * at.footprint * scale;
    // The courses of a bond's period are filtered side by side: where the footprint covers several
    // courses, no one's shift is the right one.
    let period = select(select(3, 1, bond == 1u), 2, bond == 0u);
    let courses = f32(period);
    let along = (p.x - mortar) / aspect;
    var share = 0.0;
    for (var i = 0; i < period; i += 2) {
        let pair = vec2f(f32(i), f32(i + 1));
        let rows = dutyShare(
            (p.y - pair - mortar) / courses, vec2f(width / courses), (1.0 - mortar) / courses);
        let bricks = dutyShare(along + pair / courses, vec2f(width / aspect), 1.0 - mortar / aspect);
        share += dot(rows, select(vec2f(0.0), bricks, pair < vec2f(courses)));
    }

    let course = floor(p.y);
    let turn = floorRemainder(i32(course), u32(period));
    let column = floor(along + f32(turn) / courses);
    let tone = tenBits(cellCorners(vec3f(column, course, 0.0)).near, 10u).x;
    let lit = clay * (1.0 + variation * tone * (1.0 - smoothstep(0.5, 2.0, width)));
    // No brick outshines white, unless its clay does.
    let fired = min(lit, max(clay, vec3f(1.0)));
    // Far from the origin, rounding may let a third of a period overlap the next.
    let solid = select(share, min(share, 1.0), period == 3);
    return fired * solid + joint * (1.0 - solid);
}
