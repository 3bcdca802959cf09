// The surface of a model at a point: that of the triangle nearest to it.

/// Points farther from a model than this share of its size are not on it.
const MODEL_REACH: f32 = 0.02;

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

/// The surface at `p`, which lies on `facet`, whose first corner is `i`.
fn facetSurface(p: vec3f, facet: ModelFacet, i: u32, unit: f32) -> Surface {
    let outward = facet.across * inverseSqrt(facet.squared);
    // It may lie a little beside.
    let inside = max(facet.shares, vec3f());
    let shares = inside / dot(inside, vec3f(1.0));
    var mean = vec3f(0.0);
    var uv = mat3x2f();
    // The smooth surface is about as high as the mean of the planes that touch it at the corners
    // (Hanika, Hacking the Shadow Terminator, in: Ray Tracing Gems II, 2021).
    let from_corners = mat3x3f(facet.q, facet.q - facet.ab, facet.q - facet.ac);
    var rise = 0.0;
    for (var k = 0u; k < 3u; k++) {
        let normal_and_v = bitcast<vec4f>(modelWords(i + 2u * k + 1u));
        mean += shares[k] * normal_and_v.xyz;
        uv[k] = vec2f(bitcast<f32>(modelWords(i + 2u * k).w), normal_and_v.w);
        let below = max(-dot(from_corners[k], normal_and_v.xyz), 0.0);
        rise += shares[k] * below * max(dot(normal_and_v.xyz, outward), 0.0);
    }
    // Normals of the corners may cancel each other.
    let normal = normalize(select(outward, mean, dot(mean, mean) > 1e-6));
    var at = surface(p - dot(facet.q, outward) / unit * outward, normal, uv * shares);
    at.geometric_normal = outward;
    at.rise = rise / unit;
    // Of the areas, as uv has it and as it is.
    let doubled = determinant(mat2x2f(uv[1] - uv[0], uv[2] - uv[0]));
    at.density = sqrt(abs(doubled) * inverseSqrt(facet.squared)) * unit;
    return at;
}
