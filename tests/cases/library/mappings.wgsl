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
    hit = nearer(hit, sphere13Crossing(ray), OBJECT_SPHERE_13);
    hit = nearer(hit, sphere14Crossing(ray), OBJECT_SPHERE_14);
    hit = nearer(hit, sphere15Crossing(ray), OBJECT_SPHERE_15);
    hit = nearer(hit, sphere16Crossing(ray), OBJECT_SPHERE_16);
    hit = nearer(hit, sphere17Crossing(ray), OBJECT_SPHERE_17);
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
    if sphere13Crossing(ray) < NO_HIT { return true; }
    if sphere14Crossing(ray) < NO_HIT { return true; }
    if sphere15Crossing(ray) < NO_HIT { return true; }
    if sphere16Crossing(ray) < NO_HIT { return true; }
    if sphere17Crossing(ray) < NO_HIT { return true; }
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

/// objects[13] "Sphere 13": Sphere(center: (6, 4, 0))
fn sphere13Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(6.0, 4.0, 0.0), 1.0);
}

fn sphere13SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(6.0, 4.0, 0.0), 1.0);
}

/// objects[14] "Sphere 14": Sphere(center: (8, 4, 0))
fn sphere14Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(8.0, 4.0, 0.0), 1.0);
}

fn sphere14SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(8.0, 4.0, 0.0), 1.0);
}

/// objects[15] "Sphere 15": Sphere(center: (0, 6, 0))
fn sphere15Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0, 6.0, 0.0), 1.0);
}

fn sphere15SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0, 6.0, 0.0), 1.0);
}

/// objects[16] "Sphere 16": Sphere(center: (2, 6, 0))
fn sphere16Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(2.0, 6.0, 0.0), 1.0);
}

fn sphere16SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(2.0, 6.0, 0.0), 1.0);
}

/// objects[17] "Sphere 17": Sphere(center: (4, 6, 0))
fn sphere17Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(4.0, 6.0, 0.0), 1.0);
}

fn sphere17SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(4.0, 6.0, 0.0), 1.0);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    var its_surface: Placed;
    switch object {
        case OBJECT_SPHERE_0: { its_surface = placed(sphere0SurfaceAt(p), p); }
        case OBJECT_SPHERE_1: { its_surface = placed(sphere1SurfaceAt(p), p); }
        case OBJECT_SPHERE_2: { its_surface = placed(sphere2SurfaceAt(p), p); }
        case OBJECT_SPHERE_3: { its_surface = placed(sphere3SurfaceAt(p), p); }
        case OBJECT_SPHERE_4: { its_surface = placed(sphere4SurfaceAt(p), p); }
        case OBJECT_SPHERE_5: { its_surface = placed(sphere5SurfaceAt(p), p); }
        case OBJECT_SPHERE_6: { its_surface = placed(sphere6SurfaceAt(p), p); }
        case OBJECT_SPHERE_7: { its_surface = placed(sphere7SurfaceAt(p), p); }
        case OBJECT_SPHERE_8: { its_surface = placed(sphere8SurfaceAt(p), p); }
        case OBJECT_SPHERE_9: { its_surface = placed(sphere9SurfaceAt(p), p); }
        case OBJECT_SPHERE_10: { its_surface = placed(sphere10SurfaceAt(p), p); }
        case OBJECT_SPHERE_11: { its_surface = placed(sphere11SurfaceAt(p), p); }
        case OBJECT_SPHERE_12: { its_surface = placed(sphere12SurfaceAt(p), p); }
        case OBJECT_SPHERE_13: { its_surface = placed(sphere13SurfaceAt(p), p); }
        case OBJECT_SPHERE_14: { its_surface = placed(sphere14SurfaceAt(p), p); }
        case OBJECT_SPHERE_15: { its_surface = placed(sphere15SurfaceAt(p), p); }
        case OBJECT_SPHERE_16: { its_surface = placed(sphere16SurfaceAt(p), p); }
        case OBJECT_SPHERE_17: { its_surface = placed(sphere17SurfaceAt(p), p); }
        default: { its_surface = placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
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

/// material "Sphere 0": (color: Checker(at: Cubic()))
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

/// material "Sphere 1": (color: Checker(at: Cylindrical()))
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

/// material "Sphere 2": (color: Checker(at: Displace()))
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

/// material "Sphere 3": (color: Checker(at: HexagonalTile()))
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

/// material "Sphere 4": (color: Checker(at: Kaleidoscope()))
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

/// material "Sphere 5": (color: Checker(at: Lens()))
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

/// material "Sphere 6": (color: Checker(at: Mirror()))
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

/// material "Sphere 7": (color: Checker(at: Pixelate()))
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

/// material "Sphere 8": (color: Checker(at: Planar()))
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

/// material "Sphere 9": (color: Checker(at: Polar()))
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

/// material "Sphere 10": (color: Checker(at: Rotate()))
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

/// material "Sphere 11": (color: Checker(at: ScaleBy()))
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

/// material "Sphere 12": (color: Checker(at: Spherical()))
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

/// material "Sphere 13": (color: Checker(at: Symmetry()))
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

/// material "Sphere 14": (color: Checker(at: Tile()))
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

/// material "Sphere 15": (color: Checker(at: Translate()))
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

/// material "Sphere 16": (color: Checker(at: Twist()))
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

/// material "Sphere 17": (color: Checker(at: Wobble()))
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
