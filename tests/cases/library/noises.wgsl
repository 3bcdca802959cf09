// Generated from tests/cases/library/noises.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Sphere 0, Sphere 1, Sphere 2, Sphere 3, Sphere 4, Sphere 5, Sphere 6, Sphere 7,
//             Sphere 8, Sphere 9, Sphere 10
//   shapes    Sphere
//   textures  ValueNoise, SimplexNoise, Ridged, Billow, WarpedNoise, Voronoi, Crackle, Cells,
//             ColorNoise, Clouds

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

/// material "Sphere 0": (color: ValueNoise())
fn sphere0Material(at: Surface) -> Material {
    return matte(vec3f(valueNoise(at, 2.0, 0.7)));
}

/// material "Sphere 1": (color: SimplexNoise())
fn sphere1Material(at: Surface) -> Material {
    return matte(vec3f(simplexNoise(at, 1.0, 1u, 0.5)));
}

/// material "Sphere 2": (color: Ridged())
fn sphere2Material(at: Surface) -> Material {
    return matte(vec3f(ridged(at, 0.8, 6u, 2.1, 0.65, 1.2)));
}

/// material "Sphere 3": (color: Billow())
fn sphere3Material(at: Surface) -> Material {
    return matte(vec3f(billow(at, 1.0, 5u, 2.0, 0.5)));
}

/// material "Sphere 4": (color: WarpedNoise())
fn sphere4Material(at: Surface) -> Material {
    return matte(
        warpedNoise(
            at,
            0.7,
            4u,
            1.0,
            vec3f(0.025186861, 0.048171826, 0.07818743),
            vec3f(0.3915725, 0.122138776, 0.049706567),
            vec3f(0.8069523, 0.71569353, 0.5457245),
        ),
    );
}

/// material "Sphere 5": (color: Voronoi())
fn sphere5Material(at: Surface) -> Material {
    return matte(vec3f(voronoi(at, 2.0, 1.0, 0u, 0u)));
}

/// material "Sphere 6": (color: Crackle())
fn sphere6Material(at: Surface) -> Material {
    return matte(
        crackle(
            at,
            1.8,
            1.0,
            0.05,
            0.2,
            vec3f(0.45078582, 0.2788943, 0.14126329),
            vec3f(0.035601314, 0.021219011, 0.0129830325),
        ),
    );
}

/// material "Sphere 7": (color: Cells())
fn sphere7Material(at: Surface) -> Material {
    return matte(
        cells(
            at,
            2.5,
            1.0,
            vec3f(0.6938718, 0.57112485, 0.36625263),
            vec3f(0.0703601, 0.14412847, 0.12477182),
        ),
    );
}

/// material "Sphere 8": (color: ColorNoise())
fn sphere8Material(at: Surface) -> Material {
    return matte(
        colorNoise(
            at,
            1.0,
            2u,
            0.9,
            vec3f(0.068478175, 0.15292616, 0.27467734),
            vec3f(0.8631572, 0.65140563, 0.43415368),
        ),
    );
}

/// material "Sphere 9": (color: Clouds())
fn sphere9Material(at: Surface) -> Material {
    return matte(
        clouds(
            at,
            0.8,
            5u,
            0.5,
            0.5,
            vec3f(0.10946172, 0.24620135, 0.58407843),
            vec3f(0.9646863, 0.9559733, 0.9301109),
            vec3f(0.5457245, 0.60382736, 0.6866853),
        ),
    );
}

/// material "Sphere 10": (color: Voronoi(feature: Edge, metric: Manhattan))
fn sphere10Material(at: Surface) -> Material {
    return matte(vec3f(voronoi(at, 2.0, 1.0, 3u, 1u)));
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
