// Generated from tests/cases/solids/parts_are_cut_from_parts.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   floor, body Box 0, body Sphere 1, well, die Cylinder 2
//   shapes    Plane, Box, Sphere, Cylinder

const OBJECT_FLOOR: u32 = 0u;
const OBJECT_BODY_BOX_0: u32 = 1u;
const OBJECT_BODY_SPHERE_1: u32 = 2u;
const OBJECT_WELL: u32 = 3u;
const OBJECT_DIE_CYLINDER_2: u32 = 4u;
const LIGHTS: u32 = 1u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    // objects[0] "floor": Plane()
    hit = nearer(hit, plane(ray, vec3f(0.0, 1.0, 0.0), 0.0), OBJECT_FLOOR);
    // "die": Difference(rotate_deg: (0, 20, 0))
    hit = nearerCrossing(hit, dieSolid(ray));
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if plane(ray, vec3f(0.0, 1.0, 0.0), 0.0) < NO_HIT { return true; }
    if dieSolid(ray).t < NO_HIT { return true; }
    return false;
}

/// "die": Difference(rotate_deg: (0, 20, 0))
fn dieSolid(ray: Ray) -> Crossing {
    var rest = ray;
    var moved0 = rayInto(
        Space(
            vec4f(0.9396926, 0.0, -0.34202015, 0.0),
            vec4f(0.0, 1.0, 0.0, 0.0),
            vec4f(0.34202015, 0.0, 0.9396926, 0.0),
        ),
        ray,
    );
    var bodyPart = notAsked();
    var wellPart = notAsked();
    var cylinder2Part = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if bodyPart.t <= rest.t_min {
            bodyPart = bodySolid(rest);
        }
        if wellPart.t <= rest.t_min {
            let t = cylinder(moved0, vec3f(0.0, 0.5, 0.0), vec3f(0.0, 2.0, 0.0), 0.6);
            let on = cylinderSurface(
                pointAt(moved0, t),
                vec3f(0.0, 0.5, 0.0),
                vec3f(0.0, 2.0, 0.0),
                0.6,
            );
            wellPart = crossing(moved0, t, OBJECT_WELL, on.geometric_normal);
        }
        if cylinder2Part.t <= rest.t_min {
            let t = cylinder(moved0, vec3f(-1.0, 1.0, 0.0), vec3f(1.0, 1.0, 0.0), 0.3);
            let on = cylinderSurface(
                pointAt(moved0, t),
                vec3f(-1.0, 1.0, 0.0),
                vec3f(1.0, 1.0, 0.0),
                0.3,
            );
            cylinder2Part = crossing(moved0, t, OBJECT_DIE_CYLINDER_2, on.geometric_normal);
        }
        let t = min(min(bodyPart.t, wellPart.t), cylinder2Part.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        let bodyTurns = bodyPart.t <= rest.t_min;
        let wellTurns = wellPart.t <= rest.t_min;
        let cylinder2Turns = cylinder2Part.t <= rest.t_min;
        let before = bodyPart.leaves && !wellPart.leaves && !cylinder2Part.leaves;
        let behind = bodyPart.leaves != bodyTurns
            && wellPart.leaves == wellTurns
            && cylinder2Part.leaves == cylinder2Turns;
        if before != behind {
            return Crossing(
                t,
                select(
                    select(cylinder2Part.object, wellPart.object, wellTurns),
                    bodyPart.object,
                    bodyTurns,
                ),
                before,
            );
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// "body": Intersection()
fn bodySolid(ray: Ray) -> Crossing {
    var rest = ray;
    var moved0 = rayInto(
        Space(
            vec4f(0.9396926, 0.0, -0.34202015, 0.0),
            vec4f(0.0, 1.0, 0.0, 0.0),
            vec4f(0.34202015, 0.0, 0.9396926, 0.0),
        ),
        ray,
    );
    var box0Part = notAsked();
    var sphere1Part = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if box0Part.t <= rest.t_min {
            let t = box(moved0, vec3f(-1.0, 0.0, -1.0), vec3f(1.0, 2.0, 1.0));
            let on = boxSurface(pointAt(moved0, t), vec3f(-1.0, 0.0, -1.0), vec3f(1.0, 2.0, 1.0));
            box0Part = crossing(moved0, t, OBJECT_BODY_BOX_0, on.geometric_normal);
        }
        if sphere1Part.t <= rest.t_min {
            let t = sphere(moved0, vec3f(0.0, 1.0, 0.0), 1.35);
            let on = sphereSurface(pointAt(moved0, t), vec3f(0.0, 1.0, 0.0), 1.35);
            sphere1Part = crossing(moved0, t, OBJECT_BODY_SPHERE_1, on.geometric_normal);
        }
        let t = min(box0Part.t, sphere1Part.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        let box0Turns = box0Part.t <= rest.t_min;
        let sphere1Turns = sphere1Part.t <= rest.t_min;
        let before = box0Part.leaves && sphere1Part.leaves;
        let behind = box0Part.leaves != box0Turns && sphere1Part.leaves != sphere1Turns;
        if before != behind {
            return Crossing(t, select(sphere1Part.object, box0Part.object, box0Turns), before);
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_FLOOR: {
            return placed(planeSurface(p, vec3f(0.0, 1.0, 0.0), 0.0), p);
        }
        case OBJECT_BODY_BOX_0: {
            let space = Space(
                vec4f(0.9396926, 0.0, -0.34202015, 0.0),
                vec4f(0.0, 1.0, 0.0, 0.0),
                vec4f(0.34202015, 0.0, 0.9396926, 0.0),
            );
            return placedFrom(
                space,
                boxSurface(pointInto(space, p), vec3f(-1.0, 0.0, -1.0), vec3f(1.0, 2.0, 1.0)),
                p,
            );
        }
        case OBJECT_BODY_SPHERE_1: {
            let space = Space(
                vec4f(0.9396926, 0.0, -0.34202015, 0.0),
                vec4f(0.0, 1.0, 0.0, 0.0),
                vec4f(0.34202015, 0.0, 0.9396926, 0.0),
            );
            return placedFrom(
                space,
                sphereSurface(pointInto(space, p), vec3f(0.0, 1.0, 0.0), 1.35),
                p,
            );
        }
        case OBJECT_WELL: {
            let space = Space(
                vec4f(0.9396926, 0.0, -0.34202015, 0.0),
                vec4f(0.0, 1.0, 0.0, 0.0),
                vec4f(0.34202015, 0.0, 0.9396926, 0.0),
            );
            return placedFrom(
                space,
                inverted(
                    cylinderSurface(
                        pointInto(space, p),
                        vec3f(0.0, 0.5, 0.0),
                        vec3f(0.0, 2.0, 0.0),
                        0.6,
                    ),
                ),
                p,
            );
        }
        case OBJECT_DIE_CYLINDER_2: {
            let space = Space(
                vec4f(0.9396926, 0.0, -0.34202015, 0.0),
                vec4f(0.0, 1.0, 0.0, 0.0),
                vec4f(0.34202015, 0.0, 0.9396926, 0.0),
            );
            return placedFrom(
                space,
                inverted(
                    cylinderSurface(
                        pointInto(space, p),
                        vec3f(-1.0, 1.0, 0.0),
                        vec3f(1.0, 1.0, 0.0),
                        0.3,
                    ),
                ),
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
        case OBJECT_FLOOR: { return floorMaterial(at); }
        case OBJECT_BODY_BOX_0, OBJECT_DIE_CYLINDER_2: { return dieMaterial(at); }
        case OBJECT_BODY_SPHERE_1: { return bodySphere1Material(at); }
        case OBJECT_WELL: { return wellMaterial(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

fn floorMaterial(at: Surface) -> Material {
    return matte(vec3f(0.8));
}

fn dieMaterial(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.12477182, 0.06301002));
}

fn bodySphere1Material(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.6795425, 0.0));
}

fn wellMaterial(at: Surface) -> Material {
    return matte(vec3f(0.06124606, 0.22322798, 0.45641103));
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
