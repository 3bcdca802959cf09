// Generated from tests/cases/export/stands_alone.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   floor, ball
//   shapes    Plane, Sphere
//   textures  Checker, Gradient

const OBJECT_FLOOR: u32 = 0u;
const OBJECT_BALL: u32 = 1u;
const LIGHTS: u32 = 1u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, floorCrossing(ray), OBJECT_FLOOR);
    hit = nearer(hit, ballCrossing(ray), OBJECT_BALL);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if floorCrossing(ray) < NO_HIT { return true; }
    if ballCrossing(ray) < NO_HIT { return true; }
    return false;
}

/// objects[0] "floor": Plane()
fn floorCrossing(ray: Ray) -> f32 {
    return plane(ray, vec3f(0.0, 1.0, 0.0), 0.0);
}

fn floorSurfaceAt(p: vec3f) -> Surface {
    return planeSurface(p, vec3f(0.0, 1.0, 0.0), 0.0);
}

/// objects[1] "ball": Sphere(center: (0, 1, 0))
fn ballCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0, 1.0, 0.0), 1.0);
}

fn ballSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0, 1.0, 0.0), 1.0);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_FLOOR: { return placed(floorSurfaceAt(p), p); }
        case OBJECT_BALL: { return placed(ballSurfaceAt(p), p); }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_FLOOR: { return floorMaterial(at); }
        case OBJECT_BALL: { return ballMaterial(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "floor": (color: Checker(even: 0.2, odd: 0.6))
fn floorMaterial(at: Surface) -> Material {
    return matte(checker(at, 1.0, vec3f(0.2), vec3f(0.6)));
}

/// material "ball": (color: "tomato", reflectivity: 0.2)
fn ballMaterial(at: Surface) -> Material {
    var material = matte(vec3f(1.0, 0.12477182, 0.06301002));
    material.reflectivity = 0.2;
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
        // lights[0]: Point(position: (4, 6, 5), radius: 0.5)
        case 0u: { return pointLight(p, vec3f(4.0, 6.0, 5.0), 0.5, vec3f(1.0)); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
