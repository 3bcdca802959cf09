// Generated from scenes/mirror_room.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   ball, floor, ceiling, back, left, right
//   shapes    Sphere, Quad
//   textures  Checker

const OBJECT_BALL: u32 = 0u;
const OBJECT_FLOOR: u32 = 1u;
const OBJECT_CEILING: u32 = 2u;
const OBJECT_BACK: u32 = 3u;
const OBJECT_LEFT: u32 = 4u;
const OBJECT_RIGHT: u32 = 5u;
const LIGHTS: u32 = 1u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    // objects[0] "ball": Sphere(center: (0, 1.6, 0), radius: 1.2)
    hit = nearer(hit, sphere(ray, vec3f(0.0, 1.6, 0.0), 1.2), OBJECT_BALL);
    // objects[1] "floor": Quad(corner: (-3, 0, -3), u: (6, 0, 0), v: (0, 0, 6))
    hit = nearer(
        hit,
        quad(ray, vec3f(-3.0, 0.0, -3.0), vec3f(6.0, 0.0, 0.0), vec3f(0.0, 0.0, 6.0)),
        OBJECT_FLOOR,
    );
    // objects[2] "ceiling": Quad(corner: (-3, 5, -3), u: (6, 0, 0), v: (0, 0, 6))
    hit = nearer(
        hit,
        quad(ray, vec3f(-3.0, 5.0, -3.0), vec3f(6.0, 0.0, 0.0), vec3f(0.0, 0.0, 6.0)),
        OBJECT_CEILING,
    );
    // objects[3] "back": Quad(corner: (-3, 0, -3), u: (6, 0, 0), v: (0, 5, 0))
    hit = nearer(
        hit,
        quad(ray, vec3f(-3.0, 0.0, -3.0), vec3f(6.0, 0.0, 0.0), vec3f(0.0, 5.0, 0.0)),
        OBJECT_BACK,
    );
    // objects[4] "left": Quad(corner: (-3, 0, -3), u: (0, 0, 6), v: (0, 5, 0))
    hit = nearer(
        hit,
        quad(ray, vec3f(-3.0, 0.0, -3.0), vec3f(0.0, 0.0, 6.0), vec3f(0.0, 5.0, 0.0)),
        OBJECT_LEFT,
    );
    // objects[5] "right": Quad(corner: (3, 0, -3), u: (0, 0, 6), v: (0, 5, 0))
    hit = nearer(
        hit,
        quad(ray, vec3f(3.0, 0.0, -3.0), vec3f(0.0, 0.0, 6.0), vec3f(0.0, 5.0, 0.0)),
        OBJECT_RIGHT,
    );
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if sphere(ray, vec3f(0.0, 1.6, 0.0), 1.2) < NO_HIT { return true; }
    if quad(
        ray,
        vec3f(-3.0, 0.0, -3.0),
        vec3f(6.0, 0.0, 0.0),
        vec3f(0.0, 0.0, 6.0),
    ) < NO_HIT { return true; }
    if quad(
        ray,
        vec3f(-3.0, 5.0, -3.0),
        vec3f(6.0, 0.0, 0.0),
        vec3f(0.0, 0.0, 6.0),
    ) < NO_HIT { return true; }
    if quad(
        ray,
        vec3f(-3.0, 0.0, -3.0),
        vec3f(6.0, 0.0, 0.0),
        vec3f(0.0, 5.0, 0.0),
    ) < NO_HIT { return true; }
    if quad(
        ray,
        vec3f(-3.0, 0.0, -3.0),
        vec3f(0.0, 0.0, 6.0),
        vec3f(0.0, 5.0, 0.0),
    ) < NO_HIT { return true; }
    if quad(
        ray,
        vec3f(3.0, 0.0, -3.0),
        vec3f(0.0, 0.0, 6.0),
        vec3f(0.0, 5.0, 0.0),
    ) < NO_HIT { return true; }
    return false;
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_BALL: {
            return placed(sphereSurface(p, vec3f(0.0, 1.6, 0.0), 1.2), p);
        }
        case OBJECT_FLOOR: {
            return placed(
                quadSurface(p, vec3f(-3.0, 0.0, -3.0), vec3f(6.0, 0.0, 0.0), vec3f(0.0, 0.0, 6.0)),
                p,
            );
        }
        case OBJECT_CEILING: {
            return placed(
                quadSurface(p, vec3f(-3.0, 5.0, -3.0), vec3f(6.0, 0.0, 0.0), vec3f(0.0, 0.0, 6.0)),
                p,
            );
        }
        case OBJECT_BACK: {
            return placed(
                quadSurface(p, vec3f(-3.0, 0.0, -3.0), vec3f(6.0, 0.0, 0.0), vec3f(0.0, 5.0, 0.0)),
                p,
            );
        }
        case OBJECT_LEFT: {
            return placed(
                quadSurface(p, vec3f(-3.0, 0.0, -3.0), vec3f(0.0, 0.0, 6.0), vec3f(0.0, 5.0, 0.0)),
                p,
            );
        }
        case OBJECT_RIGHT: {
            return placed(
                quadSurface(p, vec3f(3.0, 0.0, -3.0), vec3f(0.0, 0.0, 6.0), vec3f(0.0, 5.0, 0.0)),
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
        case OBJECT_BALL: { return mirrorMaterial(at); }
        case OBJECT_FLOOR: { return floorMaterial(at); }
        case OBJECT_CEILING: { return ceilingMaterial(at); }
        case OBJECT_BACK: { return backMaterial(at); }
        case OBJECT_LEFT: { return leftMaterial(at); }
        case OBJECT_RIGHT: { return rightMaterial(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

fn mirrorMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.02));
    material.reflectivity = 0.95;
    return material;
}

fn floorMaterial(at: Surface) -> Material {
    var material = matte(checker(at, 1.0, vec3f(0.8), vec3f(0.2)));
    material.reflectivity = 0.2;
    return material;
}

fn ceilingMaterial(at: Surface) -> Material {
    return matte(vec3f(0.7));
}

fn backMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.5));
    material.reflectivity = 0.6;
    return material;
}

fn leftMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.43415368, 0.04231141, 0.027320893));
    material.reflectivity = 0.5;
    return material;
}

fn rightMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.027320893, 0.20507874, 0.07818743));
    material.reflectivity = 0.5;
    return material;
}

/// Whether the material of `object` varies over its surface.
fn isTextured(object: u32) -> bool {
    switch object {
        case OBJECT_FLOOR: { return true; }
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
    return vec3f(0.2);
}

/// The light `index` as the world point `p` sees it.
fn lightAt(index: u32, p: vec3f) -> Light {
    switch index {
        // lights[0]: Point(position: (0, 4.6, 2), radius: 0.4)
        case 0u: { return pointLight(p, vec3f(0.0, 4.6, 2.0), 0.4, vec3f(1.0)); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
