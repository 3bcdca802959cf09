// Generated from tests/cases/materials/named_materials_are_shared.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Sphere 0, Box 1, Torus 2, Plane 3
//   shapes    Sphere, Box, Torus, Plane

const OBJECT_SPHERE_0: u32 = 0u;
const OBJECT_BOX_1: u32 = 1u;
const OBJECT_TORUS_2: u32 = 2u;
const OBJECT_PLANE_3: u32 = 3u;
const LIGHTS: u32 = 0u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, sphere0Crossing(ray), OBJECT_SPHERE_0);
    hit = nearer(hit, box1Crossing(ray), OBJECT_BOX_1);
    hit = nearer(hit, torus2Crossing(ray), OBJECT_TORUS_2);
    hit = nearer(hit, plane3Crossing(ray), OBJECT_PLANE_3);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if sphere0Crossing(ray) < NO_HIT { return true; }
    if box1Crossing(ray) < NO_HIT { return true; }
    if torus2Crossing(ray) < NO_HIT { return true; }
    if plane3Crossing(ray) < NO_HIT { return true; }
    return false;
}

/// objects[0] "Sphere 0": Sphere()
fn sphere0Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 1.0);
}

fn sphere0SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 1.0);
}

/// objects[1] "Box 1": Box()
fn box1Crossing(ray: Ray) -> f32 {
    return box(ray, vec3f(-1.0), vec3f(1.0));
}

fn box1SurfaceAt(p: vec3f) -> Surface {
    return boxSurface(p, vec3f(-1.0), vec3f(1.0));
}

/// objects[2] "Torus 2": Torus()
fn torus2Crossing(ray: Ray) -> f32 {
    return torus(ray, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0, 0.25);
}

fn torus2SurfaceAt(p: vec3f) -> Surface {
    return torusSurface(p, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0, 0.25);
}

/// objects[3] "Plane 3": Plane()
fn plane3Crossing(ray: Ray) -> f32 {
    return plane(ray, vec3f(0.0, 1.0, 0.0), 0.0);
}

fn plane3SurfaceAt(p: vec3f) -> Surface {
    return planeSurface(p, vec3f(0.0, 1.0, 0.0), 0.0);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_SPHERE_0: { return placed(sphere0SurfaceAt(p), p); }
        case OBJECT_BOX_1: { return placed(box1SurfaceAt(p), p); }
        case OBJECT_TORUS_2: { return placed(torus2SurfaceAt(p), p); }
        case OBJECT_PLANE_3: { return placed(plane3SurfaceAt(p), p); }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_SPHERE_0, OBJECT_BOX_1: { return clayMaterial(at); }
        case OBJECT_TORUS_2: { return torus2Material(at); }
        case OBJECT_PLANE_3: { return defaultMaterial(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "clay": (color: "#c96f4a")
fn clayMaterial(at: Surface) -> Material {
    return matte(vec3f(0.58407843, 0.15896083, 0.068478175));
}

/// material "Torus 2": (color: "gold")
fn torus2Material(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.6795425, 0.0));
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
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
