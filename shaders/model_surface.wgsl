// The surface of a model at a point: that of the triangle nearest to it.

/// Points farther from a model than this share of its size are not on it.
const MODEL_REACH: f32 = 0.02;

/// What `model` looks like at its point `p`: a smooth normal, and the facet's.
fn modelSurface(p: vec3f, model: Model) -> Surface {
    let reach = MODEL_REACH * distance(modelCorner(model.root), modelCorner(model.root + 1u));
    var nearest = reach * reach;
    var found = NO_BOX;
    var box = model.root;
    while box != NO_BOX {
        let low = modelWords(box);
        let high = modelWords(box + 1u);
        let outside = p - clamp(p, bitcast<vec3f>(low.xyz), bitcast<vec3f>(high.xyz));
        let triangles = high.w & 0xffu;
        let meets = dot(outside, outside) <= nearest;
        if meets && triangles == 0u {
            box = low.w + CHILD_TEXELS * ((high.w >> 8u) & 1u);
            continue;
        }
        if meets {
            for (var i = 0u; i < triangles; i++) {
                let corner = low.w + TRIANGLE_TEXELS * i;
                let away = modelDistance(p, corner);
                found = select(found, corner, away < nearest);
                nearest = min(nearest, away);
            }
        }
        box = modelWords(box + 2u).x;
    }
    if found == NO_BOX {
        return surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0));
    }
    return modelPlace(p, found);
}

/// The surface at `p`, which lies on the triangle whose first corner is `i`.
fn modelPlace(p: vec3f, i: u32) -> Surface {
    let a = modelCorner(i);
    let b = modelCorner(i + 2u);
    let c = modelCorner(i + 4u);
    let across = cross(b - a, c - a);
    let squared = max(dot(across, across), 1e-36);
    let facet = across * inverseSqrt(squared);
    let q = p - a;
    let second = dot(cross(q, c - a), across) / squared;
    let third = dot(cross(b - a, q), across) / squared;
    let shares = vec3f(1.0 - second - third, second, third);
    // Normal and v of the corners, then their u.
    var mean = vec4f(0.0);
    var u = 0.0;
    for (var k = 0u; k < 3u; k++) {
        mean += shares[k] * bitcast<vec4f>(modelWords(i + 2u * k + 1u));
        u += shares[k] * bitcast<f32>(modelWords(i + 2u * k).w);
    }
    var at = surface(p - dot(q, facet) * facet, normalize(mean.xyz), vec2f(u, mean.w));
    at.facet = facet;
    return at;
}

/// The square of the distance from `p` to the triangle whose first corner is `i`.
fn modelDistance(p: vec3f, i: u32) -> f32 {
    let a = modelCorner(i);
    let b = modelCorner(i + 2u);
    let c = modelCorner(i + 4u);
    let across = cross(b - a, c - a);
    let sides = vec3f(
        dot(cross(b - a, p - a), across),
        dot(cross(c - b, p - b), across),
        dot(cross(a - c, p - c), across),
    );
    if all(sides >= vec3f()) {
        let height = dot(p - a, across);
        return height * height / max(dot(across, across), 1e-36);
    }
    return min(min(edgeDistance(p - a, b - a), edgeDistance(p - b, c - b)), edgeDistance(p - c, a - c));
}

/// The square of the distance from `q` to the edge from the origin to `end`.
fn edgeDistance(q: vec3f, end: vec3f) -> f32 {
    let away = q - clamp(dot(q, end) / max(dot(end, end), 1e-36), 0.0, 1.0) * end;
    return dot(away, away);
}
