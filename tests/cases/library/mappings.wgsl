// Generated from tests/cases/library/mappings.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Sphere 0, Sphere 1, Sphere 2, Sphere 3, Sphere 4, Sphere 5, Sphere 6, Sphere 7,
//             Sphere 8, Sphere 9, Sphere 10, Sphere 11, Sphere 12, Sphere 13, Sphere 14,
//             Sphere 15, Sphere 16, Sphere 17
//   shapes    Sphere
//   textures  Cubic, Checker, Cylindrical, Displace, HexagonalTile, Kaleidoscope, Lens, Mirror,
//             Pixelate, Planar, Polar, Rotate, ScaleBy, Spherical, Symmetry, Tile, Translate,
//             Twist, Wobble

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
    let at1 = cubic(at);
    return matte(
        checker(
            at1,
            1.0,
            vec3f(0.838799, 0.791298, 0.6866853),
            vec3f(0.0409152, 0.05448028, 0.07618539),
        ),
    );
}

fn sphere1Material(at: Surface) -> Material {
    let at1 = cylindrical(at, 6.0);
    return matte(
        checker(
            at1,
            1.0,
            vec3f(0.838799, 0.791298, 0.6866853),
            vec3f(0.0409152, 0.05448028, 0.07618539),
        ),
    );
}

fn sphere2Material(at: Surface) -> Material {
    let at1 = displace(at, vec3f(1.0, 0.5, 0.5), 0.5, vec3f(1.0), 1.0);
    return matte(
        checker(
            at1,
            1.0,
            vec3f(0.838799, 0.791298, 0.6866853),
            vec3f(0.0409152, 0.05448028, 0.07618539),
        ),
    );
}

fn sphere3Material(at: Surface) -> Material {
    let at1 = hexagonalTile(at, 1.5, 120.0);
    return matte(
        checker(
            at1,
            1.0,
            vec3f(0.838799, 0.791298, 0.6866853),
            vec3f(0.0409152, 0.05448028, 0.07618539),
        ),
    );
}

fn sphere4Material(at: Surface) -> Material {
    let at1 = kaleidoscope(at, 6u, 15.0);
    return matte(
        checker(
            at1,
            1.0,
            vec3f(0.838799, 0.791298, 0.6866853),
            vec3f(0.0409152, 0.05448028, 0.07618539),
        ),
    );
}

fn sphere5Material(at: Surface) -> Material {
    let at1 = lens(at, 0.7, vec3f(0.0), 2.5);
    return matte(
        checker(
            at1,
            1.0,
            vec3f(0.838799, 0.791298, 0.6866853),
            vec3f(0.0409152, 0.05448028, 0.07618539),
        ),
    );
}

fn sphere6Material(at: Surface) -> Material {
    let at1 = mirror(at, vec3f(2.5));
    return matte(
        checker(
            at1,
            1.0,
            vec3f(0.838799, 0.791298, 0.6866853),
            vec3f(0.0409152, 0.05448028, 0.07618539),
        ),
    );
}

fn sphere7Material(at: Surface) -> Material {
    let at1 = pixelate(at, 0.1);
    return matte(
        checker(
            at1,
            1.0,
            vec3f(0.838799, 0.791298, 0.6866853),
            vec3f(0.0409152, 0.05448028, 0.07618539),
        ),
    );
}

fn sphere8Material(at: Surface) -> Material {
    let at1 = planar(at, 1u);
    return matte(
        checker(
            at1,
            1.0,
            vec3f(0.838799, 0.791298, 0.6866853),
            vec3f(0.0409152, 0.05448028, 0.07618539),
        ),
    );
}

fn sphere9Material(at: Surface) -> Material {
    let at1 = polar(at, 12.0);
    return matte(
        checker(
            at1,
            1.0,
            vec3f(0.838799, 0.791298, 0.6866853),
            vec3f(0.0409152, 0.05448028, 0.07618539),
        ),
    );
}

fn sphere10Material(at: Surface) -> Material {
    let at1 = rotate(at, vec3f(0.0, 30.0, 0.0));
    return matte(
        checker(
            at1,
            1.0,
            vec3f(0.838799, 0.791298, 0.6866853),
            vec3f(0.0409152, 0.05448028, 0.07618539),
        ),
    );
}

fn sphere11Material(at: Surface) -> Material {
    let at1 = scaleBy(at, vec3f(2.0));
    return matte(
        checker(
            at1,
            1.0,
            vec3f(0.838799, 0.791298, 0.6866853),
            vec3f(0.0409152, 0.05448028, 0.07618539),
        ),
    );
}

fn sphere12Material(at: Surface) -> Material {
    let at1 = spherical(at, vec3f(0.0), 12.0);
    return matte(
        checker(
            at1,
            1.0,
            vec3f(0.838799, 0.791298, 0.6866853),
            vec3f(0.0409152, 0.05448028, 0.07618539),
        ),
    );
}

fn sphere13Material(at: Surface) -> Material {
    let at1 = symmetry(at, true, false, false);
    return matte(
        checker(
            at1,
            1.0,
            vec3f(0.838799, 0.791298, 0.6866853),
            vec3f(0.0409152, 0.05448028, 0.07618539),
        ),
    );
}

fn sphere14Material(at: Surface) -> Material {
    let at1 = tile(at, vec3f(2.5));
    return matte(
        checker(
            at1,
            1.0,
            vec3f(0.838799, 0.791298, 0.6866853),
            vec3f(0.0409152, 0.05448028, 0.07618539),
        ),
    );
}

fn sphere15Material(at: Surface) -> Material {
    let at1 = translate(at, vec3f(0.5, 0.25, 0.0));
    return matte(
        checker(
            at1,
            1.0,
            vec3f(0.838799, 0.791298, 0.6866853),
            vec3f(0.0409152, 0.05448028, 0.07618539),
        ),
    );
}

fn sphere16Material(at: Surface) -> Material {
    let at1 = twist(at, 60.0);
    return matte(
        checker(
            at1,
            1.0,
            vec3f(0.838799, 0.791298, 0.6866853),
            vec3f(0.0409152, 0.05448028, 0.07618539),
        ),
    );
}

fn sphere17Material(at: Surface) -> Material {
    let at1 = wobble(at, 0.15, 1.5);
    return matte(
        checker(
            at1,
            1.0,
            vec3f(0.838799, 0.791298, 0.6866853),
            vec3f(0.0409152, 0.05448028, 0.07618539),
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
