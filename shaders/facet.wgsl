// A triangle of a model as a point near it sees it.

/// Lengths are shares of the model's size, that no square of one overflows.
struct ModelFacet {
    /// From the first corner to the point, and to the other corners.
    q: vec3f,
    ab: vec3f,
    ac: vec3f,
    /// Outward, as long as the area twice, and the square of that.
    across: vec3f,
    squared: f32,
    /// How near the point is to each corner: where it lies over the triangle, shares of `squared`.
    shares: vec3f,
}

/// The triangle whose first corner is `i`.
fn modelFacet(p: vec3f, i: u32, unit: f32) -> ModelFacet {
    let a = modelCorner(i);
    let q = (p - a) * unit;
    let ab = (modelCorner(i + 2u) - a) * unit;
    let ac = (modelCorner(i + 4u) - a) * unit;
    let across = cross(ab, ac);
    let squared = dot(across, across);
    let second = dot(cross(q, ac), across);
    let third = dot(cross(ab, q), across);
    return ModelFacet(q, ab, ac, across, squared, vec3f(squared - second - third, second, third));
}

/// The square of the distance to `facet`. One without area only closes a seam, and is nowhere near.
fn facetDistance(facet: ModelFacet) -> f32 {
    let longest = max(dot(facet.ab, facet.ab), dot(facet.ac, facet.ac));
    if facet.squared <= 1e-12 * longest * longest {
        return 1.0;
    }
    if all(facet.shares >= vec3f()) {
        let height = dot(facet.q, facet.across);
        return height * height / facet.squared;
    }
    let opposite = edgeDistance(facet.q - facet.ab, facet.ac - facet.ab);
    return min(min(edgeDistance(facet.q, facet.ab), edgeDistance(facet.q, facet.ac)), opposite);
}

/// The square of the distance from `q` to the edge from the origin to `end`.
fn edgeDistance(q: vec3f, end: vec3f) -> f32 {
    let away = q - clamp(dot(q, end) / max(dot(end, end), 1e-36), 0.0, 1.0) * end;
    return dot(away, away);
}
