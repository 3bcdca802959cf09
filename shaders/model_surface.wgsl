// The surface of a model at a point: that of the triangle nearest to it.

/// Points farther from a model than this share of its size are not on it.
const MODEL_REACH: f32 = 0.02;

/// A triangle as a point sees it. Lengths are shares of the model's size, that no square of one overflows.
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

/// What `model` looks like at its point `p`: a smooth normal, and the facet's.
fn modelSurface(p: vec3f, model: Model) -> Surface {
    let unit = 1.0 / distance(modelCorner(model.root), modelCorner(model.root + 1u));
    var nearest = MODEL_REACH * MODEL_REACH;
    var found = NO_BOX;
    var box = model.root;
    while box != NO_BOX {
        let low = modelWords(box);
        let high = modelWords(box + 1u);
        let outside = (p - clamp(p, bitcast<vec3f>(low.xyz), bitcast<vec3f>(high.xyz))) * unit;
        let meets = dot(outside, outside) <= nearest;
        let triangles = select(0u, high.w & 0xffu, meets);
        if meets && triangles == 0u {
            box = low.w + CHILD_TEXELS * ((high.w >> 8u) & 1u);
            continue;
        }
        for (var i = 0u; i < triangles; i++) {
            let corner = low.w + TRIANGLE_TEXELS * i;
            let away = facetDistance(modelFacet(p, corner, unit));
            found = select(found, corner, away < nearest);
            nearest = min(nearest, away);
        }
        box = modelWords(box + 2u).x;
    }
    if found == NO_BOX {
        return surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0));
    }
    return facetSurface(p, modelFacet(p, found, unit), found, unit);
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

/// The surface at `p`, which lies on `facet`, whose first corner is `i`.
fn facetSurface(p: vec3f, facet: ModelFacet, i: u32, unit: f32) -> Surface {
    let outward = facet.across * inverseSqrt(facet.squared);
    // It may lie a little beside.
    let inside = max(facet.shares, vec3f());
    let shares = inside / dot(inside, vec3f(1.0));
    // Normal and v of the corners, then their u.
    var mean = vec4f(0.0);
    var u = 0.0;
    for (var k = 0u; k < 3u; k++) {
        mean += shares[k] * bitcast<vec4f>(modelWords(i + 2u * k + 1u));
        u += shares[k] * bitcast<f32>(modelWords(i + 2u * k).w);
    }
    // Normals of the corners may cancel each other.
    let normal = normalize(select(outward, mean.xyz, dot(mean.xyz, mean.xyz) > 1e-6));
    var at = surface(p - dot(facet.q, outward) / unit * outward, normal, vec2f(u, mean.w));
    at.facet = outward;
    return at;
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
