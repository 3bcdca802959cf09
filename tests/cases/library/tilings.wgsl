// Generated from tests/cases/library/tilings.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Sphere 0, Sphere 1, Sphere 2, Sphere 3, Sphere 4, Sphere 5, Sphere 6, Sphere 7,
//             Sphere 8, Sphere 9, Sphere 10, Sphere 11, Sphere 12
//   shapes    Sphere
//   textures  Grid, Dots, Hexagon, Triangles, Weave, Truchet, Cairo, Scales, Herringbone,
//             Pavement, Plaid, Brick

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
const OBJECT_SPHERE_11: u32 = 11u;
const OBJECT_SPHERE_12: u32 = 12u;
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
    hit = nearer(hit, sphere11Crossing(ray), OBJECT_SPHERE_11);
    hit = nearer(hit, sphere12Crossing(ray), OBJECT_SPHERE_12);
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
    if sphere11Crossing(ray) < NO_HIT { return true; }
    if sphere12Crossing(ray) < NO_HIT { return true; }
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

/// objects[11] "Sphere 11": Sphere(center: (2, 4, 0))
fn sphere11Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(2.0, 4.0, 0.0), 1.0);
}

fn sphere11SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(2.0, 4.0, 0.0), 1.0);
}

/// objects[12] "Sphere 12": Sphere(center: (4, 4, 0))
fn sphere12Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(4.0, 4.0, 0.0), 1.0);
}

fn sphere12SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(4.0, 4.0, 0.0), 1.0);
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
        case OBJECT_SPHERE_11: { return placed(sphere11SurfaceAt(p), p); }
        case OBJECT_SPHERE_12: { return placed(sphere12SurfaceAt(p), p); }
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
        case OBJECT_SPHERE_11: { return sphere11Material(at); }
        case OBJECT_SPHERE_12: { return sphere12Material(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "Sphere 0": (color: Grid())
fn sphere0Material(at: Surface) -> Material {
    return matte(
        grid(
            at,
            2.0,
            0.06,
            5u,
            0.12,
            vec3f(0.049706567, 0.15896083, 0.27467734),
            vec3f(0.8796224, 0.8468732, 0.7605245),
        ),
    );
}

/// material "Sphere 1": (color: Dots())
fn sphere1Material(at: Surface) -> Material {
    return matte(
        dots(
            at,
            2.0,
            0.3,
            0.0,
            1u,
            vec3f(0.46207702, 0.06480327, 0.04231141),
            vec3f(0.8631572, 0.791298, 0.66538733),
        ),
    );
}

/// material "Sphere 2": (color: Hexagon())
fn sphere2Material(at: Surface) -> Material {
    return matte(
        hexagon(
            at,
            2.0,
            0.06,
            3u,
            vec3f(0.791298, 0.73791045, 0.62396044),
            vec3f(0.20507874, 0.32314324, 0.2622507),
            vec3f(0.033104766, 0.08021983, 0.10224174),
            vec3f(0.5394795, 0.4793202, 0.38132605),
        ),
    );
}

/// material "Sphere 3": (color: Triangles())
fn sphere3Material(at: Surface) -> Material {
    return matte(
        triangles(
            at,
            1.5,
            0.03,
            vec3f(0.6866853, 0.36130682, 0.068478175),
            vec3f(0.0703601, 0.107023105, 0.14702727),
            vec3f(0.8631572, 0.8148466, 0.71569353),
        ),
    );
}

/// material "Sphere 4": (color: Weave())
fn sphere4Material(at: Surface) -> Material {
    return matte(
        weave(
            at,
            3.0,
            0.86,
            0.7,
            vec3f(0.39675525, 0.1651322, 0.045186203),
            vec3f(0.71569353, 0.496933, 0.23074007),
            vec3f(0.025186861, 0.014443845, 0.009134059),
        ),
    );
}

/// material "Sphere 5": (color: Truchet())
fn sphere5Material(at: Surface) -> Material {
    return matte(
        truchet(
            at,
            2.0,
            0.14,
            0u,
            vec3f(0.8962694, 0.838799, 0.71569353),
            vec3f(0.025186861, 0.086500466, 0.12743768),
            vec3f(0.57758045, 0.18782078, 0.10224174),
        ),
    );
}

/// material "Sphere 6": (color: Cairo())
fn sphere6Material(at: Surface) -> Material {
    return matte(
        cairo(
            at,
            2.0,
            0.05,
            0.35,
            vec3f(0.6444797, 0.45641103, 0.25415212),
            vec3f(0.14702727, 0.122138776, 0.09530747),
        ),
    );
}

/// material "Sphere 7": (color: Scales())
fn sphere7Material(at: Surface) -> Material {
    return matte(
        scales(
            at,
            3.0,
            0.5,
            0.06,
            0.3,
            vec3f(0.5457245, 0.73046076, 0.55201143),
            vec3f(0.033104766, 0.19461784, 0.20507874),
            vec3f(0.008568126, 0.046665087, 0.057805438),
        ),
    );
}

/// material "Sphere 8": (color: Herringbone())
fn sphere8Material(at: Surface) -> Material {
    return matte(
        herringbone(
            at,
            3.0,
            4u,
            0.05,
            0.5,
            vec3f(0.5149177, 0.23455061, 0.066625945),
            vec3f(0.04231141, 0.019382363, 0.008023193),
        ),
    );
}

/// material "Sphere 9": (color: Pavement())
fn sphere9Material(at: Surface) -> Material {
    return matte(
        pavement(
            at,
            2.0,
            0.29,
            0.06,
            vec3f(0.7835378, 0.73791045, 0.6375969),
            vec3f(0.035601314, 0.04373503, 0.051269464),
            vec3f(0.32314324, 0.28314877, 0.23074007),
        ),
    );
}

/// material "Sphere 10": (color: Plaid())
fn sphere10Material(at: Surface) -> Material {
    return matte(
        plaid(
            at,
            1.0,
            80.0,
            0.7,
            vec3f(0.02842604, 0.068478175, 0.045186203),
            vec3f(0.012286489, 0.023153368, 0.068478175),
            vec3f(0.33245155, 0.02842604, 0.025186861),
            vec3f(0.7605245, 0.55834043, 0.14412847),
        ),
    );
}

/// material "Sphere 11": (color: Brick(bond: Stack))
fn sphere11Material(at: Surface) -> Material {
    return matte(
        brick(
            at,
            4.0,
            3.0,
            1u,
            0.1,
            0.15,
            vec3f(0.3712377, 0.084376216, 0.04231141),
            vec3f(0.62396044, 0.57112485, 0.4910209),
        ),
    );
}

/// material "Sphere 12": (color: Brick(bond: Third))
fn sphere12Material(at: Surface) -> Material {
    return matte(
        brick(
            at,
            4.0,
            3.0,
            2u,
            0.1,
            0.15,
            vec3f(0.3712377, 0.084376216, 0.04231141),
            vec3f(0.62396044, 0.57112485, 0.4910209),
        ),
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
