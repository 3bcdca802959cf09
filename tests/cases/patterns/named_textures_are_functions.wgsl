// Generated from tests/cases/patterns/named_textures_are_functions.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Sphere 0, Box 1
//   shapes    Sphere, Box
//   textures  Wood, Noise

const OBJECT_SPHERE_0: u32 = 0u;
const OBJECT_BOX_1: u32 = 1u;
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
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if sphere(ray, vec3f(0.0), 1.0) < NO_HIT { return true; }
    if box(ray, vec3f(-1.0), vec3f(1.0)) < NO_HIT { return true; }
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
        default: {
            return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p);
        }
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

fn sphere0Material(at: Surface) -> Material {
    let shared1 = grainTexture(at);
    var material = matte(
        wood(
            at,
            6.0,
            vec3f(1.0, 0.12, 0.06),
            0.5,
            0.4,
            vec3f(0.57112485, 0.32314324, 0.12477182),
            vec3f(shared1),
        ),
    );
    material.specular = shared1;
    return material;
}

fn box1Material(at: Surface) -> Material {
    return matte(sameBoardTexture(at));
}

/// Whether the material of `object` varies over its surface.
fn isTextured(object: u32) -> bool {
    return true;
}

/// The world normal of `object` at `met`.
fn normalAt(object: u32, met: Placed) -> vec3f {
    switch object {
        case OBJECT_BOX_1: { return bumpedNormal(object, met); }
        default: { return met.normal; }
    }
}

/// The height of `object` over its surface at `at`, scene units.
fn heightAt(object: u32, at: Surface) -> f32 {
    switch object {
        case OBJECT_BOX_1: {
            let height = grainTexture(at);
            return height * 0.1;
        }
        default: { return 0.0; }
    }
}

/// What a ray sees that leaves the scene in `direction`.
fn background(direction: vec3f) -> vec3f {
    let at = skyPoint(direction);
    return plainTexture(at);
}

fn ambientLight() -> vec3f {
    return vec3f(0.1);
}

/// textures: "grain"
fn grainTexture(at: Surface) -> f32 {
    return noise(at, 20.0);
}

/// textures: "board"
fn boardTexture(at: Surface) -> vec3f {
    return wood(
        at,
        6.0,
        vec3f(1.0, 0.12, 0.06),
        0.5,
        0.4,
        vec3f(0.57112485, 0.32314324, 0.12477182),
        vec3f(grainTexture(at)),
    );
}

/// textures: "same board"
fn sameBoardTexture(at: Surface) -> vec3f {
    return boardTexture(at);
}

/// textures: "plain"
fn plainTexture(at: Surface) -> vec3f {
    return vec3f(1.0, 0.12477182, 0.06301002);
}

/// The light `index` as the world point `p` sees it.
fn lightAt(index: u32, p: vec3f) -> Light {
    switch index {
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
