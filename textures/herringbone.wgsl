/// Parquet: blocks laid in zigzags, each at right angles to the end of the next.
///
/// scale = 3, 0.01 to 100: widths of a block per scene unit
/// aspect = 4, 2 to 12: length of a block, in widths
/// gap = 0.05, 0 to 0.5: width of a joint, as a share of a block's width
/// variation = 0.5, 0 to 1: how much the blocks differ in brightness
/// wood = "#be8549": color of the blocks
/// joint = "#3a2616": color of the joints
fn herringbone(
    at: Surface, scale: f32, aspect: u32, gap: f32, variation: f32, wood: vec3f, joint: vec3f,
) -> vec3f {
    let mean = vec2f((1.0 - gap) * (1.0 - gap / f32(aspect)), 0.0);
    let width = at.density * at.footprint * scale;
    var block = mean;
    if width < 6.0 {
        let n = footprintParts(width, 4.0);
        let part = width / f32(n);
        var sum = vec2f(0.0);
        for (var i = 0u; i < n * n; i++) {
            let q = at.uv * scale + footprintPart(i, n, width);
            sum += herringboneBlock(q, max(part, 1e-20), i32(aspect), gap);
        }
        block = mix(sum / f32(n * n), mean, smoothstep(2.0, 6.0, width));
    }
    return wood * (block.x * (1.0 - 0.5 * variation) + 0.5 * variation * block.y) + joint * (1.0 - block.x);
}

/// How much of a point is wood, and that share times the block's tone, -1 to 1.
fn herringboneBlock(p: vec2f, width: f32, aspect: i32, gap: f32) -> vec2f {
    // A row of squares is a level block, then one square of each of as many upright blocks; the
    // next row is the same, one square on.
    let cell = floor(p);
    let period = 2 * aspect;
    let phase = i32(floorRemainder(i32(cell.x) - i32(cell.y), u32(period)));
    let upright = phase >= aspect;
    let behind = f32(select(phase, period - 1 - phase, upright));
    let f = p - cell;
    let q = select(f, f.yx, upright) + vec2f(behind, 0.0);
    let depths = min(q, vec2f(f32(aspect), 1.0) - q);
    let open = 1.0 - saturate(0.5 + (depths + 0.5 * gap) / width)
        + saturate(0.5 + (depths - 0.5 * gap) / width);
    let share = open.x * open.y;

    let start = cell - select(vec2f(behind, 0.0), vec2f(0.0, behind), upright);
    let tone = tenBits(cellCorners(vec3f(start, 0.0)).near, 10u).x;
    // Halfway into the neighbor, two tones have no tone on average.
    return share * vec2f(1.0, tone * saturate(4.0 * min(depths.x, depths.y) / width));
}
