// Models: triangles from files, and the trees of boxes over them.

/// All models in a row, four words a texel: a texture, since software drivers read it several times as fast
/// as a storage buffer, and every device has it.
///
/// A box is 4 texels: its low corner and its first child, which the other one follows, or the first corner of
/// its triangles; its high corner and its shape; then for each octant where a ray goes on when it is done
/// with the box. So it meets near boxes first and needs no stack (Hachisuka, Multiple-Threaded BVH, 2015).
/// The shape is how many triangles the box has, none if it has children; bit 8 + o says that the second child
/// is the nearer for directions of octant o.
///
/// A corner of a triangle is 2 texels: position and u, normal of the smooth surface and v.
@group(1) @binding(15) var models: texture_2d<u32>;

/// A model, by the first texel of the box around it.
struct Model {
    root: u32,
}

const NO_BOX: u32 = 0xffffffffu;
const CHILD_TEXELS: u32 = 4u;
const TRIANGLE_TEXELS: u32 = 6u;

fn modelWords(i: u32) -> vec4u {
    return textureLoad(models, vec2u(i & 2047u, i >> 11u), 0);
}

fn modelCorner(i: u32) -> vec3f {
    return bitcast<vec3f>(modelWords(i).xyz);
}

/// Where `ray` first crosses a triangle of `model`.
fn modelCrossing(ray: Ray, model: Model) -> f32 {
    let tiny = vec3f(1e-20);
    let reciprocal = 1.0 / select(ray.direction, tiny, abs(ray.direction) < tiny);
    let octant = dot(vec3u(1u, 2u, 4u), vec3u(reciprocal < vec3f()));
    let unit = 1.0 / length(ray.direction);
    let frame = frameAround(ray.direction * unit);
    var found = NO_HIT;
    var box = model.root;
    while box != NO_BOX {
        let low = modelWords(box);
        let high = modelWords(box + 1u);
        let a = (bitcast<vec3f>(low.xyz) - ray.origin) * reciprocal;
        let b = (bitcast<vec3f>(high.xyz) - ray.origin) * reciprocal;
        let near = min(a, b);
        let far = max(a, b);
        let enters = max(max(near.x, near.y), max(near.z, ray.t_min));
        // See meetsBounds for the factor.
        let leaves = 1.0000004 * min(min(far.x, far.y), far.z);
        let triangles = high.w & 0xffu;
        let meets = enters <= min(leaves, min(found, ray.t_max));
        work++;
        if meets && triangles == 0u {
            box = low.w + CHILD_TEXELS * ((high.w >> (8u + octant)) & 1u);
            continue;
        }
        if meets {
            work += triangles;
            for (var i = 0u; i < triangles; i++) {
                let corner = low.w + TRIANGLE_TEXELS * i;
                let t = crossedTriangle(
                    ray, frame, unit, modelCorner(corner), modelCorner(corner + 2u), modelCorner(corner + 4u),
                );
                found = min(found, t);
            }
        }
        box = modelWords(box + 2u + (octant >> 2u))[octant & 3u];
    }
    return found;
}
