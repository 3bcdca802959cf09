// Generated from tests/cases/geometry/models.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Plane 0, mirrored, stretched, block, hollow
//   shapes    Plane, Mesh, Box

const OBJECT_PLANE_0: u32 = 0u;
const OBJECT_MIRRORED: u32 = 1u;
const OBJECT_STRETCHED: u32 = 2u;
const OBJECT_BLOCK: u32 = 3u;
const OBJECT_HOLLOW: u32 = 4u;
/// scenes/models/knot.obj
const MODEL_KNOT: Model = Model(0u, false);
/// scenes/models/gem.glb
const MODEL_GEM: Model = Model(41620u, false);
const LIGHTS: u32 = 1u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    // objects[0] "Plane 0": Plane(offset: -1)
    hit = nearer(hit, plane(ray, vec3f(0.0, 1.0, 0.0), -1.0), OBJECT_PLANE_0);
    // objects[1] "mirrored": Mesh(file: "../../../scenes/models/knot.obj", scale: (0.9, -0.9, 0.9)…
    hit = nearer(
        hit,
        mesh(
            rayInto(
                Space(
                    vec4f(1.1111112, 0.0, 0.0, 2.5555556),
                    vec4f(0.0, -0.5555556, -0.9622505, 0.11111111),
                    vec4f(0.0, -0.9622505, 0.5555556, 0.19245009),
                ),
                ray,
            ),
            MODEL_KNOT,
            true,
        ),
        OBJECT_MIRRORED,
    );
    // objects[2] "stretched": Mesh(file: "../../../scenes/models/gem.glb", smooth: false, scale: (…
    hit = nearer(
        hit,
        mesh(
            rayInto(
                Space(
                    vec4f(1.6666666, 0.0, 0.0, 0.0),
                    vec4f(0.0, 0.625, 0.0, -0.25),
                    vec4f(0.0, 0.0, 1.0, 0.0),
                ),
                ray,
            ),
            MODEL_GEM,
            false,
        ),
        OBJECT_STRETCHED,
    );
    // "cut": Difference(rotate_deg: (20, 30, 0), translate: (2.3, 0, 0))
    hit = nearerCrossing(hit, cutSolid(ray));
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if plane(ray, vec3f(0.0, 1.0, 0.0), -1.0) < NO_HIT { return true; }
    if mesh(
        rayInto(
            Space(
                vec4f(1.1111112, 0.0, 0.0, 2.5555556),
                vec4f(0.0, -0.5555556, -0.9622505, 0.11111111),
                vec4f(0.0, -0.9622505, 0.5555556, 0.19245009),
            ),
            ray,
        ),
        MODEL_KNOT,
        true,
    ) < NO_HIT { return true; }
    if mesh(
        rayInto(
            Space(
                vec4f(1.6666666, 0.0, 0.0, 0.0),
                vec4f(0.0, 0.625, 0.0, -0.25),
                vec4f(0.0, 0.0, 1.0, 0.0),
            ),
            ray,
        ),
        MODEL_GEM,
        false,
    ) < NO_HIT { return true; }
    if cutSolid(ray).t < NO_HIT { return true; }
    return false;
}

/// "cut": Difference(rotate_deg: (20, 30, 0), translate: (2.3, 0, 0))
fn cutSolid(ray: Ray) -> Crossing {
    var rest = ray;
    var moved0 = rayInto(
        Space(
            vec4f(0.8660254, 0.0, -0.5, -1.9918585),
            vec4f(0.17101008, 0.9396926, 0.29619813, -0.39332315),
            vec4f(0.4698463, -0.34202015, 0.81379765, -1.0806465),
        ),
        ray,
    );
    var moved1 = rayInto(
        Space(
            vec4f(0.8660254, 0.0, -0.5, -1.9918585),
            vec4f(-0.17101008, -0.9396926, -0.29619813, 0.39332315),
            vec4f(0.5873079, -0.42752516, 1.0172471, -1.3508081),
        ),
        ray,
    );
    var blockPart = notAsked();
    var hollowPart = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if blockPart.t <= rest.t_min {
            let t = box(moved0, vec3f(-0.9), vec3f(0.9));
            let on = boxSurface(pointAt(moved0, t), vec3f(-0.9), vec3f(0.9));
            blockPart = crossing(moved0, t, OBJECT_BLOCK, on.geometric_normal);
        }
        if hollowPart.t <= rest.t_min {
            let t = mesh(moved1, MODEL_KNOT, true);
            let on = meshSurface(pointAt(moved1, t), MODEL_KNOT, true);
            hollowPart = crossing(moved1, t, OBJECT_HOLLOW, on.geometric_normal);
        }
        let t = min(blockPart.t, hollowPart.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        moved1.t_min = rest.t_min;
        let blockTurns = blockPart.t <= rest.t_min;
        let hollowTurns = hollowPart.t <= rest.t_min;
        let before = blockPart.leaves && !hollowPart.leaves;
        let behind = blockPart.leaves != blockTurns && hollowPart.leaves == hollowTurns;
        if before != behind {
            return Crossing(t, select(hollowPart.object, blockPart.object, blockTurns), before);
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_PLANE_0: {
            return placed(planeSurface(p, vec3f(0.0, 1.0, 0.0), -1.0), p);
        }
        case OBJECT_MIRRORED: {
            let space = Space(
                vec4f(1.1111112, 0.0, 0.0, 2.5555556),
                vec4f(0.0, -0.5555556, -0.9622505, 0.11111111),
                vec4f(0.0, -0.9622505, 0.5555556, 0.19245009),
            );
            return placedFrom(space, meshSurface(pointInto(space, p), MODEL_KNOT, true), p);
        }
        case OBJECT_STRETCHED: {
            let space = Space(
                vec4f(1.6666666, 0.0, 0.0, 0.0),
                vec4f(0.0, 0.625, 0.0, -0.25),
                vec4f(0.0, 0.0, 1.0, 0.0),
            );
            return placedFrom(space, meshSurface(pointInto(space, p), MODEL_GEM, false), p);
        }
        case OBJECT_BLOCK: {
            let space = Space(
                vec4f(0.8660254, 0.0, -0.5, -1.9918585),
                vec4f(0.17101008, 0.9396926, 0.29619813, -0.39332315),
                vec4f(0.4698463, -0.34202015, 0.81379765, -1.0806465),
            );
            return placedFrom(space, boxSurface(pointInto(space, p), vec3f(-0.9), vec3f(0.9)), p);
        }
        case OBJECT_HOLLOW: {
            let space = Space(
                vec4f(0.8660254, 0.0, -0.5, -1.9918585),
                vec4f(-0.17101008, -0.9396926, -0.29619813, 0.39332315),
                vec4f(0.5873079, -0.42752516, 1.0172471, -1.3508081),
            );
            return placedFrom(
                space,
                inverted(meshSurface(pointInto(space, p), MODEL_KNOT, true)),
                p,
            );
        }
        default: {
            return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p);
        }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_PLANE_0: { return plane0Material(at); }
        case OBJECT_MIRRORED: { return mirroredMaterial(at); }
        case OBJECT_STRETCHED: { return stretchedMaterial(at); }
        case OBJECT_BLOCK: { return blockMaterial(at); }
        case OBJECT_HOLLOW: { return hollowMaterial(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

fn plane0Material(at: Surface) -> Material {
    return matte(vec3f(0.8));
}

fn mirroredMaterial(at: Surface) -> Material {
    return matte(vec3f(0.8));
}

fn stretchedMaterial(at: Surface) -> Material {
    return matte(vec3f(0.8));
}

fn blockMaterial(at: Surface) -> Material {
    return matte(vec3f(0.8));
}

fn hollowMaterial(at: Surface) -> Material {
    return matte(vec3f(0.8));
}

/// Whether the material of `object` varies over its surface.
fn isTextured(object: u32) -> bool {
    return false;
}

/// The world normal of `object` at `met`.
fn normalAt(object: u32, met: Placed) -> vec3f {
    return met.normal;
}

/// What a ray sees that leaves the scene in `direction`.
fn background(direction: vec3f) -> vec3f {
    return vec3f(0.0);
}

fn ambientLight() -> vec3f {
    return vec3f(0.1);
}

/// The light `index` as the world point `p` sees it.
fn lightAt(index: u32, p: vec3f) -> Light {
    switch index {
        // lights[0]: Point(position: (-4, 7, 5), intensity: 0.9)
        case 0u: { return pointLight(p, vec3f(-4.0, 7.0, 5.0), 0.0, vec3f(0.9)); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
