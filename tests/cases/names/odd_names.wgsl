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
    hit = nearer(hit, leg1Crossing(ray), OBJECT_LEG_1);
    hit = nearer(hit, leg1Crossing2(ray), OBJECT_LEG_1_2);
    hit = nearer(hit, leg12Crossing(ray), OBJECT_LEG_1_2_2);
    hit = nearer(hit, ballonDTCrossing(ray), OBJECT_BALLON_D_T);
    hit = nearer(hit, xCrossing(ray), OBJECT_X);
    hit = nearer(hit, x2LegsCrossing(ray), OBJECT_2_LEGS);
    hit = nearer(hit, fnCrossing(ray), OBJECT_FN);
    hit = nearer(hit, twoLinesQuotedAndACommenCrossing(ray), OBJECT_TWO_LINES_QUOTED_AND_A_C);
    hit = nearer(hit, lineSeparatorCrossing(ray), OBJECT_LINE_SEPARATOR);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if leg1Crossing(ray) < NO_HIT { return true; }
    if leg1Crossing2(ray) < NO_HIT { return true; }
    if leg12Crossing(ray) < NO_HIT { return true; }
    if ballonDTCrossing(ray) < NO_HIT { return true; }
    if xCrossing(ray) < NO_HIT { return true; }
    if x2LegsCrossing(ray) < NO_HIT { return true; }
    if fnCrossing(ray) < NO_HIT { return true; }
    if twoLinesQuotedAndACommenCrossing(ray) < NO_HIT { return true; }
    if lineSeparatorCrossing(ray) < NO_HIT { return true; }
    return false;
}

/// objects[0] "leg 1": Sphere()
fn leg1Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 1.0);
}

fn leg1SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 1.0);
}

/// objects[1] "leg_1": Sphere()
fn leg1Crossing2(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 1.0);
}

fn leg1SurfaceAt2(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 1.0);
}

/// objects[2] "LEG 1 2": Sphere()
fn leg12Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 1.0);
}

fn leg12SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 1.0);
}

/// objects[3] "ballon d'été 🎈": Sphere()
fn ballonDTCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 1.0);
}

fn ballonDTSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 1.0);
}

/// objects[4] "日本": Sphere()
fn xCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 1.0);
}

fn xSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 1.0);
}

/// objects[5] "2 legs": Sphere()
fn x2LegsCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 1.0);
}

fn x2LegsSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 1.0);
}

/// objects[6] "fn": Sphere()
fn fnCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 1.0);
}

fn fnSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 1.0);
}

/// objects[7] "two lines "quoted" \ // and /* a comment": Sphere()
fn twoLinesQuotedAndACommenCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 1.0);
}

fn twoLinesQuotedAndACommenSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 1.0);
}

/// objects[8] "line separator": Sphere()
fn lineSeparatorCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 1.0);
}

fn lineSeparatorSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 1.0);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_LEG_1: { return placed(leg1SurfaceAt(p), p); }
        case OBJECT_LEG_1_2: { return placed(leg1SurfaceAt2(p), p); }
        case OBJECT_LEG_1_2_2: { return placed(leg12SurfaceAt(p), p); }
        case OBJECT_BALLON_D_T: { return placed(ballonDTSurfaceAt(p), p); }
        case OBJECT_X: { return placed(xSurfaceAt(p), p); }
        case OBJECT_2_LEGS: { return placed(x2LegsSurfaceAt(p), p); }
        case OBJECT_FN: { return placed(fnSurfaceAt(p), p); }
        case OBJECT_TWO_LINES_QUOTED_AND_A_C: {
            return placed(twoLinesQuotedAndACommenSurfaceAt(p), p);
        }
        case OBJECT_LINE_SEPARATOR: { return placed(lineSeparatorSurfaceAt(p), p); }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_LEG_1: { return leg1Material(at); }
        case OBJECT_LEG_1_2: { return leg1Material2(at); }
        case OBJECT_LEG_1_2_2: { return xMaterial(at); }
        case OBJECT_BALLON_D_T,
             OBJECT_X,
             OBJECT_2_LEGS,
             OBJECT_FN,
             OBJECT_TWO_LINES_QUOTED_AND_A_C,
             OBJECT_LINE_SEPARATOR: {
            return defaultMaterial(at);
        }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "leg 1": (color: "leg 1")
fn leg1Material(at: Surface) -> Material {
    return matte(vec3f(leg1Texture(at)));
}

/// material "leg_1": (color: "Leg-1")
fn leg1Material2(at: Surface) -> Material {
    return matte(vec3f(leg1Texture2(at)));
}

/// material "日本": (color: "")
fn xMaterial(at: Surface) -> Material {
    return matte(vec3f(xTexture(at)));
}

/// The material of objects that have none in the scene.
fn defaultMaterial(at: Surface) -> Material {
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

/// texture "leg 1": Noise()
fn leg1Texture(at: Surface) -> f32 {
    return noise(at, 1.5);
}

/// texture "Leg-1": Fbm()
fn leg1Texture2(at: Surface) -> f32 {
    return fbm(at, 1.0, 5u, 2.0, 0.5);
}

/// texture "": Noise(scale: 3)
fn xTexture(at: Surface) -> f32 {
    return noise(at, 3.0);
}

/// The light `index` as the world point `p` sees it.
fn lightAt(index: u32, p: vec3f) -> Light {
    switch index {
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
