// Generated from tests/cases/solids/a_plane_is_endless_as_a_part.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   dome Sphere 0, dome Plane 1
//   shapes    Sphere, Plane

const OBJECT_DOME_SPHERE_0: u32 = 0u;
const OBJECT_DOME_PLANE_1: u32 = 1u;
const LIGHTS: u32 = 1u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    if domeInReach(ray) {
        hit = nearerCrossing(hit, domeSolid(ray));
    }
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if domeInReach(ray) {
        if domeSolid(ray).t < NO_HIT { return true; }
    }
    return false;
}

/// "dome Sphere 0": Sphere(radius: 1.5)
fn domeSphere0Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 1.5);
}

fn domeSphere0SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 1.5);
}

fn domeSphere0Space() -> Space {
    return Space(vec4f(1.0, 0.0, 0.0, 0.0), vec4f(0.0, 1.0, 0.0, -1.0), vec4f(0.0, 0.0, 1.0, 0.0));
}

/// "dome Plane 1": Plane(normal: (0, -1, 0), translate: (0, -0.5, 0))
fn domePlane1Crossing(ray: Ray) -> f32 {
    return plane(ray, vec3f(0.0, -1.0, 0.0), 0.0);
}

fn domePlane1SurfaceAt(p: vec3f) -> Surface {
    return planeSurface(p, vec3f(0.0, -1.0, 0.0), 0.0);
}

fn domePlane1Holds(p: vec3f) -> bool {
    return planeContains(p, vec3f(0.0, -1.0, 0.0), 0.0);
}

fn domePlane1Space() -> Space {
    return Space(vec4f(1.0, 0.0, 0.0, 0.0), vec4f(0.0, 1.0, 0.0, -0.5), vec4f(0.0, 0.0, 1.0, 0.0));
}

/// objects[0] "dome": Intersection(bounds: (min: (-2, -1, -2), max: (2, 2, 2)), translate: (0, 1, …
fn domeSolid(ray: Ray) -> Crossing {
    var rest = ray;
    var moved0 = rayInto(domeSphere0Space(), ray);
    var moved1 = rayInto(domePlane1Space(), ray);
    var sphere_0_part = notAsked();
    var plane_1_part = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if sphere_0_part.t <= rest.t_min {
            let t = domeSphere0Crossing(moved0);
            let on = domeSphere0SurfaceAt(pointAt(moved0, t));
            sphere_0_part = crossing(moved0, t, OBJECT_DOME_SPHERE_0, on.geometric_normal);
        }
        if plane_1_part.t <= rest.t_min {
            let t = domePlane1Crossing(moved1);
            let on = domePlane1SurfaceAt(pointAt(moved1, t));
            plane_1_part = crossing(moved1, t, OBJECT_DOME_PLANE_1, on.geometric_normal);
            if t >= NO_HIT { plane_1_part.leaves = domePlane1Holds(pointBeyond(moved1)); }
        }
        let t = min(sphere_0_part.t, plane_1_part.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        moved1.t_min = rest.t_min;
        let sphere_0_turns = sphere_0_part.t <= rest.t_min;
        let plane_1_turns = plane_1_part.t <= rest.t_min;
        let before = sphere_0_part.leaves && plane_1_part.leaves;
        let behind = sphere_0_part.leaves != sphere_0_turns && plane_1_part.leaves != plane_1_turns;
        if before != behind {
            return Crossing(
                t,
                select(plane_1_part.object, sphere_0_part.object, sphere_0_turns),
                before,
            );
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// Whether `ray` meets the bounds of "dome".
fn domeInReach(ray: Ray) -> bool {
    return meetsBounds(
        rayInto(
            Space(vec4f(1.0, 0.0, 0.0, 0.0), vec4f(0.0, 1.0, 0.0, -1.0), vec4f(0.0, 0.0, 1.0, 0.0)),
            ray,
        ),
        vec3f(-2.0, -1.0, -2.0),
        vec3f(2.0),
    );
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_DOME_SPHERE_0: {
            return placedFrom(
                domeSphere0Space(),
                domeSphere0SurfaceAt(pointInto(domeSphere0Space(), p)),
                p,
            );
        }
        case OBJECT_DOME_PLANE_1: {
            return placedFrom(
                domePlane1Space(),
                domePlane1SurfaceAt(pointInto(domePlane1Space(), p)),
                p,
            );
        }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_DOME_SPHERE_0, OBJECT_DOME_PLANE_1: { return defaultMaterial(at); }
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
        // lights[0]: Point(position: (4, 6, 3))
        case 0u: { return pointLight(p, vec3f(4.0, 6.0, 3.0), 0.0, vec3f(1.0)); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
