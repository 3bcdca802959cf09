// Cellular noise (Worley, A Cellular Texture Basis Function, 1996): a lattice with a point at random in
// each of its cells, and the regions of space nearest to each point.

/// Off the lattice's own planes, where floors and walls would lie between two cells.
const CELL_SHIFT = vec3f(0.31, 0.23, 0.17);

struct NearestCells {
    /// Distances to the nearest point and to the next, in cells of the lattice.
    f1: f32,
    f2: f32,
    /// Distance to the nearest wall between two regions.
    edge: f32,
    /// Random bits of the two points.
    id: vec2u,
}

/// `metric` is 0 euclidean, 1 manhattan, 2 chebyshev. With a `normal` other than 0 the way to a wall is
/// measured along the surface there, so that no wall looks wide for being met at a slant.
/// Without `walls` only the wall between the two nearest points counts; in one place of seven another is
/// nearer.
fn nearestCells(position: vec3f, jitter: f32, metric: u32, normal: vec3f, walls: bool) -> NearestCells {
    let p = position + CELL_SHIFT;
    var found = NearestCells(1e9, 1e9, 1e9, vec2u(0u));
    var home = floor(p);
    var nearest = vec3f(0.0);
    var next = vec3f(0.0);
    for (var i = 0u; i < 27u; i++) {
        let cell = floor(p) + cellNeighbor(i);
        let word = cellCorners(cell).near.x;
        let point = cellPoint(cell - p, word, jitter);
        let away = cellDistance(point, metric);
        if away < found.f1 {
            found.f2 = found.f1;
            found.f1 = away;
            found.id = vec2u(word, found.id.x);
            next = nearest;
            nearest = point;
            home = cell;
        } else if away < found.f2 {
            found.f2 = away;
            found.id.y = word;
            next = point;
        }
    }
    // Regions of the other metrics have crooked walls; this is 0 on them and grows about as fast.
    found.edge = 0.5 * (found.f2 - found.f1);
    if metric == 0u {
        found.edge = cellWall(nearest, next, normal);
    }
    if walls && metric == 0u {
        // Around the cell of the nearest point: around p, a few walls would be missed.
        for (var i = 0u; i < 27u; i++) {
            let cell = home + cellNeighbor(i);
            let point = cellPoint(cell - p, cellCorners(cell).near.x, jitter);
            found.edge = min(found.edge, cellWall(nearest, point, normal));
        }
    }
    return found;
}

fn cellNeighbor(i: u32) -> vec3f {
    return vec3f(f32(i % 3u), f32(i / 3u % 3u), f32(i / 9u)) - 1.0;
}

/// The point of a cell that begins at `corner`; seen from there it keeps its digits far from the origin.
fn cellPoint(corner: vec3f, word: u32, jitter: f32) -> vec3f {
    let bits = (vec3u(word) >> vec3u(0u, 10u, 20u)) & vec3u(1023u);
    return corner + 0.5 + jitter * (vec3f(bits) / 1023.0 - 0.5);
}

fn cellDistance(v: vec3f, metric: u32) -> f32 {
    let a = abs(v);
    switch metric {
        case 1u: { return a.x + a.y + a.z; }
        case 2u: { return max(a.x, max(a.y, a.z)); }
        default: { return length(v); }
    }
}

/// Distance to the plane halfway between two points.
fn cellWall(from_: vec3f, to: vec3f, normal: vec3f) -> f32 {
    let across = to - from_;
    let apart = length(across);
    // A point has no wall towards itself.
    if apart < 1e-3 {
        return 1e9;
    }
    let slant = dot(across, normal) / apart;
    return 0.5 * dot(from_ + to, across) / apart * inverseSqrt(max(1.0 - slant * slant, 1e-4));
}
