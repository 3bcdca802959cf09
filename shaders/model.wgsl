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
    /// Whether its file has uv, which go from 0 to 1.
    has_uv: bool,
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
    // The ray starts anew where it enters the ball around the model: far away it has fewer digits.
    let lowest = modelCorner(model.root);
    let highest = modelCorner(model.root + 1u);
    let radius = 0.5 * distance(lowest, highest);
    let start = max(nearestApproach(ray, 0.5 * (lowest + highest)) - radius * unit, 0.0);
    let origin = rayPoint(ray, start);
    let rest = Ray(origin, ray.t_min - start, ray.direction, ray.t_max - start);
    // A box must hold what crossedTriangle finds in it: that turns corners, which moves them by up to ten
    // roundings of their distance.
    let farthest = max(abs(lowest - origin), abs(highest - origin));
    let slack = 6e-7 * (farthest.x + farthest.y + farthest.z) * abs(reciprocal);
    var found = NO_HIT;
    var box = model.root;
    while box != NO_BOX {
        let low = modelWords(box);
        let high = modelWords(box + 1u);
        let to_low = (bitcast<vec3f>(low.xyz) - origin) * reciprocal;
        let to_high = (bitcast<vec3f>(high.xyz) - origin) * reciprocal;
        let near = min(to_low, to_high) - slack;
        let far = max(to_low, to_high) + slack;
        let enters = max(max(near.x, near.y), max(near.z, rest.t_min));
        let leaves = min(min(far.x, far.y), far.z);
        let triangles = high.w & 0xffu;
        let meets = enters <= min(leaves, min(found, rest.t_max));
        work++;
        if meets && triangles == 0u {
            box = low.w + CHILD_TEXELS * ((high.w >> (8u + octant)) & 1u);
            continue;
        }
        if meets {
            work += triangles;
            for (var i = 0u; i < triangles; i++) {
                let corner = low.w + TRIANGLE_TEXELS * i;
                let a = modelCorner(corner);
                let b = modelCorner(corner + 2u);
                let c = modelCorner(corner + 4u);
                found = min(found, crossedTriangle(rest, frame, unit, a, b, c));
            }
        }
        box = modelWords(box + 2u + (octant >> 2u))[octant & 3u];
    }
    return select(NO_HIT, start + found, found < NO_HIT);
}
