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
    hit = nearer(hit, plane0Crossing(ray), OBJECT_PLANE_0);
    hit = nearer(hit, mirroredCrossing(rayInto(mirroredSpace(), ray)), OBJECT_MIRRORED);
    hit = nearer(hit, stretchedCrossing(rayInto(stretchedSpace(), ray)), OBJECT_STRETCHED);
    hit = nearerCrossing(hit, cutSolid(ray));
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if plane0Crossing(ray) < NO_HIT { return true; }
    if mirroredCrossing(rayInto(mirroredSpace(), ray)) < NO_HIT { return true; }
    if stretchedCrossing(rayInto(stretchedSpace(), ray)) < NO_HIT { return true; }
    if cutSolid(ray).t < NO_HIT { return true; }
    return false;
}

/// objects[0] "Plane 0": Plane(offset: -1)
fn plane0Crossing(ray: Ray) -> f32 {
    return plane(ray, vec3f(0.0, 1.0, 0.0), -1.0);
}

fn plane0SurfaceAt(p: vec3f) -> Surface {
    return planeSurface(p, vec3f(0.0, 1.0, 0.0), -1.0);
}

/// objects[1] "mirrored": Mesh(file: "../../../scenes/models/knot.obj", scale: (0.9, -0.9, 0.9), r…
fn mirroredCrossing(ray: Ray) -> f32 {
    return mesh(ray, MODEL_KNOT, true);
}

fn mirroredSurfaceAt(p: vec3f) -> Surface {
    return meshSurface(p, MODEL_KNOT, true);
}

fn mirroredSpace() -> Space {
    return Space(
        vec4f(1.1111112, 0.0, 0.0, 2.5555556),
        vec4f(0.0, -0.5555556, -0.9622505, 0.11111111),
        vec4f(0.0, -0.9622505, 0.5555556, 0.19245009),
    );
}

/// objects[2] "stretched": Mesh(file: "../../../scenes/models/gem.glb", smooth: false, scale: (0.6…
fn stretchedCrossing(ray: Ray) -> f32 {
    return mesh(ray, MODEL_GEM, false);
}

fn stretchedSurfaceAt(p: vec3f) -> Surface {
    return meshSurface(p, MODEL_GEM, false);
}

fn stretchedSpace() -> Space {
    return Space(
        vec4f(1.6666666, 0.0, 0.0, 0.0),
        vec4f(0.0, 0.625, 0.0, -0.25),
        vec4f(0.0, 0.0, 1.0, 0.0),
    );
}

/// "block": Box(min: (-0.9, -0.9, -0.9), max: (0.9, 0.9, 0.9))
fn blockCrossing(ray: Ray) -> f32 {
    return box(ray, vec3f(-0.9), vec3f(0.9));
}

fn blockSurfaceAt(p: vec3f) -> Surface {
    return boxSurface(p, vec3f(-0.9), vec3f(0.9));
}

fn blockSpace() -> Space {
    return Space(
        vec4f(0.8660254, 0.0, -0.5, -1.9918585),
        vec4f(0.17101008, 0.9396926, 0.29619813, -0.39332315),
        vec4f(0.4698463, -0.34202015, 0.81379765, -1.0806465),
    );
}

/// "hollow": Mesh(file: "../../../scenes/models/knot.obj", scale: (1, -1, 0.8))
fn hollowCrossing(ray: Ray) -> f32 {
    return mesh(ray, MODEL_KNOT, true);
}

fn hollowSurfaceAt(p: vec3f) -> Surface {
    return meshSurface(p, MODEL_KNOT, true);
}

fn hollowSpace() -> Space {
    return Space(
        vec4f(0.8660254, 0.0, -0.5, -1.9918585),
        vec4f(-0.17101008, -0.9396926, -0.29619813, 0.39332315),
        vec4f(0.5873079, -0.42752516, 1.0172471, -1.3508081),
    );
}

/// objects[3] "cut": Difference(rotate_deg: (20, 30, 0), translate: (2.3, 0, 0))
fn cutSolid(ray: Ray) -> Crossing {
    var rest = ray;
    var moved0 = rayInto(blockSpace(), ray);
    var moved1 = rayInto(hollowSpace(), ray);
    var block_part = notAsked();
    var hollow_part = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if block_part.t <= rest.t_min {
            let t = blockCrossing(moved0);
            let on = blockSurfaceAt(pointAt(moved0, t));
            block_part = crossing(moved0, t, OBJECT_BLOCK, on.geometric_normal);
        }
        if hollow_part.t <= rest.t_min {
            let t = hollowCrossing(moved1);
            let on = hollowSurfaceAt(pointAt(moved1, t));
            hollow_part = crossing(moved1, t, OBJECT_HOLLOW, on.geometric_normal);
        }
        let t = min(block_part.t, hollow_part.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        moved1.t_min = rest.t_min;
        let block_turns = block_part.t <= rest.t_min;
        let hollow_turns = hollow_part.t <= rest.t_min;
        let before = block_part.leaves && !hollow_part.leaves;
        let behind = block_part.leaves != block_turns && hollow_part.leaves == hollow_turns;
        if before != behind {
            return Crossing(t, select(hollow_part.object, block_part.object, block_turns), before);
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_PLANE_0: { return placed(plane0SurfaceAt(p), p); }
        case OBJECT_MIRRORED: {
            return placedFrom(mirroredSpace(), mirroredSurfaceAt(pointInto(mirroredSpace(), p)), p);
        }
        case OBJECT_STRETCHED: {
            return placedFrom(
                stretchedSpace(),
                stretchedSurfaceAt(pointInto(stretchedSpace(), p)),
                p,
            );
        }
        case OBJECT_BLOCK: {
            return placedFrom(blockSpace(), blockSurfaceAt(pointInto(blockSpace(), p)), p);
        }
        case OBJECT_HOLLOW: {
            return placedFrom(
                hollowSpace(),
                inverted(hollowSurfaceAt(pointInto(hollowSpace(), p))),
                p,
            );
        }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_PLANE_0, OBJECT_MIRRORED, OBJECT_STRETCHED, OBJECT_BLOCK, OBJECT_HOLLOW: {
            return defaultMaterial(at);
        }
        default: { return matte(vec3f(0.0)); }
    }
}

/// The material of objects that have none in the scene.
fn defaultMaterial(at: Surface) -> Material {
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
