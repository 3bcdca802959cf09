// Generated from tests/cases/materials/css_colors_mean_one_color.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   a, b, c, d, e, f, g, h
//   shapes    Sphere

const OBJECT_A: u32 = 0u;
const OBJECT_B: u32 = 1u;
const OBJECT_C: u32 = 2u;
const OBJECT_D: u32 = 3u;
const OBJECT_E: u32 = 4u;
const OBJECT_F: u32 = 5u;
const OBJECT_G: u32 = 6u;
const OBJECT_H: u32 = 7u;
const LIGHTS: u32 = 0u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, aCrossing(ray), OBJECT_A);
    hit = nearer(hit, bCrossing(ray), OBJECT_B);
    hit = nearer(hit, cCrossing(ray), OBJECT_C);
    hit = nearer(hit, dCrossing(ray), OBJECT_D);
    hit = nearer(hit, eCrossing(ray), OBJECT_E);
    hit = nearer(hit, fCrossing(ray), OBJECT_F);
    hit = nearer(hit, gCrossing(ray), OBJECT_G);
    hit = nearer(hit, hCrossing(ray), OBJECT_H);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if aCrossing(ray) < NO_HIT { return true; }
    if bCrossing(ray) < NO_HIT { return true; }
    if cCrossing(ray) < NO_HIT { return true; }
    if dCrossing(ray) < NO_HIT { return true; }
    if eCrossing(ray) < NO_HIT { return true; }
    if fCrossing(ray) < NO_HIT { return true; }
    if gCrossing(ray) < NO_HIT { return true; }
    if hCrossing(ray) < NO_HIT { return true; }
    return false;
}

/// objects[0] "a": Sphere()
fn aCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 1.0);
}

fn aSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 1.0);
}

/// objects[1] "b": Sphere()
fn bCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 1.0);
}

fn bSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 1.0);
}

/// objects[2] "c": Sphere()
fn cCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 1.0);
}

fn cSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 1.0);
}

/// objects[3] "d": Sphere()
fn dCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 1.0);
}

fn dSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 1.0);
}

/// objects[4] "e": Sphere()
fn eCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 1.0);
}

fn eSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 1.0);
}

/// objects[5] "f": Sphere()
fn fCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 1.0);
}

fn fSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 1.0);
}

/// objects[6] "g": Sphere()
fn gCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 1.0);
}

fn gSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 1.0);
}

/// objects[7] "h": Sphere()
fn hCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 1.0);
}

fn hSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 1.0);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_A: { return placed(aSurfaceAt(p), p); }
        case OBJECT_B: { return placed(bSurfaceAt(p), p); }
        case OBJECT_C: { return placed(cSurfaceAt(p), p); }
        case OBJECT_D: { return placed(dSurfaceAt(p), p); }
        case OBJECT_E: { return placed(eSurfaceAt(p), p); }
        case OBJECT_F: { return placed(fSurfaceAt(p), p); }
        case OBJECT_G: { return placed(gSurfaceAt(p), p); }
        case OBJECT_H: { return placed(hSurfaceAt(p), p); }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_A: { return aMaterial(at); }
        case OBJECT_B: { return bMaterial(at); }
        case OBJECT_C: { return cMaterial(at); }
        case OBJECT_D: { return dMaterial(at); }
        case OBJECT_E: { return eMaterial(at); }
        case OBJECT_F: { return fMaterial(at); }
        case OBJECT_G: { return gMaterial(at); }
        case OBJECT_H: { return hMaterial(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "a": (color: "#ff8800")
fn aMaterial(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.24620135, 0.0));
}

/// material "b": (color: "#f80")
fn bMaterial(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.24620135, 0.0));
}

/// material "c": (color: "rgb(255, 136, 0)")
fn cMaterial(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.24620135, 0.0));
}

/// material "d": (color: "rgb(255 136 0)")
fn dMaterial(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.24620135, 0.0));
}

/// material "e": (color: "rgba(100%, 53.33333333%, 0%, 1)")
fn eMaterial(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.24620129, 0.0));
}

/// material "f": (color: "hsl(32 100% 50%)")
fn fMaterial(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.24620129, 0.0));
}

/// material "g": (color: "hsla(32deg, 100%, 50%, 100%)")
fn gMaterial(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.24620129, 0.0));
}

/// material "h": (color: "hwb(32 0% 0%)")
fn hMaterial(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.24620129, 0.0));
}

/// Whether the material of `object` varies over its surface.
fn isTextured(object: u32) -> bool {
    return false;
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
