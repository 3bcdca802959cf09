// Generated from tests/cases/geometry/inside_a_sphere.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Sphere 0, Sphere 1
//   shapes    Sphere
//   textures  Checker

const OBJECT_SPHERE_0: u32 = 0u;
const OBJECT_SPHERE_1: u32 = 1u;
const LIGHTS: u32 = 1u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, sphere0Crossing(ray), OBJECT_SPHERE_0);
    hit = nearer(hit, sphere1Crossing(ray), OBJECT_SPHERE_1);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if sphere0Crossing(ray) < NO_HIT { return true; }
    if sphere1Crossing(ray) < NO_HIT { return true; }
    return false;
}

/// objects[0] "Sphere 0": Sphere(radius: 4)
fn sphere0Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 4.0);
}

fn sphere0SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 4.0);
}

/// objects[1] "Sphere 1": Sphere(center: (0, -1, -1), radius: 0.7)
fn sphere1Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0, -1.0, -1.0), 0.7);
}

fn sphere1SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0, -1.0, -1.0), 0.7);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_SPHERE_0: { return placed(sphere0SurfaceAt(p), p); }
        case OBJECT_SPHERE_1: { return placed(sphere1SurfaceAt(p), p); }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_SPHERE_0: { return sphere0Material(at); }
        case OBJECT_SPHERE_1: { return sphere1Material(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "Sphere 0": (color: Checker(scale: 1, even: "#e8d5b0", odd: "#5a7d8c"))
fn sphere0Material(at: Surface) -> Material {
    return matte(
        checker(
            at,
            1.0,
            vec3f(0.8069523, 0.66538733, 0.43415368),
            vec3f(0.10224174, 0.20507874, 0.2622507),
        ),
    );
}

/// material "Sphere 1": (color: "tomato")
fn sphere1Material(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.12477182, 0.06301002));
}

/// Whether the material of `object` varies over its surface.
fn isTextured(object: u32) -> bool {
    switch object {
        case OBJECT_SPHERE_0: { return true; }
        default: { return false; }
    }
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
        // lights[0]: Point(position: (0, 2, 0))
        case 0u: { return pointLight(p, vec3f(0.0, 2.0, 0.0), 0.0, vec3f(1.0)); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
