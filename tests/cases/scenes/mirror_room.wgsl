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
    hit = nearer(hit, ballCrossing(ray), OBJECT_BALL);
    hit = nearer(hit, floorCrossing(ray), OBJECT_FLOOR);
    hit = nearer(hit, ceilingCrossing(ray), OBJECT_CEILING);
    hit = nearer(hit, backCrossing(ray), OBJECT_BACK);
    hit = nearer(hit, leftCrossing(ray), OBJECT_LEFT);
    hit = nearer(hit, rightCrossing(ray), OBJECT_RIGHT);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if ballCrossing(ray) < NO_HIT { return true; }
    if floorCrossing(ray) < NO_HIT { return true; }
    if ceilingCrossing(ray) < NO_HIT { return true; }
    if backCrossing(ray) < NO_HIT { return true; }
    if leftCrossing(ray) < NO_HIT { return true; }
    if rightCrossing(ray) < NO_HIT { return true; }
    return false;
}

/// objects[0] "ball": Sphere(center: (0, 1.6, 0), radius: 1.2)
fn ballCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0, 1.6, 0.0), 1.2);
}

fn ballSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0, 1.6, 0.0), 1.2);
}

/// objects[1] "floor": Quad(corner: (-3, 0, -3), u: (6, 0, 0), v: (0, 0, 6))
fn floorCrossing(ray: Ray) -> f32 {
    return quad(ray, vec3f(-3.0, 0.0, -3.0), vec3f(6.0, 0.0, 0.0), vec3f(0.0, 0.0, 6.0));
}

fn floorSurfaceAt(p: vec3f) -> Surface {
    return quadSurface(p, vec3f(-3.0, 0.0, -3.0), vec3f(6.0, 0.0, 0.0), vec3f(0.0, 0.0, 6.0));
}

/// objects[2] "ceiling": Quad(corner: (-3, 5, -3), u: (6, 0, 0), v: (0, 0, 6))
fn ceilingCrossing(ray: Ray) -> f32 {
    return quad(ray, vec3f(-3.0, 5.0, -3.0), vec3f(6.0, 0.0, 0.0), vec3f(0.0, 0.0, 6.0));
}

fn ceilingSurfaceAt(p: vec3f) -> Surface {
    return quadSurface(p, vec3f(-3.0, 5.0, -3.0), vec3f(6.0, 0.0, 0.0), vec3f(0.0, 0.0, 6.0));
}

/// objects[3] "back": Quad(corner: (-3, 0, -3), u: (6, 0, 0), v: (0, 5, 0))
fn backCrossing(ray: Ray) -> f32 {
    return quad(ray, vec3f(-3.0, 0.0, -3.0), vec3f(6.0, 0.0, 0.0), vec3f(0.0, 5.0, 0.0));
}

fn backSurfaceAt(p: vec3f) -> Surface {
    return quadSurface(p, vec3f(-3.0, 0.0, -3.0), vec3f(6.0, 0.0, 0.0), vec3f(0.0, 5.0, 0.0));
}

/// objects[4] "left": Quad(corner: (-3, 0, -3), u: (0, 0, 6), v: (0, 5, 0))
fn leftCrossing(ray: Ray) -> f32 {
    return quad(ray, vec3f(-3.0, 0.0, -3.0), vec3f(0.0, 0.0, 6.0), vec3f(0.0, 5.0, 0.0));
}

fn leftSurfaceAt(p: vec3f) -> Surface {
    return quadSurface(p, vec3f(-3.0, 0.0, -3.0), vec3f(0.0, 0.0, 6.0), vec3f(0.0, 5.0, 0.0));
}

/// objects[5] "right": Quad(corner: (3, 0, -3), u: (0, 0, 6), v: (0, 5, 0))
fn rightCrossing(ray: Ray) -> f32 {
    return quad(ray, vec3f(3.0, 0.0, -3.0), vec3f(0.0, 0.0, 6.0), vec3f(0.0, 5.0, 0.0));
}

fn rightSurfaceAt(p: vec3f) -> Surface {
    return quadSurface(p, vec3f(3.0, 0.0, -3.0), vec3f(0.0, 0.0, 6.0), vec3f(0.0, 5.0, 0.0));
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_BALL: { return placed(ballSurfaceAt(p), p); }
        case OBJECT_FLOOR: { return placed(floorSurfaceAt(p), p); }
        case OBJECT_CEILING: { return placed(ceilingSurfaceAt(p), p); }
        case OBJECT_BACK: { return placed(backSurfaceAt(p), p); }
        case OBJECT_LEFT: { return placed(leftSurfaceAt(p), p); }
        case OBJECT_RIGHT: { return placed(rightSurfaceAt(p), p); }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
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

/// material "mirror": (color: 0.02, reflectivity: 0.95)
fn mirrorMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.02));
    material.reflectivity = 0.95;
    return material;
}

/// material "floor": (color: Checker(scale: 1, even: 0.8, odd: 0.2), reflectivity: 0.2)
fn floorMaterial(at: Surface) -> Material {
    var material = matte(checker(at, 1.0, vec3f(0.8), vec3f(0.2)));
    material.reflectivity = 0.2;
    return material;
}

/// material "ceiling": (color: 0.7)
fn ceilingMaterial(at: Surface) -> Material {
    return matte(vec3f(0.7));
}

/// material "back": (color: 0.5, reflectivity: 0.6)
fn backMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.5));
    material.reflectivity = 0.6;
    return material;
}

/// material "left": (color: "#b03a2e", reflectivity: 0.5)
fn leftMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.43415368, 0.04231141, 0.027320893));
    material.reflectivity = 0.5;
    return material;
}

/// material "right": (color: "#2e7d4f", reflectivity: 0.5)
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
