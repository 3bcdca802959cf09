// Generated from tests/cases/background/gradient.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Sphere 0
//   shapes    Sphere
//   textures  Gradient

const OBJECT_SPHERE_0: u32 = 0u;
const LIGHTS: u32 = 0u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, sphere0Crossing(ray), OBJECT_SPHERE_0);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if sphere0Crossing(ray) < NO_HIT { return true; }
    return false;
}

/// objects[0] "Sphere 0": Sphere()
fn sphere0Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 1.0);
}

fn sphere0SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 1.0);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_SPHERE_0: { return placed(sphere0SurfaceAt(p), p); }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_SPHERE_0: { return defaultMaterial(at); }
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
    let at = skyPoint(direction);
    return gradient(
        at,
        vec3f(0.10946172, 0.24620135, 0.58407843),
        vec3f(0.73791045, 0.8148466, 0.91309863),
    );
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
