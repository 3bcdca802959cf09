// Cellular noise (Worley, A Cellular Texture Basis Function, 1996): a lattice with a point at random in
// each of its cells, and the regions of space nearest to each point.

/// Off the lattice's own planes, where floors and walls would lie between two cells.
const CELL_SHIFT = vec3f(0.31, 0.23, 0.17);

/// What lies around four places.
struct NearestCells {
    /// Distances to the nearest point and to the next, in cells of the lattice.
    f1: vec4f,
    f2: vec4f,
    /// Distance to the nearest wall between two regions.
    edge: vec4f,
    /// Random bits of the nearest point and of the next.
    near: vec4u,
    next: vec4u,
}

/// The cells at four places, ±spread[0] ± spread[1] from `position`, which cost little more than one: most of
/// the work is to find the points. `metric` is 0 euclidean, 1 manhattan, 2 chebyshev. `walls` are those of
/// euclidean regions; without, `edge` is 0 on a wall and grows about as fast as the way to it. With a
/// `normal` other than 0 that way is along the surface, so that no wall looks wide for being met at a slant.
fn nearestCells(
    position: vec3f, spread: mat2x3f, jitter: f32, metric: u32, normal: vec3f, walls: bool,
) -> NearestCells {
    let p = position + CELL_SHIFT;
    let places = cellPlaces(spread);
    var found = NearestCells(vec4f(1e9), vec4f(1e9), vec4f(0.0), vec4u(0u), vec4u(0u));
    var home = floor(p);
    var nearest = mat3x4f();
    for (var i = 0u; i < 27u; i++) {
        let cell = floor(p) + cellNeighbor(i);
        let word = vec4u(cellCorners(cell).near.x);
        let point = cellPoint(cell - p, word.x, jitter);
        let away = cellDistance(cellWays(point, places), metric);
        let closer = away < found.f1;
        found.next = chosenBits(chosenBits(found.next, word, away < found.f2), found.near, closer);
        found.near = chosenBits(found.near, word, closer);
        found.f2 = min(found.f2, max(found.f1, away));
        found.f1 = min(found.f1, away);
        home = select(home, cell, closer.x);
        nearest[0] = select(nearest[0], vec4f(point.x), closer);
        nearest[1] = select(nearest[1], vec4f(point.y), closer);
        nearest[2] = select(nearest[2], vec4f(point.z), closer);
    }
    found.edge = 0.5 * (found.f2 - found.f1);
    if walls && metric == 0u {
        found.edge = vec4f(1e9);
        // Around the cell of the nearest point: around p, a few walls would be missed.
        for (var i = 0u; i < 27u; i++) {
            let cell = home + cellNeighbor(i);
            let point = cellPoint(cell - p, cellCorners(cell).near.x, jitter);
            let away = cellDistance(cellWays(point, places), 0u);
            let across = cellWays(point, nearest);
            let apart = cellDistance(across, 0u);
            let slant = across * normal;
            // To the plane halfway between two points; a point has none towards itself.
            let wall = 0.5 * (away * away - found.f1 * found.f1)
                * inverseSqrt(max(apart * apart - slant * slant, 1e-4 * apart * apart));
            found.edge = min(found.edge, select(wall, vec4f(1e9), apart < vec4f(1e-3)));
        }
    }
    return found;
}

/// The random shades of regions, 0 to 1, as a mean over the four places, blurred over `width`.
fn cellShade(found: NearestCells, width: f32) -> f32 {
    let other = tenBits(pcg(found.next), 0u);
    let shades = mix(other, tenBits(pcg(found.near), 0u), min(0.5 + found.edge / width, vec4f(1.0)));
    return 0.5 + 0.125 * dot(shades, vec4f(1.0));
}

fn cellNeighbor(i: u32) -> vec3f {
    return vec3f(f32(i % 3u), f32(i / 3u % 3u), f32(i / 9u)) - 1.0;
}

/// The point of a cell that begins at `corner`; seen from there it keeps its digits far from the origin.
fn cellPoint(corner: vec3f, word: u32, jitter: f32) -> vec3f {
    let bits = (vec3u(word) >> vec3u(0u, 10u, 20u)) & vec3u(1023u);
    return corner + 0.5 + jitter * (vec3f(bits) / 1023.0 - 0.5);
}

/// x, y and z of four places.
fn cellPlaces(spread: mat2x3f) -> mat3x4f {
    return transpose(mat4x3f(-spread[0] - spread[1], spread[0] - spread[1],
        spread[1] - spread[0], spread[0] + spread[1]));
}

/// The ways from four places to `point`.
fn cellWays(point: vec3f, places: mat3x4f) -> mat3x4f {
    return mat3x4f(point.x - places[0], point.y - places[1], point.z - places[2]);
}

fn cellDistance(ways: mat3x4f, metric: u32) -> vec4f {
    switch metric {
        case 1u: { return abs(ways[0]) + abs(ways[1]) + abs(ways[2]); }
        case 2u: { return max(abs(ways[0]), max(abs(ways[1]), abs(ways[2]))); }
        default: { return sqrt(ways[0] * ways[0] + ways[1] * ways[1] + ways[2] * ways[2]); }
    }
}
