// Generated from tests/cases/library/combinations.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Sphere 0, Sphere 1, Sphere 2, Sphere 3, Sphere 4, Sphere 5, Sphere 6, Sphere 7,
//             Sphere 8, Sphere 9, Sphere 10, Sphere 11, Sphere 12, Sphere 13, Sphere 14,
//             Sphere 15, Sphere 16, Sphere 17
//   shapes    Sphere
//   textures  Add, Checker, Noise, Blend, Fbm, Choose, Brick, Marble, Contrast, Difference, Gamma,
//             Grey, Hue, Invert, Maximum, Minimum, Multiply, Overlay, Quantize, Remap, Screen,
//             SoftStep, Threshold

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
const OBJECT_SPHERE_13: u32 = 13u;
const OBJECT_SPHERE_14: u32 = 14u;
const OBJECT_SPHERE_15: u32 = 15u;
const OBJECT_SPHERE_16: u32 = 16u;
const OBJECT_SPHERE_17: u32 = 17u;
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
    // objects[11] "Sphere 11": Sphere(center: (2, 4, 0))
    hit = nearer(hit, sphere(ray, vec3f(2.0, 4.0, 0.0), 1.0), OBJECT_SPHERE_11);
    // objects[12] "Sphere 12": Sphere(center: (4, 4, 0))
    hit = nearer(hit, sphere(ray, vec3f(4.0, 4.0, 0.0), 1.0), OBJECT_SPHERE_12);
    // objects[13] "Sphere 13": Sphere(center: (6, 4, 0))
    hit = nearer(hit, sphere(ray, vec3f(6.0, 4.0, 0.0), 1.0), OBJECT_SPHERE_13);
    // objects[14] "Sphere 14": Sphere(center: (8, 4, 0))
    hit = nearer(hit, sphere(ray, vec3f(8.0, 4.0, 0.0), 1.0), OBJECT_SPHERE_14);
    // objects[15] "Sphere 15": Sphere(center: (0, 6, 0))
    hit = nearer(hit, sphere(ray, vec3f(0.0, 6.0, 0.0), 1.0), OBJECT_SPHERE_15);
    // objects[16] "Sphere 16": Sphere(center: (2, 6, 0))
    hit = nearer(hit, sphere(ray, vec3f(2.0, 6.0, 0.0), 1.0), OBJECT_SPHERE_16);
    // objects[17] "Sphere 17": Sphere(center: (4, 6, 0))
    hit = nearer(hit, sphere(ray, vec3f(4.0, 6.0, 0.0), 1.0), OBJECT_SPHERE_17);
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
    if sphere(ray, vec3f(2.0, 4.0, 0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(4.0, 4.0, 0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(6.0, 4.0, 0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(8.0, 4.0, 0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(0.0, 6.0, 0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(2.0, 6.0, 0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(4.0, 6.0, 0.0), 1.0) < NO_HIT { return true; }
    return false;
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    var its_surface: Placed;
    switch object {
        case OBJECT_SPHERE_0: {
            its_surface = placed(sphereSurface(p, vec3f(0.0), 1.0), p);
        }
        case OBJECT_SPHERE_1: {
            its_surface = placed(sphereSurface(p, vec3f(2.0, 0.0, 0.0), 1.0), p);
        }
        case OBJECT_SPHERE_2: {
            its_surface = placed(sphereSurface(p, vec3f(4.0, 0.0, 0.0), 1.0), p);
        }
        case OBJECT_SPHERE_3: {
            its_surface = placed(sphereSurface(p, vec3f(6.0, 0.0, 0.0), 1.0), p);
        }
        case OBJECT_SPHERE_4: {
            its_surface = placed(sphereSurface(p, vec3f(8.0, 0.0, 0.0), 1.0), p);
        }
        case OBJECT_SPHERE_5: {
            its_surface = placed(sphereSurface(p, vec3f(0.0, 2.0, 0.0), 1.0), p);
        }
        case OBJECT_SPHERE_6: {
            its_surface = placed(sphereSurface(p, vec3f(2.0, 2.0, 0.0), 1.0), p);
        }
        case OBJECT_SPHERE_7: {
            its_surface = placed(sphereSurface(p, vec3f(4.0, 2.0, 0.0), 1.0), p);
        }
        case OBJECT_SPHERE_8: {
            its_surface = placed(sphereSurface(p, vec3f(6.0, 2.0, 0.0), 1.0), p);
        }
        case OBJECT_SPHERE_9: {
            its_surface = placed(sphereSurface(p, vec3f(8.0, 2.0, 0.0), 1.0), p);
        }
        case OBJECT_SPHERE_10: {
            its_surface = placed(sphereSurface(p, vec3f(0.0, 4.0, 0.0), 1.0), p);
        }
        case OBJECT_SPHERE_11: {
            its_surface = placed(sphereSurface(p, vec3f(2.0, 4.0, 0.0), 1.0), p);
        }
        case OBJECT_SPHERE_12: {
            its_surface = placed(sphereSurface(p, vec3f(4.0, 4.0, 0.0), 1.0), p);
        }
        case OBJECT_SPHERE_13: {
            its_surface = placed(sphereSurface(p, vec3f(6.0, 4.0, 0.0), 1.0), p);
        }
        case OBJECT_SPHERE_14: {
            its_surface = placed(sphereSurface(p, vec3f(8.0, 4.0, 0.0), 1.0), p);
        }
        case OBJECT_SPHERE_15: {
            its_surface = placed(sphereSurface(p, vec3f(0.0, 6.0, 0.0), 1.0), p);
        }
        case OBJECT_SPHERE_16: {
            its_surface = placed(sphereSurface(p, vec3f(2.0, 6.0, 0.0), 1.0), p);
        }
        case OBJECT_SPHERE_17: {
            its_surface = placed(sphereSurface(p, vec3f(4.0, 6.0, 0.0), 1.0), p);
        }
        default: {
            its_surface = placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p);
        }
    }
    return its_surface;
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    var its_material: Material;
    switch object {
        case OBJECT_SPHERE_0: { its_material = sphere0Material(at); }
        case OBJECT_SPHERE_1: { its_material = sphere1Material(at); }
        case OBJECT_SPHERE_2: { its_material = sphere2Material(at); }
        case OBJECT_SPHERE_3: { its_material = sphere3Material(at); }
        case OBJECT_SPHERE_4: { its_material = sphere4Material(at); }
        case OBJECT_SPHERE_5: { its_material = sphere5Material(at); }
        case OBJECT_SPHERE_6: { its_material = sphere6Material(at); }
        case OBJECT_SPHERE_7: { its_material = sphere7Material(at); }
        case OBJECT_SPHERE_8: { its_material = sphere8Material(at); }
        case OBJECT_SPHERE_9: { its_material = sphere9Material(at); }
        case OBJECT_SPHERE_10: { its_material = sphere10Material(at); }
        case OBJECT_SPHERE_11: { its_material = sphere11Material(at); }
        case OBJECT_SPHERE_12: { its_material = sphere12Material(at); }
        case OBJECT_SPHERE_13: { its_material = sphere13Material(at); }
        case OBJECT_SPHERE_14: { its_material = sphere14Material(at); }
        case OBJECT_SPHERE_15: { its_material = sphere15Material(at); }
        case OBJECT_SPHERE_16: { its_material = sphere16Material(at); }
        case OBJECT_SPHERE_17: { its_material = sphere17Material(at); }
        default: { its_material = matte(vec3f(0.0)); }
    }
    return its_material;
}

fn sphere0Material(at: Surface) -> Material {
    return matte(
        add(
            at,
            checker(
                at,
                1.0,
                vec3f(0.838799, 0.791298, 0.6866853),
                vec3f(0.0409152, 0.05448028, 0.07618539),
            ),
            vec3f(noise(at, 1.5)),
        ),
    );
}

fn sphere1Material(at: Surface) -> Material {
    return matte(
        blend(
            at,
            checker(
                at,
                1.0,
                vec3f(0.838799, 0.791298, 0.6866853),
                vec3f(0.0409152, 0.05448028, 0.07618539),
            ),
            vec3f(1.0, 0.6795425, 0.0),
            fbm(at, 1.0, 5u, 2.0, 0.5),
        ),
    );
}

fn sphere2Material(at: Surface) -> Material {
    return matte(
        choose(
            at,
            noise(at, 1.5),
            0.5,
            0.02,
            brick(
                at,
                4.0,
                3.0,
                0u,
                0.1,
                0.15,
                vec3f(0.3712377, 0.084376216, 0.04231141),
                vec3f(0.62396044, 0.57112485, 0.4910209),
            ),
            marble(
                at,
                1.5,
                6u,
                2.0,
                5.0,
                vec3f(0.8879231, 0.8631572, 0.8148466),
                vec3f(0.0703601, 0.08021983, 0.097587354),
            ),
        ),
    );
}

fn sphere3Material(at: Surface) -> Material {
    return matte(contrast(at, vec3f(noise(at, 1.5)), 1.5, 0.25));
}

fn sphere4Material(at: Surface) -> Material {
    return matte(
        difference(
            at,
            checker(
                at,
                1.0,
                vec3f(0.838799, 0.791298, 0.6866853),
                vec3f(0.0409152, 0.05448028, 0.07618539),
            ),
            marble(
                at,
                1.5,
                6u,
                2.0,
                5.0,
                vec3f(0.8879231, 0.8631572, 0.8148466),
                vec3f(0.0703601, 0.08021983, 0.097587354),
            ),
        ),
    );
}

fn sphere5Material(at: Surface) -> Material {
    return matte(gamma(at, vec3f(noise(at, 1.5)), 2.0));
}

fn sphere6Material(at: Surface) -> Material {
    return matte(
        vec3f(
            grey(
                at,
                brick(
                    at,
                    4.0,
                    3.0,
                    0u,
                    0.1,
                    0.15,
                    vec3f(0.3712377, 0.084376216, 0.04231141),
                    vec3f(0.62396044, 0.57112485, 0.4910209),
                ),
            ),
        ),
    );
}

fn sphere7Material(at: Surface) -> Material {
    return matte(
        hue(
            at,
            brick(
                at,
                4.0,
                3.0,
                0u,
                0.1,
                0.15,
                vec3f(0.3712377, 0.084376216, 0.04231141),
                vec3f(0.62396044, 0.57112485, 0.4910209),
            ),
            120.0,
            1.0,
            1.0,
        ),
    );
}

fn sphere8Material(at: Surface) -> Material {
    return matte(
        invert(
            at,
            checker(
                at,
                1.0,
                vec3f(0.838799, 0.791298, 0.6866853),
                vec3f(0.0409152, 0.05448028, 0.07618539),
            ),
        ),
    );
}

fn sphere9Material(at: Surface) -> Material {
    return matte(
        maximum(
            at,
            checker(
                at,
                1.0,
                vec3f(0.838799, 0.791298, 0.6866853),
                vec3f(0.0409152, 0.05448028, 0.07618539),
            ),
            vec3f(noise(at, 1.5)),
        ),
    );
}

fn sphere10Material(at: Surface) -> Material {
    return matte(
        minimum(
            at,
            checker(
                at,
                1.0,
                vec3f(0.838799, 0.791298, 0.6866853),
                vec3f(0.0409152, 0.05448028, 0.07618539),
            ),
            vec3f(noise(at, 1.5)),
        ),
    );
}

fn sphere11Material(at: Surface) -> Material {
    return matte(
        multiply(
            at,
            checker(
                at,
                1.0,
                vec3f(0.838799, 0.791298, 0.6866853),
                vec3f(0.0409152, 0.05448028, 0.07618539),
            ),
            vec3f(noise(at, 1.5)),
        ),
    );
}

fn sphere12Material(at: Surface) -> Material {
    return matte(
        overlay(
            at,
            marble(
                at,
                1.5,
                6u,
                2.0,
                5.0,
                vec3f(0.8879231, 0.8631572, 0.8148466),
                vec3f(0.0703601, 0.08021983, 0.097587354),
            ),
            vec3f(noise(at, 1.5)),
        ),
    );
}

fn sphere13Material(at: Surface) -> Material {
    return matte(quantize(at, vec3f(noise(at, 1.5)), 4u));
}

fn sphere14Material(at: Surface) -> Material {
    return matte(vec3f(remap(at, noise(at, 1.5), 0.0, 1.0, 0.2, 0.9, true)));
}

fn sphere15Material(at: Surface) -> Material {
    return matte(
        screen(
            at,
            checker(
                at,
                1.0,
                vec3f(0.838799, 0.791298, 0.6866853),
                vec3f(0.0409152, 0.05448028, 0.07618539),
            ),
            vec3f(noise(at, 1.5)),
        ),
    );
}

fn sphere16Material(at: Surface) -> Material {
    return matte(vec3f(softStep(at, noise(at, 1.5), 0.3, 0.7)));
}

fn sphere17Material(at: Surface) -> Material {
    return matte(vec3f(threshold(at, noise(at, 1.5), 0.5, 0.02)));
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
