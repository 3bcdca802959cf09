/// Running-bond brickwork with mortar joints, every brick a little different.
///
/// scale = 4, 0.01 to 1000: courses per scene unit
/// aspect = 3, 1 to 8: length of a brick, in courses
/// mortar = 0.1, 0 to 0.5: width of a joint, as a share of a course
/// variation = 0.15, 0 to 1: how much the bricks differ in brightness
/// clay = "#a4523a": color of the bricks
/// joint = "#cfc7ba": color of the mortar
fn brick(
    at: Surface, scale: f32, aspect: f32, mortar: f32, variation: f32, clay: vec3f, joint: vec3f,
) -> vec3f {
    let p = at.uv * scale;
    let width = at.footprint * scale;
    // Even and odd courses, half a brick apart, are filtered side by side: where the footprint
    // covers several courses, neither bond is the right one.
    let rows = dutyShare(
        (vec2f(p.y, p.y - 1.0) - mortar) * 0.5, vec2f(width * 0.5), (1.0 - mortar) * 0.5);
    let along = (p.x - mortar) / aspect + vec2f(0.0, 0.5);
    let bricks = dutyShare(along, vec2f(width / aspect), 1.0 - mortar / aspect);
    let share = dot(rows, bricks);

    let course = floor(p.y);
    let odd = (i32(course) & 1) == 1;
    let column = floor(select(along.x, along.y, odd));
    let tone = tenBits(cellCorners(vec3f(column, course, 0.0)).near, 10u).x;
    let fired = clay * (1.0 + variation * tone * (1.0 - smoothstep(0.5, 2.0, width)));
    return fired * share + joint * (1.0 - share);
}
