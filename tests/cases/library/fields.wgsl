// Generated from tests/cases/library/fields.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Sphere 0, Sphere 1, Sphere 2, Sphere 3, Sphere 4, Sphere 5, Sphere 6, Sphere 7,
//             Sphere 8, Sphere 9, Sphere 10
//   shapes    Sphere
//   textures  RadialGradient, SphericalGradient, ConicGradient, Rings, Spiral, Waves, Ripples,
//             Wave, Onion, Leopard

const OBJECT_SPHERE_0: u32 = 0u;
const OBJECT_SPHERE_1: u32 = 1u;
const OBJECT_SPHERE_2: u32 = 2u;
const OBJECT_SPHERE_3: u32 = 3u;
const OBJECT_SPHERE_4: u32 = 4u;
const OBJECT_SPHERE_5: u32 = 5u;
const OBJECT_SPHERE_6: u32 = 6u;
const OBJECT_SPHERE_7: u32 = 7u;
const OBJECT_SPHERE_8: u32 = 8u;
const OBJECT_SPHERE_9: u32 = 9u;
const OBJECT_SPHERE_10: u32 = 10u;
const LIGHTS: u32 = 0u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, sphere0Crossing(ray), OBJECT_SPHERE_0);
    hit = nearer(hit, sphere1Crossing(ray), OBJECT_SPHERE_1);
    hit = nearer(hit, sphere2Crossing(ray), OBJECT_SPHERE_2);
    hit = nearer(hit, sphere3Crossing(ray), OBJECT_SPHERE_3);
    hit = nearer(hit, sphere4Crossing(ray), OBJECT_SPHERE_4);
    hit = nearer(hit, sphere5Crossing(ray), OBJECT_SPHERE_5);
    hit = nearer(hit, sphere6Crossing(ray), OBJECT_SPHERE_6);
    hit = nearer(hit, sphere7Crossing(ray), OBJECT_SPHERE_7);
    hit = nearer(hit, sphere8Crossing(ray), OBJECT_SPHERE_8);
    hit = nearer(hit, sphere9Crossing(ray), OBJECT_SPHERE_9);
    hit = nearer(hit, sphere10Crossing(ray), OBJECT_SPHERE_10);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if sphere0Crossing(ray) < NO_HIT { return true; }
    if sphere1Crossing(ray) < NO_HIT { return true; }
    if sphere2Crossing(ray) < NO_HIT { return true; }
    if sphere3Crossing(ray) < NO_HIT { return true; }
    if sphere4Crossing(ray) < NO_HIT { return true; }
    if sphere5Crossing(ray) < NO_HIT { return true; }
    if sphere6Crossing(ray) < NO_HIT { return true; }
    if sphere7Crossing(ray) < NO_HIT { return true; }
    if sphere8Crossing(ray) < NO_HIT { return true; }
    if sphere9Crossing(ray) < NO_HIT { return true; }
    if sphere10Crossing(ray) < NO_HIT { return true; }
    return false;
}

/// objects[0] "Sphere 0": Sphere(center: (0, 0, 0))
fn sphere0Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 1.0);
}

fn sphere0SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 1.0);
}

/// objects[1] "Sphere 1": Sphere(center: (2, 0, 0))
fn sphere1Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(2.0, 0.0, 0.0), 1.0);
}

fn sphere1SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(2.0, 0.0, 0.0), 1.0);
}

/// objects[2] "Sphere 2": Sphere(center: (4, 0, 0))
fn sphere2Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(4.0, 0.0, 0.0), 1.0);
}

fn sphere2SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(4.0, 0.0, 0.0), 1.0);
}

/// objects[3] "Sphere 3": Sphere(center: (6, 0, 0))
fn sphere3Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(6.0, 0.0, 0.0), 1.0);
}

fn sphere3SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(6.0, 0.0, 0.0), 1.0);
}

/// objects[4] "Sphere 4": Sphere(center: (8, 0, 0))
fn sphere4Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(8.0, 0.0, 0.0), 1.0);
}

fn sphere4SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(8.0, 0.0, 0.0), 1.0);
}

/// objects[5] "Sphere 5": Sphere(center: (0, 2, 0))
fn sphere5Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0, 2.0, 0.0), 1.0);
}

fn sphere5SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0, 2.0, 0.0), 1.0);
}

/// objects[6] "Sphere 6": Sphere(center: (2, 2, 0))
fn sphere6Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(2.0, 2.0, 0.0), 1.0);
}

fn sphere6SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(2.0, 2.0, 0.0), 1.0);
}

/// objects[7] "Sphere 7": Sphere(center: (4, 2, 0))
fn sphere7Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(4.0, 2.0, 0.0), 1.0);
}

fn sphere7SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(4.0, 2.0, 0.0), 1.0);
}

/// objects[8] "Sphere 8": Sphere(center: (6, 2, 0))
fn sphere8Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(6.0, 2.0, 0.0), 1.0);
}

fn sphere8SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(6.0, 2.0, 0.0), 1.0);
}

/// objects[9] "Sphere 9": Sphere(center: (8, 2, 0))
fn sphere9Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(8.0, 2.0, 0.0), 1.0);
}

fn sphere9SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(8.0, 2.0, 0.0), 1.0);
}

/// objects[10] "Sphere 10": Sphere(center: (0, 4, 0))
fn sphere10Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0, 4.0, 0.0), 1.0);
}

fn sphere10SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0, 4.0, 0.0), 1.0);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_SPHERE_0: { return placed(sphere0SurfaceAt(p), p); }
        case OBJECT_SPHERE_1: { return placed(sphere1SurfaceAt(p), p); }
        case OBJECT_SPHERE_2: { return placed(sphere2SurfaceAt(p), p); }
        case OBJECT_SPHERE_3: { return placed(sphere3SurfaceAt(p), p); }
        case OBJECT_SPHERE_4: { return placed(sphere4SurfaceAt(p), p); }
        case OBJECT_SPHERE_5: { return placed(sphere5SurfaceAt(p), p); }
        case OBJECT_SPHERE_6: { return placed(sphere6SurfaceAt(p), p); }
        case OBJECT_SPHERE_7: { return placed(sphere7SurfaceAt(p), p); }
        case OBJECT_SPHERE_8: { return placed(sphere8SurfaceAt(p), p); }
        case OBJECT_SPHERE_9: { return placed(sphere9SurfaceAt(p), p); }
        case OBJECT_SPHERE_10: { return placed(sphere10SurfaceAt(p), p); }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_SPHERE_0: { return sphere0Material(at); }
        case OBJECT_SPHERE_1: { return sphere1Material(at); }
        case OBJECT_SPHERE_2: { return sphere2Material(at); }
        case OBJECT_SPHERE_3: { return sphere3Material(at); }
        case OBJECT_SPHERE_4: { return sphere4Material(at); }
        case OBJECT_SPHERE_5: { return sphere5Material(at); }
        case OBJECT_SPHERE_6: { return sphere6Material(at); }
        case OBJECT_SPHERE_7: { return sphere7Material(at); }
        case OBJECT_SPHERE_8: { return sphere8Material(at); }
        case OBJECT_SPHERE_9: { return sphere9Material(at); }
        case OBJECT_SPHERE_10: { return sphere10Material(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "Sphere 0": (color: RadialGradient())
fn sphere0Material(at: Surface) -> Material {
    return matte(vec3f(radialGradient(at, 0.0, 5.0, false)));
}

/// material "Sphere 1": (color: SphericalGradient())
fn sphere1Material(at: Surface) -> Material {
    return matte(vec3f(sphericalGradient(at, vec3f(0.0), 0.0, 3.0, false)));
}

/// material "Sphere 2": (color: ConicGradient())
fn sphere2Material(at: Surface) -> Material {
    return matte(vec3f(conicGradient(at, 1u, 0.0)));
}

/// material "Sphere 3": (color: Rings())
fn sphere3Material(at: Surface) -> Material {
    return matte(
        rings(
            at,
            1.25,
            0.5,
            vec3f(0.3915725, 0.06301002, 0.049706567),
            vec3f(0.838799, 0.7605245, 0.62396044),
        ),
    );
}

/// material "Sphere 4": (color: Spiral())
fn sphere4Material(at: Surface) -> Material {
    return matte(
        spiral(
            at,
            0.8,
            3u,
            0.5,
            vec3f(0.8148466, 0.73791045, 0.59061885),
            vec3f(0.02842604, 0.11443538, 0.13286832),
        ),
    );
}

/// material "Sphere 5": (color: Waves())
fn sphere5Material(at: Surface) -> Material {
    return matte(vec3f(waves(at, 2.0, vec3f(0.6, 0.3, 1.0), 1.0, 2u)));
}

/// material "Sphere 6": (color: Ripples())
fn sphere6Material(at: Surface) -> Material {
    return matte(vec3f(ripples(at, 2.0, 4u, 2.5, 3u)));
}

/// material "Sphere 7": (color: Wave())
fn sphere7Material(at: Surface) -> Material {
    return matte(vec3f(wave(at, 2.0, vec3f(1.0, 0.0, 0.0), 0.0, 0.0, 0u)));
}

/// material "Sphere 8": (color: Onion())
fn sphere8Material(at: Surface) -> Material {
    return matte(vec3f(onion(at, 3.0, vec3f(0.0), 0.3)));
}

/// material "Sphere 9": (color: Leopard())
fn sphere9Material(at: Surface) -> Material {
    return matte(
        leopard(
            at,
            2.0,
            2.0,
            vec3f(0.63075715, 0.37626216, 0.13843162),
            vec3f(0.033104766, 0.017641956, 0.010329823),
        ),
    );
}

/// material "Sphere 10": (color: Wave(of: Onion(), shape: Scallop))
fn sphere10Material(at: Surface) -> Material {
    return matte(
        vec3f(wave(at, 2.0, vec3f(1.0, 0.0, 0.0), onion(at, 3.0, vec3f(0.0), 0.3), 0.0, 4u)),
    );
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
    return vec3f(0.0);
}

fn ambientLight() -> vec3f {
    return vec3f(0.1);
}

/// The light `index` as the world point `p` sees it.
fn lightAt(index: u32, p: vec3f) -> Light {
    switch index {
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
