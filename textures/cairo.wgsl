/// Cairo paving: equal pentagons that interlock in pairs, each of a slightly different tone.
///
/// scale = 2, 0.01 to 100: pairs of tiles per scene unit
/// gap = 0.05, 0 to 0.4: width of a joint, as a share of a pair
/// variation = 0.35, 0 to 1: how much the tiles differ in brightness
/// stone = "#d2b48a": color of the tiles
/// joint = "#6b6257": color of the joints
fn cairo(
    at: Surface, scale: f32, gap: f32, variation: f32, stone: vec3f, joint: vec3f,
) -> vec3f {
    // All five sides touch one circle: a smaller tile is the same tile.
    let solid = (1.0 - gap / 0.7320508) * (1.0 - gap / 0.7320508);
    let mean = vec2f(solid, 0.0);
    let width = at.density * at.footprint * scale;
    var tile = mean;
    if width < 3.0 {
        let n = footprintParts(width, 6.0);
        let part = width / f32(n);
        var sum = vec2f(0.0);
        for (var i = 0u; i < n * n; i++) {
            let q = at.uv * scale + footprintPart(i, n, width);
            sum += cairoTile(q, max(part, 1e-20), gap);
        }
        tile = mix(sum / f32(n * n), mean, smoothstep(1.5, 3.0, width));
    }
    return stone * (tile.x * (1.0 - 0.5 * variation) + 0.5 * variation * tile.y) + joint * (1.0 - tile.x);
}

/// How much of a point is tile, and that share times the tile's tone, -1 to 1.
fn cairoTile(p: vec2f, width: f32, gap: f32) -> vec2f {
    // A short side lies in the middle of each square, level and upright by turns, and four longer
    // ones lead from its ends to the corners.
    let end = vec2f(0.21132487, 0.0);
    let slant = vec2f(-0.8660254, 0.5);
    let cell = floor(p);
    let f = p - cell - 0.5;
    let upright = ((i32(cell.x) + i32(cell.y)) & 1) == 1;
    let turned = select(f, f.yx, upright);
    let folded = abs(turned);
    let beside = dot(folded - end, slant) < 0.0;
    // What lies beside the short side belongs to a tile that stands on the next square's.
    let q = select(folded, vec2f(folded.y, 1.0 - folded.x), beside);
    let depths = vec3f(q.y, dot(q - end, slant), dot(q - 0.5, vec2f(-0.5, -0.8660254)));
    let open = 1.0 - saturate(0.5 + (depths + 0.5 * gap) / width)
        + saturate(0.5 + (depths - 0.5 * gap) / width);
    let share = open.x * open.y * open.z;

    // The side of the square that a tile straddles names the tile.
    let outward = sign(turned) * select(vec2f(0.0, 1.0), vec2f(1.0, 0.0), beside);
    let name = 2.0 * cell + select(outward, outward.yx, upright);
    let tone = tenBits(cellCorners(vec3f(name, 0.0)).near, 10u).x;
    // Halfway into the neighbor, two tones have no tone on average.
    let depth = min(depths.x, min(depths.y, depths.z));
    return share * vec2f(1.0, tone * saturate(4.0 * depth / width));
}
