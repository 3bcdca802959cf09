// Generated from tests/cases/materials/mirror.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Plane 0, Sphere 1, Quad 2, Sphere 3
//   shapes    Plane, Sphere, Quad
//   textures  Checker

const OBJECT_PLANE_0: u32 = 0u;
const OBJECT_SPHERE_1: u32 = 1u;
const OBJECT_QUAD_2: u32 = 2u;
const OBJECT_SPHERE_3: u32 = 3u;
const LIGHTS: u32 = 1u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, plane0Crossing(ray), OBJECT_PLANE_0);
    hit = nearer(hit, sphere1Crossing(ray), OBJECT_SPHERE_1);
    hit = nearer(hit, quad2Crossing(ray), OBJECT_QUAD_2);
    hit = nearer(hit, sphere3Crossing(ray), OBJECT_SPHERE_3);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if plane0Crossing(ray) < NO_HIT { return true; }
    if sphere1Crossing(ray) < NO_HIT { return true; }
    if quad2Crossing(ray) < NO_HIT { return true; }
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

/// objects[1] "Sphere 1": Sphere(center: (0, 0.7, 0), radius: 0.7)
fn sphere1Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0, 0.7, 0.0), 0.7);
}

fn sphere1SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0, 0.7, 0.0), 0.7);
}

/// objects[2] "Quad 2": Quad(corner: (-2, 0, -2), u: (4, 0, 0), v: (0, 3, 0))
fn quad2Crossing(ray: Ray) -> f32 {
    return quad(ray, vec3f(-2.0, 0.0, -2.0), vec3f(4.0, 0.0, 0.0), vec3f(0.0, 3.0, 0.0));
}

fn quad2SurfaceAt(p: vec3f) -> Surface {
    return quadSurface(p, vec3f(-2.0, 0.0, -2.0), vec3f(4.0, 0.0, 0.0), vec3f(0.0, 3.0, 0.0));
}

/// objects[3] "Sphere 3": Sphere(center: (1.5, 0.5, 0.8), radius: 0.5)
fn sphere3Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(1.5, 0.5, 0.8), 0.5);
}

fn sphere3SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(1.5, 0.5, 0.8), 0.5);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_PLANE_0: { return placed(plane0SurfaceAt(p), p); }
        case OBJECT_SPHERE_1: { return placed(sphere1SurfaceAt(p), p); }
        case OBJECT_QUAD_2: { return placed(quad2SurfaceAt(p), p); }
        case OBJECT_SPHERE_3: { return placed(sphere3SurfaceAt(p), p); }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_PLANE_0: { return plane0Material(at); }
        case OBJECT_SPHERE_1: { return sphere1Material(at); }
        case OBJECT_QUAD_2: { return quad2Material(at); }
        case OBJECT_SPHERE_3: { return sphere3Material(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "Plane 0": (color: Checker())
fn plane0Material(at: Surface) -> Material {
    return matte(
        checker(
            at,
            1.0,
            vec3f(0.838799, 0.791298, 0.6866853),
            vec3f(0.0409152, 0.05448028, 0.07618539),
        ),
    );
}

/// material "Sphere 1": (color: "tomato", reflectivity: 0.02, fresnel: 5)
fn sphere1Material(at: Surface) -> Material {
    var material = matte(vec3f(1.0, 0.12477182, 0.06301002));
    material.reflectivity = 0.02;
    material.fresnel = 5.0;
    return material;
}

/// material "Quad 2": (color: 0.05, reflectivity: 0.9)
fn quad2Material(at: Surface) -> Material {
    var material = matte(vec3f(0.05));
    material.reflectivity = 0.9;
    return material;
}

/// material "Sphere 3": (color: 0.05, reflectivity: 0.9)
fn sphere3Material(at: Surface) -> Material {
    var material = matte(vec3f(0.05));
    material.reflectivity = 0.9;
    return material;
}

/// Whether the material of `object` varies over its surface.
fn isTextured(object: u32) -> bool {
    switch object {
        case OBJECT_PLANE_0: { return true; }
        default: { return false; }
    }
}

/// The world normal of `object` at `met`.
fn normalAt(object: u32, met: Placed) -> vec3f {
    return met.normal;
}

/// What a ray sees that leaves the scene in `direction`.
fn background(direction: vec3f) -> vec3f {
    return vec3f(0.019382363, 0.029556835, 0.045186203);
}

fn ambientLight() -> vec3f {
    return vec3f(0.3);
}

/// The light `index` as the world point `p` sees it.
fn lightAt(index: u32, p: vec3f) -> Light {
    switch index {
        // lights[0]: Point(position: (1, 5, 3))
        case 0u: { return pointLight(p, vec3f(1.0, 5.0, 3.0), 0.0, vec3f(1.0)); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
