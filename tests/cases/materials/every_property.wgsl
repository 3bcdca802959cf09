// Generated from tests/cases/materials/every_property.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Sphere 0, Box 1
//   shapes    Sphere, Box
//   textures  Noise

const OBJECT_SPHERE_0: u32 = 0u;
const OBJECT_BOX_1: u32 = 1u;
const LIGHTS: u32 = 0u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = true;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, sphere0Crossing(ray), OBJECT_SPHERE_0);
    hit = nearer(hit, box1Crossing(ray), OBJECT_BOX_1);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if sphere0Crossing(ray) < NO_HIT { return true; }
    if box1Crossing(ray) < NO_HIT { return true; }
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

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_SPHERE_0: { return placed(sphere0SurfaceAt(p), p); }
        case OBJECT_BOX_1: { return placed(box1SurfaceAt(p), p); }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_SPHERE_0: { return sphere0Material(at); }
        case OBJECT_BOX_1: { return box1Material(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "Sphere 0": (ior: 1.33, transmission: 0.5, fresnel: 5, reflectivity: 0.1, shininess: 8…
fn sphere0Material(at: Surface) -> Material {
    var material = matte(vec3f(1.0, 0.12477182, 0.06301002));
    material.specular = 0.7;
    material.shininess = 80.0;
    material.reflectivity = 0.1;
    material.fresnel = 5.0;
    material.transmission = 0.5;
    material.ior = 1.33;
    material.emission = vec3f(0.1, 0.0, 0.0);
    return material;
}

/// material "Box 1": (fresnel: None, shininess: Noise())
fn box1Material(at: Surface) -> Material {
    var material = matte(vec3f(0.8));
    material.shininess = noise(at, 1.5);
    return material;
}

/// Whether the material of `object` varies over its surface.
fn isTextured(object: u32) -> bool {
    switch object {
        case OBJECT_BOX_1: { return true; }
        default: { return false; }
    }
}

/// The world normal of `object` at `met`.
fn normalAt(object: u32, met: Placed) -> vec3f {
    switch object {
        case OBJECT_SPHERE_0: { return bumpedNormal(object, met); }
        default: { return met.normal; }
    }
}

/// The height of `object` over its surface at `at`, scene units.
fn heightAt(object: u32, at: Surface) -> f32 {
    switch object {
        case OBJECT_SPHERE_0: {
            let height = noise(at, 8.0);
            return height * 0.05;
        }
        default: { return 0.0; }
    }
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
