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
    hit = nearer(hit, floorCrossing(ray), OBJECT_FLOOR);
    hit = nearerCrossing(hit, dieSolid(ray));
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if floorCrossing(ray) < NO_HIT { return true; }
    if dieSolid(ray).t < NO_HIT { return true; }
    return false;
}

/// objects[0] "floor": Plane()
fn floorCrossing(ray: Ray) -> f32 {
    return plane(ray, vec3f(0.0, 1.0, 0.0), 0.0);
}

fn floorSurfaceAt(p: vec3f) -> Surface {
    return planeSurface(p, vec3f(0.0, 1.0, 0.0), 0.0);
}

/// "body Box 0": Box(min: (-1, 0, -1), max: (1, 2, 1))
fn bodyBox0Crossing(ray: Ray) -> f32 {
    return box(ray, vec3f(-1.0, 0.0, -1.0), vec3f(1.0, 2.0, 1.0));
}

fn bodyBox0SurfaceAt(p: vec3f) -> Surface {
    return boxSurface(p, vec3f(-1.0, 0.0, -1.0), vec3f(1.0, 2.0, 1.0));
}

fn bodyBox0Space() -> Space {
    return Space(
        vec4f(0.9396926, 0.0, -0.34202015, 0.0),
        vec4f(0.0, 1.0, 0.0, 0.0),
        vec4f(0.34202015, 0.0, 0.9396926, 0.0),
    );
}

/// "body Sphere 1": Sphere(center: (0, 1, 0), radius: 1.35)
fn bodySphere1Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0, 1.0, 0.0), 1.35);
}

fn bodySphere1SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0, 1.0, 0.0), 1.35);
}

fn bodySphere1Space() -> Space {
    return Space(
        vec4f(0.9396926, 0.0, -0.34202015, 0.0),
        vec4f(0.0, 1.0, 0.0, 0.0),
        vec4f(0.34202015, 0.0, 0.9396926, 0.0),
    );
}

/// "well": Cylinder(base: (0, 0.5, 0), top: (0, 2, 0), radius: 0.6)
fn wellCrossing(ray: Ray) -> f32 {
    return cylinder(ray, vec3f(0.0, 0.5, 0.0), vec3f(0.0, 2.0, 0.0), 0.6);
}

fn wellSurfaceAt(p: vec3f) -> Surface {
    return cylinderSurface(p, vec3f(0.0, 0.5, 0.0), vec3f(0.0, 2.0, 0.0), 0.6);
}

fn wellSpace() -> Space {
    return Space(
        vec4f(0.9396926, 0.0, -0.34202015, 0.0),
        vec4f(0.0, 1.0, 0.0, 0.0),
        vec4f(0.34202015, 0.0, 0.9396926, 0.0),
    );
}

/// "die Cylinder 2": Cylinder(base: (-1, 1, 0), top: (1, 1, 0), radius: 0.3)
fn dieCylinder2Crossing(ray: Ray) -> f32 {
    return cylinder(ray, vec3f(-1.0, 1.0, 0.0), vec3f(1.0, 1.0, 0.0), 0.3);
}

fn dieCylinder2SurfaceAt(p: vec3f) -> Surface {
    return cylinderSurface(p, vec3f(-1.0, 1.0, 0.0), vec3f(1.0, 1.0, 0.0), 0.3);
}

fn dieCylinder2Space() -> Space {
    return Space(
        vec4f(0.9396926, 0.0, -0.34202015, 0.0),
        vec4f(0.0, 1.0, 0.0, 0.0),
        vec4f(0.34202015, 0.0, 0.9396926, 0.0),
    );
}

/// objects[1] "die": Difference(rotate_deg: (0, 20, 0))
fn dieSolid(ray: Ray) -> Crossing {
    var rest = ray;
    var moved0 = rayInto(wellSpace(), ray);
    var body_part = notAsked();
    var well_part = notAsked();
    var cylinder_2_part = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if body_part.t <= rest.t_min {
            body_part = bodySolid(rest);
        }
        if well_part.t <= rest.t_min {
            let t = wellCrossing(moved0);
            let on = wellSurfaceAt(pointAt(moved0, t));
            well_part = crossing(moved0, t, OBJECT_WELL, on.geometric_normal);
        }
        if cylinder_2_part.t <= rest.t_min {
            let t = dieCylinder2Crossing(moved0);
            let on = dieCylinder2SurfaceAt(pointAt(moved0, t));
            cylinder_2_part = crossing(moved0, t, OBJECT_DIE_CYLINDER_2, on.geometric_normal);
        }
        let t = min(min(body_part.t, well_part.t), cylinder_2_part.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        let body_turns = body_part.t <= rest.t_min;
        let well_turns = well_part.t <= rest.t_min;
        let cylinder_2_turns = cylinder_2_part.t <= rest.t_min;
        let before = body_part.leaves && !well_part.leaves && !cylinder_2_part.leaves;
        let behind = body_part.leaves != body_turns
            && well_part.leaves == well_turns
            && cylinder_2_part.leaves == cylinder_2_turns;
        if before != behind {
            return Crossing(
                t,
                select(
                    select(cylinder_2_part.object, well_part.object, well_turns),
                    body_part.object,
                    body_turns,
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
    var moved0 = rayInto(bodyBox0Space(), ray);
    var box_0_part = notAsked();
    var sphere_1_part = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if box_0_part.t <= rest.t_min {
            let t = bodyBox0Crossing(moved0);
            let on = bodyBox0SurfaceAt(pointAt(moved0, t));
            box_0_part = crossing(moved0, t, OBJECT_BODY_BOX_0, on.geometric_normal);
        }
        if sphere_1_part.t <= rest.t_min {
            let t = bodySphere1Crossing(moved0);
            let on = bodySphere1SurfaceAt(pointAt(moved0, t));
            sphere_1_part = crossing(moved0, t, OBJECT_BODY_SPHERE_1, on.geometric_normal);
        }
        let t = min(box_0_part.t, sphere_1_part.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        let box_0_turns = box_0_part.t <= rest.t_min;
        let sphere_1_turns = sphere_1_part.t <= rest.t_min;
        let before = box_0_part.leaves && sphere_1_part.leaves;
        let behind = box_0_part.leaves != box_0_turns && sphere_1_part.leaves != sphere_1_turns;
        if before != behind {
            return Crossing(
                t,
                select(sphere_1_part.object, box_0_part.object, box_0_turns),
                before,
            );
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_FLOOR: { return placed(floorSurfaceAt(p), p); }
        case OBJECT_BODY_BOX_0: {
            return placedFrom(bodyBox0Space(), bodyBox0SurfaceAt(pointInto(bodyBox0Space(), p)), p);
        }
        case OBJECT_BODY_SPHERE_1: {
            return placedFrom(
                bodySphere1Space(),
                bodySphere1SurfaceAt(pointInto(bodySphere1Space(), p)),
                p,
            );
        }
        case OBJECT_WELL: {
            return placedFrom(wellSpace(), inverted(wellSurfaceAt(pointInto(wellSpace(), p))), p);
        }
        case OBJECT_DIE_CYLINDER_2: {
            return placedFrom(
                dieCylinder2Space(),
                inverted(dieCylinder2SurfaceAt(pointInto(dieCylinder2Space(), p))),
                p,
            );
        }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_FLOOR: { return defaultMaterial(at); }
        case OBJECT_BODY_BOX_0, OBJECT_DIE_CYLINDER_2: { return dieMaterial(at); }
        case OBJECT_BODY_SPHERE_1: { return bodySphere1Material(at); }
        case OBJECT_WELL: { return wellMaterial(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// The material of objects that have none in the scene.
fn defaultMaterial(at: Surface) -> Material {
    return matte(vec3f(0.8));
}

/// material "die": (color: "tomato")
fn dieMaterial(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.12477182, 0.06301002));
}

/// material "body Sphere 1": (color: "gold")
fn bodySphere1Material(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.6795425, 0.0));
}

/// material "well": (color: "steelblue")
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
