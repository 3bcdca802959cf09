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
    // objects[0] "Sphere 0": Sphere()
    hit = nearer(hit, sphere(ray, vec3f(0.0), 1.0), OBJECT_SPHERE_0);
    // objects[1] "Box 1": Box()
    hit = nearer(hit, box(ray, vec3f(-1.0), vec3f(1.0)), OBJECT_BOX_1);
    // objects[2] "Torus 2": Torus()
    hit = nearer(hit, torus(ray, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0, 0.25), OBJECT_TORUS_2);
    // objects[3] "Plane 3": Plane()
    hit = nearer(hit, plane(ray, vec3f(0.0, 1.0, 0.0), 0.0), OBJECT_PLANE_3);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if sphere(ray, vec3f(0.0), 1.0) < NO_HIT { return true; }
    if box(ray, vec3f(-1.0), vec3f(1.0)) < NO_HIT { return true; }
    if torus(ray, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0, 0.25) < NO_HIT { return true; }
    if plane(ray, vec3f(0.0, 1.0, 0.0), 0.0) < NO_HIT { return true; }
    return false;
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_SPHERE_0: {
            return placed(sphereSurface(p, vec3f(0.0), 1.0), p);
        }
        case OBJECT_BOX_1: {
            return placed(boxSurface(p, vec3f(-1.0), vec3f(1.0)), p);
        }
        case OBJECT_TORUS_2: {
            return placed(torusSurface(p, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0, 0.25), p);
        }
        case OBJECT_PLANE_3: {
            return placed(planeSurface(p, vec3f(0.0, 1.0, 0.0), 0.0), p);
        }
        default: {
            return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p);
        }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_SPHERE_0, OBJECT_BOX_1: { return clayMaterial(at); }
        case OBJECT_TORUS_2: { return torus2Material(at); }
        case OBJECT_PLANE_3: { return plane3Material(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

fn clayMaterial(at: Surface) -> Material {
    return matte(vec3f(0.58407843, 0.15896083, 0.068478175));
}

fn torus2Material(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.6795425, 0.0));
}

fn plane3Material(at: Surface) -> Material {
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
