// Generated from scenes/table.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   floor, red, green, magenta, floating, top, leg 1, leg 2, leg 3, leg 4
//   shapes    Plane, Sphere, Box
//   textures  Checker

const OBJECT_FLOOR: u32 = 0u;
const OBJECT_RED: u32 = 1u;
const OBJECT_GREEN: u32 = 2u;
const OBJECT_MAGENTA: u32 = 3u;
const OBJECT_FLOATING: u32 = 4u;
const OBJECT_TOP: u32 = 5u;
const OBJECT_LEG_1: u32 = 6u;
const OBJECT_LEG_2: u32 = 7u;
const OBJECT_LEG_3: u32 = 8u;
const OBJECT_LEG_4: u32 = 9u;
const LIGHTS: u32 = 1u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, floorCrossing(ray), OBJECT_FLOOR);
    hit = nearer(hit, redCrossing(ray), OBJECT_RED);
    hit = nearer(hit, greenCrossing(ray), OBJECT_GREEN);
    hit = nearer(hit, magentaCrossing(ray), OBJECT_MAGENTA);
    hit = nearer(hit, floatingCrossing(ray), OBJECT_FLOATING);
    hit = nearer(hit, topCrossing(ray), OBJECT_TOP);
    hit = nearer(hit, leg1Crossing(ray), OBJECT_LEG_1);
    hit = nearer(hit, leg2Crossing(ray), OBJECT_LEG_2);
    hit = nearer(hit, leg3Crossing(ray), OBJECT_LEG_3);
    hit = nearer(hit, leg4Crossing(ray), OBJECT_LEG_4);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if floorCrossing(ray) < NO_HIT { return true; }
    if redCrossing(ray) < NO_HIT { return true; }
    if greenCrossing(ray) < NO_HIT { return true; }
    if magentaCrossing(ray) < NO_HIT { return true; }
    if floatingCrossing(ray) < NO_HIT { return true; }
    if topCrossing(ray) < NO_HIT { return true; }
    if leg1Crossing(ray) < NO_HIT { return true; }
    if leg2Crossing(ray) < NO_HIT { return true; }
    if leg3Crossing(ray) < NO_HIT { return true; }
    if leg4Crossing(ray) < NO_HIT { return true; }
    return false;
}

/// objects[0] "floor": Plane(normal: (0, 1, 0), offset: 0)
fn floorCrossing(ray: Ray) -> f32 {
    return plane(ray, vec3f(0.0, 1.0, 0.0), 0.0);
}

fn floorSurfaceAt(p: vec3f) -> Surface {
    return planeSurface(p, vec3f(0.0, 1.0, 0.0), 0.0);
}

/// objects[1] "red": Sphere(center: (1, 2, 5), radius: 2)
fn redCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(1.0, 2.0, 5.0), 2.0);
}

fn redSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(1.0, 2.0, 5.0), 2.0);
}

/// objects[2] "green": Sphere(center: (5, 1, 2), radius: 1)
fn greenCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(5.0, 1.0, 2.0), 1.0);
}

fn greenSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(5.0, 1.0, 2.0), 1.0);
}

/// objects[3] "magenta": Sphere(center: (5, 2.8, 1), radius: 0.6)
fn magentaCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(5.0, 2.8, 1.0), 0.6);
}

fn magentaSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(5.0, 2.8, 1.0), 0.6);
}

/// objects[4] "floating": Box(min: (0, 3, 0), max: (1, 4, 1))
fn floatingCrossing(ray: Ray) -> f32 {
    return box(ray, vec3f(0.0, 3.0, 0.0), vec3f(1.0, 4.0, 1.0));
}

fn floatingSurfaceAt(p: vec3f) -> Surface {
    return boxSurface(p, vec3f(0.0, 3.0, 0.0), vec3f(1.0, 4.0, 1.0));
}

/// objects[5] "top": Box(min: (-2, 1.65, -2), max: (2, 1.8, 2))
fn topCrossing(ray: Ray) -> f32 {
    return box(ray, vec3f(-2.0, 1.65, -2.0), vec3f(2.0, 1.8, 2.0));
}

fn topSurfaceAt(p: vec3f) -> Surface {
    return boxSurface(p, vec3f(-2.0, 1.65, -2.0), vec3f(2.0, 1.8, 2.0));
}

/// objects[6] "leg 1": Box(min: (-1.9, 0, -1.9), max: (-1.6, 1.65, -1.6))
fn leg1Crossing(ray: Ray) -> f32 {
    return box(ray, vec3f(-1.9, 0.0, -1.9), vec3f(-1.6, 1.65, -1.6));
}

fn leg1SurfaceAt(p: vec3f) -> Surface {
    return boxSurface(p, vec3f(-1.9, 0.0, -1.9), vec3f(-1.6, 1.65, -1.6));
}

/// objects[7] "leg 2": Box(min: (-1.9, 0, 1.6), max: (-1.6, 1.65, 1.9))
fn leg2Crossing(ray: Ray) -> f32 {
    return box(ray, vec3f(-1.9, 0.0, 1.6), vec3f(-1.6, 1.65, 1.9));
}

fn leg2SurfaceAt(p: vec3f) -> Surface {
    return boxSurface(p, vec3f(-1.9, 0.0, 1.6), vec3f(-1.6, 1.65, 1.9));
}

/// objects[8] "leg 3": Box(min: (1.6, 0, 1.6), max: (1.9, 1.65, 1.9))
fn leg3Crossing(ray: Ray) -> f32 {
    return box(ray, vec3f(1.6, 0.0, 1.6), vec3f(1.9, 1.65, 1.9));
}

fn leg3SurfaceAt(p: vec3f) -> Surface {
    return boxSurface(p, vec3f(1.6, 0.0, 1.6), vec3f(1.9, 1.65, 1.9));
}

/// objects[9] "leg 4": Box(min: (1.6, 0, -1.9), max: (1.9, 1.65, -1.6))
fn leg4Crossing(ray: Ray) -> f32 {
    return box(ray, vec3f(1.6, 0.0, -1.9), vec3f(1.9, 1.65, -1.6));
}

fn leg4SurfaceAt(p: vec3f) -> Surface {
    return boxSurface(p, vec3f(1.6, 0.0, -1.9), vec3f(1.9, 1.65, -1.6));
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_FLOOR: { return placed(floorSurfaceAt(p), p); }
        case OBJECT_RED: { return placed(redSurfaceAt(p), p); }
        case OBJECT_GREEN: { return placed(greenSurfaceAt(p), p); }
        case OBJECT_MAGENTA: { return placed(magentaSurfaceAt(p), p); }
        case OBJECT_FLOATING: { return placed(floatingSurfaceAt(p), p); }
        case OBJECT_TOP: { return placed(topSurfaceAt(p), p); }
        case OBJECT_LEG_1: { return placed(leg1SurfaceAt(p), p); }
        case OBJECT_LEG_2: { return placed(leg2SurfaceAt(p), p); }
        case OBJECT_LEG_3: { return placed(leg3SurfaceAt(p), p); }
        case OBJECT_LEG_4: { return placed(leg4SurfaceAt(p), p); }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_TOP, OBJECT_LEG_1, OBJECT_LEG_2, OBJECT_LEG_3, OBJECT_LEG_4: {
            return woodMaterial(at);
        }
        case OBJECT_FLOOR: { return floorMaterial(at); }
        case OBJECT_RED: { return redMaterial(at); }
        case OBJECT_GREEN: { return greenMaterial(at); }
        case OBJECT_MAGENTA: { return magentaMaterial(at); }
        case OBJECT_FLOATING: { return floatingMaterial(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "wood": (color: (0.0, 0.0, 1.0), specular: 1.0, shininess: 50, reflectivity: 0.0, fres…
fn woodMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.0, 0.0, 1.0));
    material.specular = 1.0;
    material.shininess = 50.0;
    material.reflectivity = 0.0;
    material.fresnel = 2.0;
    return material;
}

/// material "floor": (color: "tiles", specular: 1, reflectivity: 0, fresnel: 2)
fn floorMaterial(at: Surface) -> Material {
    var material = matte(tilesTexture(at));
    material.specular = 1.0;
    material.reflectivity = 0.0;
    material.fresnel = 2.0;
    return material;
}

/// material "red": (color: (1, 0, 0), specular: 1, reflectivity: 0, fresnel: 2)
fn redMaterial(at: Surface) -> Material {
    var material = matte(vec3f(1.0, 0.0, 0.0));
    material.specular = 1.0;
    material.reflectivity = 0.0;
    material.fresnel = 2.0;
    return material;
}

/// material "green": (color: (0, 1, 0), specular: 1, reflectivity: 0, fresnel: 2)
fn greenMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.0, 1.0, 0.0));
    material.specular = 1.0;
    material.reflectivity = 0.0;
    material.fresnel = 2.0;
    return material;
}

/// material "magenta": (color: (1, 0, 1), specular: 1, reflectivity: 0, fresnel: 2)
fn magentaMaterial(at: Surface) -> Material {
    var material = matte(vec3f(1.0, 0.0, 1.0));
    material.specular = 1.0;
    material.reflectivity = 0.0;
    material.fresnel = 2.0;
    return material;
}

/// material "floating": (color: (1, 1, 0), specular: 1, reflectivity: 0, fresnel: 2)
fn floatingMaterial(at: Surface) -> Material {
    var material = matte(vec3f(1.0, 1.0, 0.0));
    material.specular = 1.0;
    material.reflectivity = 0.0;
    material.fresnel = 2.0;
    return material;
}

/// Whether the material of `object` varies over its surface.
fn isTextured(object: u32) -> bool {
    switch object {
        case OBJECT_FLOOR: { return true; }
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
    return vec3f(0.3);
}

/// texture "tiles": Checker(scale: 1, even: 0.15, odd: 0.65)
fn tilesTexture(at: Surface) -> vec3f {
    return checker(at, 1.0, vec3f(0.15), vec3f(0.65));
}

/// The light `index` as the world point `p` sees it.
fn lightAt(index: u32, p: vec3f) -> Light {
    switch index {
        // lights[0]: Point(position: (6, 9, 7))
        case 0u: { return pointLight(p, vec3f(6.0, 9.0, 7.0), 0.0, vec3f(1.0)); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
