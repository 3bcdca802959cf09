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
    // "dome": Intersection(bounds: (min: (-2, -1, -2), max: (2, 2, 2)), translate: (0, 1, 0))
    if meetsBounds(
        rayInto(
            Space(vec4f(1.0, 0.0, 0.0, 0.0), vec4f(0.0, 1.0, 0.0, -1.0), vec4f(0.0, 0.0, 1.0, 0.0)),
            ray,
        ),
        vec3f(-2.0, -1.0, -2.0),
        vec3f(2.0),
    ) {
        hit = nearerCrossing(hit, domeSolid(ray));
    }
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if meetsBounds(
        rayInto(
            Space(vec4f(1.0, 0.0, 0.0, 0.0), vec4f(0.0, 1.0, 0.0, -1.0), vec4f(0.0, 0.0, 1.0, 0.0)),
            ray,
        ),
        vec3f(-2.0, -1.0, -2.0),
        vec3f(2.0),
    ) {
        if domeSolid(ray).t < NO_HIT { return true; }
    }
    return false;
}

/// "dome": Intersection(bounds: (min: (-2, -1, -2), max: (2, 2, 2)), translate: (0, 1, 0))
fn domeSolid(ray: Ray) -> Crossing {
    var rest = ray;
    var moved0 = rayInto(
        Space(vec4f(1.0, 0.0, 0.0, 0.0), vec4f(0.0, 1.0, 0.0, -1.0), vec4f(0.0, 0.0, 1.0, 0.0)),
        ray,
    );
    var moved1 = rayInto(
        Space(vec4f(1.0, 0.0, 0.0, 0.0), vec4f(0.0, 1.0, 0.0, -0.5), vec4f(0.0, 0.0, 1.0, 0.0)),
        ray,
    );
    var sphere0Part = notAsked();
    var plane1Part = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if sphere0Part.t <= rest.t_min {
            let t = sphere(moved0, vec3f(0.0), 1.5);
            let on = sphereSurface(pointAt(moved0, t), vec3f(0.0), 1.5);
            sphere0Part = crossing(moved0, t, OBJECT_DOME_SPHERE_0, on.geometric_normal);
        }
        if plane1Part.t <= rest.t_min {
            let t = plane(moved1, vec3f(0.0, -1.0, 0.0), 0.0);
            let on = planeSurface(pointAt(moved1, t), vec3f(0.0, -1.0, 0.0), 0.0);
            plane1Part = crossing(moved1, t, OBJECT_DOME_PLANE_1, on.geometric_normal);
            if t >= NO_HIT { plane1Part.leaves = planeContains(
                pointBeyond(moved1),
                vec3f(0.0, -1.0, 0.0),
                0.0,
            ); }
        }
        let t = min(sphere0Part.t, plane1Part.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        moved1.t_min = rest.t_min;
        let sphere0Turns = sphere0Part.t <= rest.t_min;
        let plane1Turns = plane1Part.t <= rest.t_min;
        let before = sphere0Part.leaves && plane1Part.leaves;
        let behind = sphere0Part.leaves != sphere0Turns && plane1Part.leaves != plane1Turns;
        if before != behind {
            return Crossing(t, select(plane1Part.object, sphere0Part.object, sphere0Turns), before);
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_DOME_SPHERE_0: {
            let space = Space(
                vec4f(1.0, 0.0, 0.0, 0.0),
                vec4f(0.0, 1.0, 0.0, -1.0),
                vec4f(0.0, 0.0, 1.0, 0.0),
            );
            return placedFrom(space, sphereSurface(pointInto(space, p), vec3f(0.0), 1.5), p);
        }
        case OBJECT_DOME_PLANE_1: {
            let space = Space(
                vec4f(1.0, 0.0, 0.0, 0.0),
                vec4f(0.0, 1.0, 0.0, -0.5),
                vec4f(0.0, 0.0, 1.0, 0.0),
            );
            return placedFrom(
                space,
                planeSurface(pointInto(space, p), vec3f(0.0, -1.0, 0.0), 0.0),
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
        case OBJECT_DOME_SPHERE_0: { return domeSphere0Material(at); }
        case OBJECT_DOME_PLANE_1: { return domePlane1Material(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

fn domeSphere0Material(at: Surface) -> Material {
    return matte(vec3f(0.8));
}

fn domePlane1Material(at: Surface) -> Material {
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
