// Generated from scenes/glass.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   floor, wall, ball, rod
//   shapes    Plane, Sphere, Cylinder
//   textures  Checker, Brick

const OBJECT_FLOOR: u32 = 0u;
const OBJECT_WALL: u32 = 1u;
const OBJECT_BALL: u32 = 2u;
const OBJECT_ROD: u32 = 3u;
const LIGHTS: u32 = 1u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = true;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, floorCrossing(ray), OBJECT_FLOOR);
    hit = nearer(hit, wallCrossing(ray), OBJECT_WALL);
    hit = nearer(hit, ballCrossing(ray), OBJECT_BALL);
    hit = nearer(hit, rodCrossing(ray), OBJECT_ROD);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if floorCrossing(ray) < NO_HIT { return true; }
    if wallCrossing(ray) < NO_HIT { return true; }
    return false;
}

/// objects[0] "floor": Plane()
fn floorCrossing(ray: Ray) -> f32 {
    return plane(ray, vec3f(0.0, 1.0, 0.0), 0.0);
}

fn floorSurfaceAt(p: vec3f) -> Surface {
    return planeSurface(p, vec3f(0.0, 1.0, 0.0), 0.0);
}

/// objects[1] "wall": Plane(normal: (0, 0, 1), offset: -3)
fn wallCrossing(ray: Ray) -> f32 {
    return plane(ray, vec3f(0.0, 0.0, 1.0), -3.0);
}

fn wallSurfaceAt(p: vec3f) -> Surface {
    return planeSurface(p, vec3f(0.0, 0.0, 1.0), -3.0);
}

/// objects[2] "ball": Sphere(center: (-1.3, 1.2, 0), radius: 1.2, casts_shadow: false)
fn ballCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(-1.3, 1.2, 0.0), 1.2);
}

fn ballSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(-1.3, 1.2, 0.0), 1.2);
}

/// objects[3] "rod": Cylinder(base: (1.6, 0, 0.5), top: (1.6, 2.2, 0.5), radius: 0.7, casts_shadow…
fn rodCrossing(ray: Ray) -> f32 {
    return cylinder(ray, vec3f(1.6, 0.0, 0.5), vec3f(1.6, 2.2, 0.5), 0.7);
}

fn rodSurfaceAt(p: vec3f) -> Surface {
    return cylinderSurface(p, vec3f(1.6, 0.0, 0.5), vec3f(1.6, 2.2, 0.5), 0.7);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_FLOOR: { return placed(floorSurfaceAt(p), p); }
        case OBJECT_WALL: { return placed(wallSurfaceAt(p), p); }
        case OBJECT_BALL: { return placed(ballSurfaceAt(p), p); }
        case OBJECT_ROD: { return placed(rodSurfaceAt(p), p); }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_BALL, OBJECT_ROD: { return glassMaterial(at); }
        case OBJECT_FLOOR: { return floorMaterial(at); }
        case OBJECT_WALL: { return wallMaterial(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "glass": (color: 0.0, specular: 0.8, shininess: 200, reflectivity: 0.04, fresnel: 5, t…
fn glassMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.0));
    material.specular = 0.8;
    material.shininess = 200.0;
    material.reflectivity = 0.04;
    material.fresnel = 5.0;
    material.transmission = 1.0;
    material.ior = 1.5;
    return material;
}

/// material "floor": (color: Checker(scale: 1, even: 0.8, odd: 0.3))
fn floorMaterial(at: Surface) -> Material {
    return matte(checker(at, 1.0, vec3f(0.8), vec3f(0.3)));
}

/// material "wall": (color: Brick(scale: 2))
fn wallMaterial(at: Surface) -> Material {
    return matte(
        brick(
            at,
            2.0,
            3.0,
            0u,
            0.1,
            0.15,
            vec3f(0.3712377, 0.084376216, 0.04231141),
            vec3f(0.62396044, 0.57112485, 0.4910209),
        ),
    );
}

/// Whether the material of `object` varies over its surface.
fn isTextured(object: u32) -> bool {
    switch object {
        case OBJECT_FLOOR, OBJECT_WALL: { return true; }
        default: { return false; }
    }
}

/// The world normal of `object` at `met`.
fn normalAt(object: u32, met: Placed) -> vec3f {
    return met.normal;
}

/// What a ray sees that leaves the scene in `direction`.
fn background(direction: vec3f) -> vec3f {
    return vec3f(0.5028865, 0.6444797, 0.8549926);
}

fn ambientLight() -> vec3f {
    return vec3f(0.2);
}

/// The light `index` as the world point `p` sees it.
fn lightAt(index: u32, p: vec3f) -> Light {
    switch index {
        // lights[0]: Point(position: (3, 6, 5))
        case 0u: { return pointLight(p, vec3f(3.0, 6.0, 5.0), 0.0, vec3f(1.0)); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
