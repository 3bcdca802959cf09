// Generated from tests/cases/lights/kinds.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Plane 0, Sphere 1, Sphere 2, Sphere 3
//   shapes    Plane, Sphere

const OBJECT_PLANE_0: u32 = 0u;
const OBJECT_SPHERE_1: u32 = 1u;
const OBJECT_SPHERE_2: u32 = 2u;
const OBJECT_SPHERE_3: u32 = 3u;
const LIGHTS: u32 = 4u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, plane0Crossing(ray), OBJECT_PLANE_0);
    hit = nearer(hit, sphere1Crossing(ray), OBJECT_SPHERE_1);
    hit = nearer(hit, sphere2Crossing(ray), OBJECT_SPHERE_2);
    hit = nearer(hit, sphere3Crossing(ray), OBJECT_SPHERE_3);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if plane0Crossing(ray) < NO_HIT { return true; }
    if sphere1Crossing(ray) < NO_HIT { return true; }
    if sphere2Crossing(ray) < NO_HIT { return true; }
    if sphere3Crossing(ray) < NO_HIT { return true; }
    return false;
}

/// objects[0] "Plane 0": Plane()
fn plane0Crossing(ray: Ray) -> f32 {
    return plane(ray, vec3f(0.0, 1.0, 0.0), 0.0);
}

fn plane0SurfaceAt(p: vec3f) -> Surface {
    return planeSurface(p, vec3f(0.0, 1.0, 0.0), 0.0);
}

/// objects[1] "Sphere 1": Sphere(center: (-3, 0.6, 0), radius: 0.6)
fn sphere1Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(-3.0, 0.6, 0.0), 0.6);
}

fn sphere1SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(-3.0, 0.6, 0.0), 0.6);
}

/// objects[2] "Sphere 2": Sphere(center: (0, 0.6, 0), radius: 0.6)
fn sphere2Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0, 0.6, 0.0), 0.6);
}

fn sphere2SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0, 0.6, 0.0), 0.6);
}

/// objects[3] "Sphere 3": Sphere(center: (3, 0.6, 0), radius: 0.6)
fn sphere3Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(3.0, 0.6, 0.0), 0.6);
}

fn sphere3SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(3.0, 0.6, 0.0), 0.6);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_PLANE_0: { return placed(plane0SurfaceAt(p), p); }
        case OBJECT_SPHERE_1: { return placed(sphere1SurfaceAt(p), p); }
        case OBJECT_SPHERE_2: { return placed(sphere2SurfaceAt(p), p); }
        case OBJECT_SPHERE_3: { return placed(sphere3SurfaceAt(p), p); }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_PLANE_0, OBJECT_SPHERE_1, OBJECT_SPHERE_2, OBJECT_SPHERE_3: {
            return defaultMaterial(at);
        }
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
    return vec3f(0.0);
}

fn ambientLight() -> vec3f {
    return vec3f(0.02);
}

/// The light `index` as the world point `p` sees it.
fn lightAt(index: u32, p: vec3f) -> Light {
    switch index {
        // lights[0]: Point(position: (-3, 3, 0), color: "tomato", intensity: 0.8)
        case 0u: { return pointLight(
            p,
            vec3f(-3.0, 3.0, 0.0),
            0.0,
            vec3f(0.8, 0.099817455, 0.050408017),
        ); }
        // lights[1]: Directional(direction: (1, -2, -1), intensity: 0.2)
        case 1u: { return directionalLight(
            vec3f(0.40824828, -0.81649655, -0.40824828),
            0.0,
            vec3f(0.2),
        ); }
        // lights[2]: Spot(position: (3, 4, 0), target: (3, 0, 0), cone_deg: 40, blend: 0.3, color:…
        case 2u: { return spotLight(
            p,
            vec3f(3.0, 4.0, 0.0),
            0.0,
            vec3f(0.0, -1.0, 0.0),
            0.9702957,
            0.9396926,
            vec3f(1.0, 0.6795425, 0.0),
        ); }
        // lights[3]: Rect(corner: (0, 3, -2), u: (0, 0, 0), v: (0, 0, 0), color: "skyblue", intens…
        case 3u: { return rectLight(
            p,
            vec3f(0.0, 3.0, -2.0),
            vec3f(0.0),
            vec3f(0.0),
            vec3f(0.12114058, 0.3086033, 0.41538495),
        ); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
