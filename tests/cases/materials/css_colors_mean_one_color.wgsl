// Generated from tests/cases/materials/css_colors_mean_one_color.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   a, b, c, d, e, f, g, h
//   shapes    Sphere

const OBJECT_A: u32 = 0u;
const OBJECT_B: u32 = 1u;
const OBJECT_C: u32 = 2u;
const OBJECT_D: u32 = 3u;
const OBJECT_E: u32 = 4u;
const OBJECT_F: u32 = 5u;
const OBJECT_G: u32 = 6u;
const OBJECT_H: u32 = 7u;
const LIGHTS: u32 = 0u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    // objects[0] "a": Sphere()
    hit = nearer(hit, sphere(ray, vec3f(0.0), 1.0), OBJECT_A);
    // objects[1] "b": Sphere()
    hit = nearer(hit, sphere(ray, vec3f(0.0), 1.0), OBJECT_B);
    // objects[2] "c": Sphere()
    hit = nearer(hit, sphere(ray, vec3f(0.0), 1.0), OBJECT_C);
    // objects[3] "d": Sphere()
    hit = nearer(hit, sphere(ray, vec3f(0.0), 1.0), OBJECT_D);
    // objects[4] "e": Sphere()
    hit = nearer(hit, sphere(ray, vec3f(0.0), 1.0), OBJECT_E);
    // objects[5] "f": Sphere()
    hit = nearer(hit, sphere(ray, vec3f(0.0), 1.0), OBJECT_F);
    // objects[6] "g": Sphere()
    hit = nearer(hit, sphere(ray, vec3f(0.0), 1.0), OBJECT_G);
    // objects[7] "h": Sphere()
    hit = nearer(hit, sphere(ray, vec3f(0.0), 1.0), OBJECT_H);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if sphere(ray, vec3f(0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(0.0), 1.0) < NO_HIT { return true; }
    return false;
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_A: {
            return placed(sphereSurface(p, vec3f(0.0), 1.0), p);
        }
        case OBJECT_B: {
            return placed(sphereSurface(p, vec3f(0.0), 1.0), p);
        }
        case OBJECT_C: {
            return placed(sphereSurface(p, vec3f(0.0), 1.0), p);
        }
        case OBJECT_D: {
            return placed(sphereSurface(p, vec3f(0.0), 1.0), p);
        }
        case OBJECT_E: {
            return placed(sphereSurface(p, vec3f(0.0), 1.0), p);
        }
        case OBJECT_F: {
            return placed(sphereSurface(p, vec3f(0.0), 1.0), p);
        }
        case OBJECT_G: {
            return placed(sphereSurface(p, vec3f(0.0), 1.0), p);
        }
        case OBJECT_H: {
            return placed(sphereSurface(p, vec3f(0.0), 1.0), p);
        }
        default: {
            return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p);
        }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_A: { return aMaterial(at); }
        case OBJECT_B: { return bMaterial(at); }
        case OBJECT_C: { return cMaterial(at); }
        case OBJECT_D: { return dMaterial(at); }
        case OBJECT_E: { return eMaterial(at); }
        case OBJECT_F: { return fMaterial(at); }
        case OBJECT_G: { return gMaterial(at); }
        case OBJECT_H: { return hMaterial(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

fn aMaterial(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.24620135, 0.0));
}

fn bMaterial(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.24620135, 0.0));
}

fn cMaterial(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.24620135, 0.0));
}

fn dMaterial(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.24620135, 0.0));
}

fn eMaterial(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.24620129, 0.0));
}

fn fMaterial(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.24620129, 0.0));
}

fn gMaterial(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.24620129, 0.0));
}

fn hMaterial(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.24620129, 0.0));
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
