/// Hexagonal tiles in three colors by turns, so that no two of a kind meet, with joints between.
///
/// scale = 2, 0.01 to 100: tiles per scene unit
/// gap = 0.06, 0 to 0.9: width of a joint, as a share of a tile; wide ones make a honeycomb
/// colors = 3, 1 to 3: how many of the colors are in use; with two, `first` lies strewn among `second`
/// first = "#e6dfcf": color of every third tile
/// second = "#7d9a8c": color of the next
/// third = "#33505a": color of the last
/// joint = "#c2b8a6": color of the joints
fn hexagon(
    at: Surface, scale: f32, gap: f32, colors: u32,
    first: vec3f, second: vec3f, third: vec3f, joint: vec3f,
) -> vec3f {
    let next = select(second, first, colors < 2u);
    let palette = mat3x3f(first, next, select(third, next, colors < 3u));
    let solid = (1.0 - gap) * (1.0 - gap);
    let mean = mix(joint, palette * vec3f(1.0 / 3.0), solid);
    let width = at.density * at.footprint * scale;
    if width >= 5.0 {
        return mean;
    }
    // Distances to edges are a good filter only while a footprint is smaller than a tile.
    let n = footprintParts(width, 4.0);
    let part = width / f32(n);
    var sum = vec3f(0.0);
    for (var i = 0u; i < n * n; i++) {
        let q = at.uv * scale + footprintPart(i, n, width);
        sum += hexagonTiles(q, max(part, 1e-20), gap, palette, joint);
    }
    return mix(sum / f32(n * n), mean, smoothstep(2.0, 5.0, width));
}

fn hexagonTiles(p: vec2f, width: f32, gap: f32, palette: mat3x3f, joint: vec3f) -> vec3f {
    // The tiles of one color are centered on two rectangular lattices.
    let period = vec2f(3.0, 1.7320508);
    var inside = vec3f(0.0);
    var edges = vec3f(-1.0);
    var deepest = -1.0;
    for (var i = 0u; i < 3u; i++) {
        let a = p - vec2f(f32(i), 0.0);
        let b = a - 0.5 * period;
        let near = a - period * round(a / period);
        let other = b - period * round(b / period);
        let q = select(near, other, dot(other, other) < dot(near, near));
        let slant = 0.5 * q.x + vec2f(0.8660254, -0.8660254) * q.y;
        let depths = 0.5 - abs(vec3f(q.x, slant));
        let depth = min(depths.x, min(depths.y, depths.z));
        inside[i] = depth;
        if depth > deepest {
            deepest = depth;
            edges = depths;
        }
    }
    // One weight is at least a half, even where rounding puts a point into no tile.
    let weights = saturate(0.5 + (inside - min(deepest, 0.0)) / width);
    let tiles = palette * (weights / dot(weights, vec3f(1.0)));
    let open = 1.0 - saturate(0.5 + (edges + 0.5 * gap) / width)
        + saturate(0.5 + (edges - 0.5 * gap) / width);
    return mix(joint, tiles, open.x * open.y * open.z);
}
