// Generated from tests/cases/materials/glass.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Plane 0, Plane 1, Sphere 2, Box 3
//   shapes    Plane, Sphere, Box
//   textures  Checker, Stripes

const OBJECT_PLANE_0: u32 = 0u;
const OBJECT_PLANE_1: u32 = 1u;
const OBJECT_SPHERE_2: u32 = 2u;
const OBJECT_BOX_3: u32 = 3u;
const LIGHTS: u32 = 1u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = true;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, plane0Crossing(ray), OBJECT_PLANE_0);
    hit = nearer(hit, plane1Crossing(ray), OBJECT_PLANE_1);
    hit = nearer(hit, sphere2Crossing(ray), OBJECT_SPHERE_2);
    hit = nearer(hit, box3Crossing(ray), OBJECT_BOX_3);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if plane0Crossing(ray) < NO_HIT { return true; }
    if plane1Crossing(ray) < NO_HIT { return true; }
    return false;
}

/// objects[0] "Plane 0": Plane()
fn plane0Crossing(ray: Ray) -> f32 {
    return plane(ray, vec3f(0.0, 1.0, 0.0), 0.0);
}

fn plane0SurfaceAt(p: vec3f) -> Surface {
    return planeSurface(p, vec3f(0.0, 1.0, 0.0), 0.0);
}

/// objects[1] "Plane 1": Plane(normal: (0, 0, 1), offset: -3)
fn plane1Crossing(ray: Ray) -> f32 {
    return plane(ray, vec3f(0.0, 0.0, 1.0), -3.0);
}

fn plane1SurfaceAt(p: vec3f) -> Surface {
    return planeSurface(p, vec3f(0.0, 0.0, 1.0), -3.0);
}

/// objects[2] "Sphere 2": Sphere(center: (-1.1, 1, 0), casts_shadow: false)
fn sphere2Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(-1.1, 1.0, 0.0), 1.0);
}

fn sphere2SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(-1.1, 1.0, 0.0), 1.0);
}

/// objects[3] "Box 3": Box(min: (0.5, 0.2, -0.5), max: (1.7, 1.7, 0.5), casts_shadow: false)
fn box3Crossing(ray: Ray) -> f32 {
    return box(ray, vec3f(0.5, 0.2, -0.5), vec3f(1.7, 1.7, 0.5));
}

fn box3SurfaceAt(p: vec3f) -> Surface {
    return boxSurface(p, vec3f(0.5, 0.2, -0.5), vec3f(1.7, 1.7, 0.5));
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_PLANE_0: { return placed(plane0SurfaceAt(p), p); }
        case OBJECT_PLANE_1: { return placed(plane1SurfaceAt(p), p); }
        case OBJECT_SPHERE_2: { return placed(sphere2SurfaceAt(p), p); }
        case OBJECT_BOX_3: { return placed(box3SurfaceAt(p), p); }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_PLANE_0: { return plane0Material(at); }
        case OBJECT_PLANE_1: { return plane1Material(at); }
        case OBJECT_SPHERE_2: { return sphere2Material(at); }
        case OBJECT_BOX_3: { return box3Material(at); }
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

/// material "Plane 1": (color: Stripes(even: "tomato", odd: "#fff"))
fn plane1Material(at: Surface) -> Material {
    return matte(stripes(at, 1.0, vec3f(1.0, 0.12477182, 0.06301002), vec3f(1.0)));
}

/// material "Sphere 2": (color: 0, transmission: 1, reflectivity: 0.04, fresnel: 5)
fn sphere2Material(at: Surface) -> Material {
    var material = matte(vec3f(0.0));
    material.reflectivity = 0.04;
    material.fresnel = 5.0;
    material.transmission = 1.0;
    return material;
}

/// material "Box 3": (color: 0, transmission: 1, reflectivity: 0.04, fresnel: 5)
fn box3Material(at: Surface) -> Material {
    var material = matte(vec3f(0.0));
    material.reflectivity = 0.04;
    material.fresnel = 5.0;
    material.transmission = 1.0;
    return material;
}

/// Whether the material of `object` varies over its surface.
fn isTextured(object: u32) -> bool {
    switch object {
        case OBJECT_PLANE_0, OBJECT_PLANE_1: { return true; }
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
    return vec3f(0.3);
}

/// The light `index` as the world point `p` sees it.
fn lightAt(index: u32, p: vec3f) -> Light {
    switch index {
        // lights[0]: Point(position: (3, 6, 5))
        case 0u: { return pointLight(p, vec3f(3.0, 6.0, 5.0), 0.0, vec3f(1.0)); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
