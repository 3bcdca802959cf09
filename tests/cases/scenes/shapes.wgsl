// Generated from scenes/shapes.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   floor, Sphere 1, Box 2, Cylinder 3, Cone 4, Torus 5, Triangle 6, Capsule 7,
//             Ellipsoid 8, Disk 9, turned, upright
//   shapes    Plane, Sphere, Box, Cylinder, Cone, Torus, Triangle, Capsule, Ellipsoid, Disk
//   textures  Stripes, Gradient

const OBJECT_FLOOR: u32 = 0u;
const OBJECT_SPHERE_1: u32 = 1u;
const OBJECT_BOX_2: u32 = 2u;
const OBJECT_CYLINDER_3: u32 = 3u;
const OBJECT_CONE_4: u32 = 4u;
const OBJECT_TORUS_5: u32 = 5u;
const OBJECT_TRIANGLE_6: u32 = 6u;
const OBJECT_CAPSULE_7: u32 = 7u;
const OBJECT_ELLIPSOID_8: u32 = 8u;
const OBJECT_DISK_9: u32 = 9u;
const OBJECT_TURNED: u32 = 10u;
const OBJECT_UPRIGHT: u32 = 11u;
const LIGHTS: u32 = 2u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, floorCrossing(ray), OBJECT_FLOOR);
    hit = nearer(hit, sphere1Crossing(ray), OBJECT_SPHERE_1);
    hit = nearer(hit, box2Crossing(ray), OBJECT_BOX_2);
    hit = nearer(hit, cylinder3Crossing(ray), OBJECT_CYLINDER_3);
    hit = nearer(hit, cone4Crossing(ray), OBJECT_CONE_4);
    hit = nearer(hit, torus5Crossing(ray), OBJECT_TORUS_5);
    hit = nearer(hit, triangle6Crossing(ray), OBJECT_TRIANGLE_6);
    hit = nearer(hit, capsule7Crossing(ray), OBJECT_CAPSULE_7);
    hit = nearer(hit, ellipsoid8Crossing(ray), OBJECT_ELLIPSOID_8);
    hit = nearer(hit, disk9Crossing(ray), OBJECT_DISK_9);
    hit = nearer(hit, turnedCrossing(rayInto(turnedSpace(), ray)), OBJECT_TURNED);
    hit = nearer(hit, uprightCrossing(rayInto(uprightSpace(), ray)), OBJECT_UPRIGHT);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if floorCrossing(ray) < NO_HIT { return true; }
    if sphere1Crossing(ray) < NO_HIT { return true; }
    if box2Crossing(ray) < NO_HIT { return true; }
    if cylinder3Crossing(ray) < NO_HIT { return true; }
    if cone4Crossing(ray) < NO_HIT { return true; }
    if torus5Crossing(ray) < NO_HIT { return true; }
    if triangle6Crossing(ray) < NO_HIT { return true; }
    if capsule7Crossing(ray) < NO_HIT { return true; }
    if ellipsoid8Crossing(ray) < NO_HIT { return true; }
    if disk9Crossing(ray) < NO_HIT { return true; }
    if turnedCrossing(rayInto(turnedSpace(), ray)) < NO_HIT { return true; }
    if uprightCrossing(rayInto(uprightSpace(), ray)) < NO_HIT { return true; }
    return false;
}

/// objects[0] "floor": Plane()
fn floorCrossing(ray: Ray) -> f32 {
    return plane(ray, vec3f(0.0, 1.0, 0.0), 0.0);
}

fn floorSurfaceAt(p: vec3f) -> Surface {
    return planeSurface(p, vec3f(0.0, 1.0, 0.0), 0.0);
}

/// objects[1] "Sphere 1": Sphere(center: (-5, 1, 0))
fn sphere1Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(-5.0, 1.0, 0.0), 1.0);
}

fn sphere1SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(-5.0, 1.0, 0.0), 1.0);
}

/// objects[2] "Box 2": Box(min: (-3.6, 0, -0.8), max: (-2, 1.6, 0.8))
fn box2Crossing(ray: Ray) -> f32 {
    return box(ray, vec3f(-3.6, 0.0, -0.8), vec3f(-2.0, 1.6, 0.8));
}

fn box2SurfaceAt(p: vec3f) -> Surface {
    return boxSurface(p, vec3f(-3.6, 0.0, -0.8), vec3f(-2.0, 1.6, 0.8));
}

/// objects[3] "Cylinder 3": Cylinder(base: (-0.5, 0, 0), top: (-0.5, 1.8, 0), radius: 0.7)
fn cylinder3Crossing(ray: Ray) -> f32 {
    return cylinder(ray, vec3f(-0.5, 0.0, 0.0), vec3f(-0.5, 1.8, 0.0), 0.7);
}

fn cylinder3SurfaceAt(p: vec3f) -> Surface {
    return cylinderSurface(p, vec3f(-0.5, 0.0, 0.0), vec3f(-0.5, 1.8, 0.0), 0.7);
}

/// objects[4] "Cone 4": Cone(base: (1.4, 0, 0), top: (1.4, 2, 0), base_radius: 0.8)
fn cone4Crossing(ray: Ray) -> f32 {
    return cone(ray, vec3f(1.4, 0.0, 0.0), vec3f(1.4, 2.0, 0.0), 0.8, 0.0);
}

fn cone4SurfaceAt(p: vec3f) -> Surface {
    return coneSurface(p, vec3f(1.4, 0.0, 0.0), vec3f(1.4, 2.0, 0.0), 0.8, 0.0);
}

/// objects[5] "Torus 5": Torus(center: (3.3, 0.3, 0), major_radius: 0.8, minor_radius: 0.3)
fn torus5Crossing(ray: Ray) -> f32 {
    return torus(ray, vec3f(3.3, 0.3, 0.0), vec3f(0.0, 1.0, 0.0), 0.8, 0.3);
}

fn torus5SurfaceAt(p: vec3f) -> Surface {
    return torusSurface(p, vec3f(3.3, 0.3, 0.0), vec3f(0.0, 1.0, 0.0), 0.8, 0.3);
}

/// objects[6] "Triangle 6": Triangle(a: (4.6, 0, 0), b: (6.2, 0, 0), c: (5.4, 1.8, 0))
fn triangle6Crossing(ray: Ray) -> f32 {
    return triangle(ray, vec3f(4.6, 0.0, 0.0), vec3f(6.2, 0.0, 0.0), vec3f(5.4, 1.8, 0.0));
}

fn triangle6SurfaceAt(p: vec3f) -> Surface {
    return triangleSurface(p, vec3f(4.6, 0.0, 0.0), vec3f(6.2, 0.0, 0.0), vec3f(5.4, 1.8, 0.0));
}

/// objects[7] "Capsule 7": Capsule(base: (-4.5, 0.4, 3), top: (-3, 1.2, 3), radius: 0.4)
fn capsule7Crossing(ray: Ray) -> f32 {
    return capsule(ray, vec3f(-4.5, 0.4, 3.0), vec3f(-3.0, 1.2, 3.0), 0.4);
}

fn capsule7SurfaceAt(p: vec3f) -> Surface {
    return capsuleSurface(p, vec3f(-4.5, 0.4, 3.0), vec3f(-3.0, 1.2, 3.0), 0.4);
}

/// objects[8] "Ellipsoid 8": Ellipsoid(center: (-0.8, 0.6, 3), radii: (1, 0.6, 0.5))
fn ellipsoid8Crossing(ray: Ray) -> f32 {
    return ellipsoid(ray, vec3f(-0.8, 0.6, 3.0), vec3f(1.0, 0.6, 0.5));
}

fn ellipsoid8SurfaceAt(p: vec3f) -> Surface {
    return ellipsoidSurface(p, vec3f(-0.8, 0.6, 3.0), vec3f(1.0, 0.6, 0.5));
}

/// objects[9] "Disk 9": Disk(center: (1.2, 0.9, 3), normal: (0.4, 0.5, 1), radius: 0.9, inner_radi…
fn disk9Crossing(ray: Ray) -> f32 {
    return disk(ray, vec3f(1.2, 0.9, 3.0), vec3f(0.4, 0.5, 1.0), 0.9, 0.4);
}

fn disk9SurfaceAt(p: vec3f) -> Surface {
    return diskSurface(p, vec3f(1.2, 0.9, 3.0), vec3f(0.4, 0.5, 1.0), 0.9, 0.4);
}

/// objects[10] "turned": Box(translate: (3.4, 0.8, 3), rotate_deg: (0, 35, 20), scale: (0.7, 0.4, …
fn turnedCrossing(ray: Ray) -> f32 {
    return box(ray, vec3f(-1.0), vec3f(1.0));
}

fn turnedSurfaceAt(p: vec3f) -> Surface {
    return boxSurface(p, vec3f(-1.0), vec3f(1.0));
}

fn turnedSpace() -> Space {
    return Space(
        vec4f(1.0996445, 0.40023786, -0.81939495, -1.6007968),
        vec4f(-0.8550503, 2.3492315, 0.0, 1.027786),
        vec4f(1.0779711, 0.3923494, 1.6383041, -8.893893),
    );
}

/// objects[11] "upright": Torus(translate: (5.6, 1.0, 2.6), rotate_deg: (90, 0, 30), scale: 0.8)
fn uprightCrossing(ray: Ray) -> f32 {
    return torus(ray, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0, 0.25);
}

fn uprightSurfaceAt(p: vec3f) -> Surface {
    return torusSurface(p, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0, 0.25);
}

fn uprightSpace() -> Space {
    return Space(
        vec4f(1.0825317, 0.625, 0.0, -6.6871777),
        vec4f(0.0, 0.0, 1.25, -3.25),
        vec4f(0.625, -1.0825317, 0.0, -2.4174683),
    );
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_FLOOR: { return placed(floorSurfaceAt(p), p); }
        case OBJECT_SPHERE_1: { return placed(sphere1SurfaceAt(p), p); }
        case OBJECT_BOX_2: { return placed(box2SurfaceAt(p), p); }
        case OBJECT_CYLINDER_3: { return placed(cylinder3SurfaceAt(p), p); }
        case OBJECT_CONE_4: { return placed(cone4SurfaceAt(p), p); }
        case OBJECT_TORUS_5: { return placed(torus5SurfaceAt(p), p); }
        case OBJECT_TRIANGLE_6: { return placed(triangle6SurfaceAt(p), p); }
        case OBJECT_CAPSULE_7: { return placed(capsule7SurfaceAt(p), p); }
        case OBJECT_ELLIPSOID_8: { return placed(ellipsoid8SurfaceAt(p), p); }
        case OBJECT_DISK_9: { return placed(disk9SurfaceAt(p), p); }
        case OBJECT_TURNED: {
            return placedFrom(turnedSpace(), turnedSurfaceAt(pointInto(turnedSpace(), p)), p);
        }
        case OBJECT_UPRIGHT: {
            return placedFrom(uprightSpace(), uprightSurfaceAt(pointInto(uprightSpace(), p)), p);
        }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_SPHERE_1,
             OBJECT_BOX_2,
             OBJECT_CYLINDER_3,
             OBJECT_CONE_4,
             OBJECT_TORUS_5,
             OBJECT_TRIANGLE_6,
             OBJECT_CAPSULE_7,
             OBJECT_ELLIPSOID_8,
             OBJECT_DISK_9,
             OBJECT_TURNED,
             OBJECT_UPRIGHT: {
            return clayMaterial(at);
        }
        case OBJECT_FLOOR: { return floorMaterial(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "clay": (color: "#c96f4a", specular: 0.3, shininess: 40)
fn clayMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.58407843, 0.15896083, 0.068478175));
    material.specular = 0.3;
    material.shininess = 40.0;
    return material;
}

/// material "floor": (color: Stripes(scale: 0.5, even: "#f2efe6", odd: "#9db0a5"))
fn floorMaterial(at: Surface) -> Material {
    return matte(
        stripes(
            at,
            0.5,
            vec3f(0.8879231, 0.8631572, 0.791298),
            vec3f(0.33716366, 0.43415368, 0.37626216),
        ),
    );
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
    return vec3f(0.15);
}

/// The light `index` as the world point `p` sees it.
fn lightAt(index: u32, p: vec3f) -> Light {
    switch index {
        // lights[0]: Point(position: (-6, 9, 8), intensity: 0.7, radius: 0.6)
        case 0u: { return pointLight(p, vec3f(-6.0, 9.0, 8.0), 0.6, vec3f(0.7)); }
        // lights[1]: Directional(direction: (-1, -2, -1.5), intensity: 0.4)
        case 1u: { return directionalLight(
            vec3f(-0.37139067, -0.74278134, -0.557086),
            0.0,
            vec3f(0.4),
        ); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
