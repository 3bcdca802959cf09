// Generated from tests/cases/patterns/nested.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Plane 0, Sphere 1, Sphere 2
//   shapes    Plane, Sphere
//   textures  Checker, Noise, Stripes, Brick, Wood, Marble

const OBJECT_PLANE_0: u32 = 0u;
const OBJECT_SPHERE_1: u32 = 1u;
const OBJECT_SPHERE_2: u32 = 2u;
const LIGHTS: u32 = 1u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, plane0Crossing(ray), OBJECT_PLANE_0);
    hit = nearer(hit, sphere1Crossing(ray), OBJECT_SPHERE_1);
    hit = nearer(hit, sphere2Crossing(ray), OBJECT_SPHERE_2);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if plane0Crossing(ray) < NO_HIT { return true; }
    if sphere1Crossing(ray) < NO_HIT { return true; }
    if sphere2Crossing(ray) < NO_HIT { return true; }
    return false;
}

/// objects[0] "Plane 0": Plane()
fn plane0Crossing(ray: Ray) -> f32 {
    return plane(ray, vec3f(0.0, 1.0, 0.0), 0.0);
}

fn plane0SurfaceAt(p: vec3f) -> Surface {
    return planeSurface(p, vec3f(0.0, 1.0, 0.0), 0.0);
}

/// objects[1] "Sphere 1": Sphere(center: (-1.2, 1, 0))
fn sphere1Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(-1.2, 1.0, 0.0), 1.0);
}

fn sphere1SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(-1.2, 1.0, 0.0), 1.0);
}

/// objects[2] "Sphere 2": Sphere(center: (1.2, 1, 0))
fn sphere2Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(1.2, 1.0, 0.0), 1.0);
}

fn sphere2SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(1.2, 1.0, 0.0), 1.0);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_PLANE_0: { return placed(plane0SurfaceAt(p), p); }
        case OBJECT_SPHERE_1: { return placed(sphere1SurfaceAt(p), p); }
        case OBJECT_SPHERE_2: { return placed(sphere2SurfaceAt(p), p); }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_PLANE_0: { return plane0Material(at); }
        case OBJECT_SPHERE_1: { return sphere1Material(at); }
        case OBJECT_SPHERE_2: { return sphere2Material(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "Plane 0": (color: Checker(even: Noise(scale: 6), odd: Stripes(scale: 4, even: "#22334…
fn plane0Material(at: Surface) -> Material {
    return matte(
        checker(
            at,
            1.0,
            vec3f(noise(at, 6.0)),
            stripes(
                at,
                4.0,
                vec3f(0.015996294, 0.033104766, 0.057805438),
                vec3f(0.13286832, 0.18447499, 0.24620135),
            ),
        ),
    );
}

/// material "Sphere 1": (color: Brick(scale: 4, joint: Checker(scale: 8, even: "gold", odd: "navy"…
fn sphere1Material(at: Surface) -> Material {
    return matte(
        brick(
            at,
            4.0,
            3.0,
            0u,
            0.1,
            0.15,
            vec3f(0.3712377, 0.084376216, 0.04231141),
            checker(at, 8.0, vec3f(1.0, 0.6795425, 0.0), vec3f(0.0, 0.0, 0.21586053)),
        ),
    );
}

/// material "Sphere 2": (color: Wood(scale: 6, light: Marble(scale: 3)), specular: Noise(scale: 9))
fn sphere2Material(at: Surface) -> Material {
    var material = matte(
        wood(
            at,
            6.0,
            vec3f(1.0, 0.12, 0.06),
            0.5,
            0.4,
            marble(
                at,
                3.0,
                6u,
                2.0,
                5.0,
                vec3f(0.8879231, 0.8631572, 0.8148466),
                vec3f(0.0703601, 0.08021983, 0.097587354),
            ),
            vec3f(0.20507874, 0.068478175, 0.017641956),
        ),
    );
    material.specular = noise(at, 9.0);
    return material;
}

/// Whether the material of `object` varies over its surface.
fn isTextured(object: u32) -> bool {
    return true;
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
    return vec3f(0.1);
}

/// The light `index` as the world point `p` sees it.
fn lightAt(index: u32, p: vec3f) -> Light {
    switch index {
        // lights[0]: Point(position: (-3, 7, 6))
        case 0u: { return pointLight(p, vec3f(-3.0, 7.0, 6.0), 0.0, vec3f(1.0)); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
