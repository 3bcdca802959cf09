// Generated from tests/cases/names/odd_names.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   leg 1, leg_1, LEG 1 2, ballon d'été 🎈, 日本, 2 legs, fn,
//             two lines "quoted" \ // and /* a comment, line separator
//   shapes    Sphere
//   textures  Noise, Fbm

const OBJECT_LEG_1: u32 = 0u;
const OBJECT_LEG_1_2: u32 = 1u;
const OBJECT_LEG_1_2_2: u32 = 2u;
const OBJECT_BALLON_D_T: u32 = 3u;
const OBJECT_X: u32 = 4u;
const OBJECT_2_LEGS: u32 = 5u;
const OBJECT_FN: u32 = 6u;
const OBJECT_TWO_LINES_QUOTED_AND_A_C: u32 = 7u;
const OBJECT_LINE_SEPARATOR: u32 = 8u;
const LIGHTS: u32 = 0u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    // objects[0] "leg 1": Sphere()
    hit = nearer(hit, sphere(ray, vec3f(0.0), 1.0), OBJECT_LEG_1);
    // objects[1] "leg_1": Sphere()
    hit = nearer(hit, sphere(ray, vec3f(0.0), 1.0), OBJECT_LEG_1_2);
    // objects[2] "LEG 1 2": Sphere()
    hit = nearer(hit, sphere(ray, vec3f(0.0), 1.0), OBJECT_LEG_1_2_2);
    // objects[3] "ballon d'été 🎈": Sphere()
    hit = nearer(hit, sphere(ray, vec3f(0.0), 1.0), OBJECT_BALLON_D_T);
    // objects[4] "日本": Sphere()
    hit = nearer(hit, sphere(ray, vec3f(0.0), 1.0), OBJECT_X);
    // objects[5] "2 legs": Sphere()
    hit = nearer(hit, sphere(ray, vec3f(0.0), 1.0), OBJECT_2_LEGS);
    // objects[6] "fn": Sphere()
    hit = nearer(hit, sphere(ray, vec3f(0.0), 1.0), OBJECT_FN);
    // objects[7] "two lines "quoted" \ // and /* a comment": Sphere()
    hit = nearer(hit, sphere(ray, vec3f(0.0), 1.0), OBJECT_TWO_LINES_QUOTED_AND_A_C);
    // objects[8] "line separator": Sphere()
    hit = nearer(hit, sphere(ray, vec3f(0.0), 1.0), OBJECT_LINE_SEPARATOR);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if sphere(ray, vec3f(0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(0.0), 1.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(0.0), 1.0) < NO_HIT { return true; }
    return false;
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_LEG_1: {
            return placed(sphereSurface(p, vec3f(0.0), 1.0), p);
        }
        case OBJECT_LEG_1_2: {
            return placed(sphereSurface(p, vec3f(0.0), 1.0), p);
        }
        case OBJECT_LEG_1_2_2: {
            return placed(sphereSurface(p, vec3f(0.0), 1.0), p);
        }
        case OBJECT_BALLON_D_T: {
            return placed(sphereSurface(p, vec3f(0.0), 1.0), p);
        }
        case OBJECT_X: {
            return placed(sphereSurface(p, vec3f(0.0), 1.0), p);
        }
        case OBJECT_2_LEGS: {
            return placed(sphereSurface(p, vec3f(0.0), 1.0), p);
        }
        case OBJECT_FN: {
            return placed(sphereSurface(p, vec3f(0.0), 1.0), p);
        }
        case OBJECT_TWO_LINES_QUOTED_AND_A_C: {
            return placed(sphereSurface(p, vec3f(0.0), 1.0), p);
        }
        case OBJECT_LINE_SEPARATOR: {
            return placed(sphereSurface(p, vec3f(0.0), 1.0), p);
        }
        default: {
            return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p);
        }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_LEG_1: { return leg1Material(at); }
        case OBJECT_LEG_1_2: { return leg1Material2(at); }
        case OBJECT_LEG_1_2_2: { return xMaterial(at); }
        case OBJECT_BALLON_D_T: { return ballonDTMaterial(at); }
        case OBJECT_X: { return xMaterial2(at); }
        case OBJECT_2_LEGS: { return x2LegsMaterial(at); }
        case OBJECT_FN: { return fnMaterial(at); }
        case OBJECT_TWO_LINES_QUOTED_AND_A_C: { return twoLinesQuotedAndACommenMaterial(at); }
        case OBJECT_LINE_SEPARATOR: { return lineSeparatorMaterial(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

fn leg1Material(at: Surface) -> Material {
    return matte(vec3f(leg1Texture(at)));
}

fn leg1Material2(at: Surface) -> Material {
    return matte(vec3f(leg1Texture2(at)));
}

fn xMaterial(at: Surface) -> Material {
    return matte(vec3f(xTexture(at)));
}

fn ballonDTMaterial(at: Surface) -> Material {
    return matte(vec3f(0.8));
}

fn xMaterial2(at: Surface) -> Material {
    return matte(vec3f(0.8));
}

fn x2LegsMaterial(at: Surface) -> Material {
    return matte(vec3f(0.8));
}

fn fnMaterial(at: Surface) -> Material {
    return matte(vec3f(0.8));
}

fn twoLinesQuotedAndACommenMaterial(at: Surface) -> Material {
    return matte(vec3f(0.8));
}

fn lineSeparatorMaterial(at: Surface) -> Material {
    return matte(vec3f(0.8));
}

/// Whether the material of `object` varies over its surface.
fn isTextured(object: u32) -> bool {
    switch object {
        case OBJECT_LEG_1, OBJECT_LEG_1_2, OBJECT_LEG_1_2_2: { return true; }
        default: { return false; }
    }
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

/// textures: "leg 1"
fn leg1Texture(at: Surface) -> f32 {
    return noise(at, 1.5);
}

/// textures: "Leg-1"
fn leg1Texture2(at: Surface) -> f32 {
    return fbm(at, 1.0, 5u, 2.0, 0.5);
}

/// textures: ""
fn xTexture(at: Surface) -> f32 {
    return noise(at, 3.0);
}

/// The light `index` as the world point `p` sees it.
fn lightAt(index: u32, p: vec3f) -> Light {
    switch index {
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
