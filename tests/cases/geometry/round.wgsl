// Generated from tests/cases/geometry/round.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Sphere 0, Ellipsoid 1, Torus 2, Capsule 3
//   shapes    Sphere, Ellipsoid, Torus, Capsule

const OBJECT_SPHERE_0: u32 = 0u;
const OBJECT_ELLIPSOID_1: u32 = 1u;
const OBJECT_TORUS_2: u32 = 2u;
const OBJECT_CAPSULE_3: u32 = 3u;
const LIGHTS: u32 = 1u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, sphere0Crossing(ray), OBJECT_SPHERE_0);
    hit = nearer(hit, ellipsoid1Crossing(ray), OBJECT_ELLIPSOID_1);
    hit = nearer(hit, torus2Crossing(ray), OBJECT_TORUS_2);
    hit = nearer(hit, capsule3Crossing(ray), OBJECT_CAPSULE_3);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if sphere0Crossing(ray) < NO_HIT { return true; }
    if ellipsoid1Crossing(ray) < NO_HIT { return true; }
    if torus2Crossing(ray) < NO_HIT { return true; }
    if capsule3Crossing(ray) < NO_HIT { return true; }
    return false;
}

/// objects[0] "Sphere 0": Sphere(center: (-2.6, 0, 0), radius: 0.9)
fn sphere0Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(-2.6, 0.0, 0.0), 0.9);
}

fn sphere0SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(-2.6, 0.0, 0.0), 0.9);
}

/// objects[1] "Ellipsoid 1": Ellipsoid(center: (-0.8, 0, 0), radii: (0.6, 1.2, 0.8))
fn ellipsoid1Crossing(ray: Ray) -> f32 {
    return ellipsoid(ray, vec3f(-0.8, 0.0, 0.0), vec3f(0.6, 1.2, 0.8));
}

fn ellipsoid1SurfaceAt(p: vec3f) -> Surface {
    return ellipsoidSurface(p, vec3f(-0.8, 0.0, 0.0), vec3f(0.6, 1.2, 0.8));
}

/// objects[2] "Torus 2": Torus(center: (1.1, 0, 0), axis: (0.3, 1, 0.4), major_radius: 0.8, minor_…
fn torus2Crossing(ray: Ray) -> f32 {
    return torus(ray, vec3f(1.1, 0.0, 0.0), vec3f(0.3, 1.0, 0.4), 0.8, 0.25);
}

fn torus2SurfaceAt(p: vec3f) -> Surface {
    return torusSurface(p, vec3f(1.1, 0.0, 0.0), vec3f(0.3, 1.0, 0.4), 0.8, 0.25);
}

/// objects[3] "Capsule 3": Capsule(base: (2.6, -0.8, 0), top: (3, 0.9, 0.4), radius: 0.4)
fn capsule3Crossing(ray: Ray) -> f32 {
    return capsule(ray, vec3f(2.6, -0.8, 0.0), vec3f(3.0, 0.9, 0.4), 0.4);
}

fn capsule3SurfaceAt(p: vec3f) -> Surface {
    return capsuleSurface(p, vec3f(2.6, -0.8, 0.0), vec3f(3.0, 0.9, 0.4), 0.4);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_SPHERE_0: { return placed(sphere0SurfaceAt(p), p); }
        case OBJECT_ELLIPSOID_1: { return placed(ellipsoid1SurfaceAt(p), p); }
        case OBJECT_TORUS_2: { return placed(torus2SurfaceAt(p), p); }
        case OBJECT_CAPSULE_3: { return placed(capsule3SurfaceAt(p), p); }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_SPHERE_0: { return sphere0Material(at); }
        case OBJECT_ELLIPSOID_1: { return ellipsoid1Material(at); }
        case OBJECT_TORUS_2: { return torus2Material(at); }
        case OBJECT_CAPSULE_3: { return capsule3Material(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "Sphere 0": (color: "tomato")
fn sphere0Material(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.12477182, 0.06301002));
}

/// material "Ellipsoid 1": (color: "gold")
fn ellipsoid1Material(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.6795425, 0.0));
}

/// material "Torus 2": (color: "skyblue")
fn torus2Material(at: Surface) -> Material {
    return matte(vec3f(0.24228115, 0.6172066, 0.8307699));
}

/// material "Capsule 3": (color: "plum")
fn capsule3Material(at: Surface) -> Material {
    return matte(vec3f(0.7230551, 0.35153264, 0.7230551));
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
    return vec3f(0.019382363, 0.029556835, 0.045186203);
}

fn ambientLight() -> vec3f {
    return vec3f(0.1);
}

/// The light `index` as the world point `p` sees it.
fn lightAt(index: u32, p: vec3f) -> Light {
    switch index {
        // lights[0]: Point(position: (-3, 6, 6))
        case 0u: { return pointLight(p, vec3f(-3.0, 6.0, 6.0), 0.0, vec3f(1.0)); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
