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
    // objects[0] "Sphere 0": Sphere(center: (0, 0, 0))
    hit = nearer(hit, sphere(ray, vec3f(0.0), 1.0), OBJECT_SPHERE_0);
    // objects[1] "Sphere 1": Sphere(center: (2, 0, 0))
    hit = nearer(hit, sphere(ray, vec3f(2.0, 0.0, 0.0), 1.0), OBJECT_SPHERE_1);
    // objects[2] "Sphere 2": Sphere(center: (4, 0, 0))
    hit = nearer(hit, sphere(ray, vec3f(4.0, 0.0, 0.0), 1.0), OBJECT_SPHERE_2);
    // objects[3] "Sphere 3": Sphere(center: (6, 0, 0))
    hit = nearer(hit, sphere(ray, vec3f(6.0, 0.0, 0.0), 1.0), OBJECT_SPHERE_3);
    // objects[4] "Sphere 4": Sphere(center: (8, 0, 0))
    hit = nearer(hit, sphere(ray, vec3f(8.0, 0.0, 0.0), 1.0), OBJECT_SPHERE_4);
    // objects[5] "Sphere 5": Sphere(center: (0, 2, 0))
    hit = nearer(hit, sphere(ray, vec3f(0.0, 2.0, 0.0), 1.0), OBJECT_SPHERE_5);
    // objects[6] "Sphere 6": Sphere(center: (2, 2, 0))
    hit = nearer(hit, sphere(ray, vec3f(2.0, 2.0, 0.0), 1.0), OBJECT_SPHERE_6);
    // objects[7] "Sphere 7": Sphere(center: (4, 2, 0))
    hit = nearer(hit, sphere(ray, vec3f(4.0, 2.0, 0.0), 1.0), OBJECT_SPHERE_7);
    // objects[8] "Sphere 8": Sphere(center: (6, 2, 0))
    hit = nearer(hit, sphere(ray, vec3f(6.0, 2.0, 0.0), 1.0), OBJECT_SPHERE_8);
    // objects[9] "Sphere 9": Sphere(center: (8, 2, 0))
    hit = nearer(hit, sphere(ray, vec3f(8.0, 2.0, 0.0), 1.0), OBJECT_SPHERE_9);
    // objects[10] "Sphere 10": Sphere(center: (0, 4, 0))
    hit = nearer(hit, sphere(ray, vec3f(0.0, 4.0, 0.0), 1.0), OBJECT_SPHERE_10);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if sphere(ray, vec3f(0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(2.0, 0.0, 0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(4.0, 0.0, 0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(6.0, 0.0, 0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(8.0, 0.0, 0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(0.0, 2.0, 0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(2.0, 2.0, 0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(4.0, 2.0, 0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(6.0, 2.0, 0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(8.0, 2.0, 0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(0.0, 4.0, 0.0), 1.0) < NO_HIT { return true; }
    return false;
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_SPHERE_0: {
            return placed(sphereSurface(p, vec3f(0.0), 1.0), p);
        }
        case OBJECT_SPHERE_1: {
            return placed(sphereSurface(p, vec3f(2.0, 0.0, 0.0), 1.0), p);
        }
        case OBJECT_SPHERE_2: {
            return placed(sphereSurface(p, vec3f(4.0, 0.0, 0.0), 1.0), p);
        }
        case OBJECT_SPHERE_3: {
            return placed(sphereSurface(p, vec3f(6.0, 0.0, 0.0), 1.0), p);
        }
        case OBJECT_SPHERE_4: {
            return placed(sphereSurface(p, vec3f(8.0, 0.0, 0.0), 1.0), p);
        }
        case OBJECT_SPHERE_5: {
            return placed(sphereSurface(p, vec3f(0.0, 2.0, 0.0), 1.0), p);
        }
        case OBJECT_SPHERE_6: {
            return placed(sphereSurface(p, vec3f(2.0, 2.0, 0.0), 1.0), p);
        }
        case OBJECT_SPHERE_7: {
            return placed(sphereSurface(p, vec3f(4.0, 2.0, 0.0), 1.0), p);
        }
        case OBJECT_SPHERE_8: {
            return placed(sphereSurface(p, vec3f(6.0, 2.0, 0.0), 1.0), p);
        }
        case OBJECT_SPHERE_9: {
            return placed(sphereSurface(p, vec3f(8.0, 2.0, 0.0), 1.0), p);
        }
        case OBJECT_SPHERE_10: {
            return placed(sphereSurface(p, vec3f(0.0, 4.0, 0.0), 1.0), p);
        }
        default: {
            return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p);
        }
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

fn sphere0Material(at: Surface) -> Material {
    return matte(vec3f(valueNoise(at, 2.0, 0.7)));
}

fn sphere1Material(at: Surface) -> Material {
    return matte(vec3f(simplexNoise(at, 1.0, 1u, 0.5)));
}

fn sphere2Material(at: Surface) -> Material {
    return matte(vec3f(ridged(at, 0.8, 6u, 2.1, 0.65, 1.2)));
}

fn sphere3Material(at: Surface) -> Material {
    return matte(vec3f(billow(at, 1.0, 5u, 2.0, 0.5)));
}

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

fn sphere5Material(at: Surface) -> Material {
    return matte(vec3f(voronoi(at, 2.0, 1.0, 0u, 0u)));
}

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
