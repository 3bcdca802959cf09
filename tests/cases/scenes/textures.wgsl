// Generated from scenes/textures.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   floor, Sphere 1, Sphere 2, Sphere 3
//   shapes    Plane, Sphere
//   textures  Checker, Noise, Stripes, Brick, Turbulence, Marble, Gradient, Fbm

const OBJECT_FLOOR: u32 = 0u;
const OBJECT_SPHERE_1: u32 = 1u;
const OBJECT_SPHERE_2: u32 = 2u;
const OBJECT_SPHERE_3: u32 = 3u;
const LIGHTS: u32 = 1u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, floorCrossing(ray), OBJECT_FLOOR);
    hit = nearer(hit, sphere1Crossing(ray), OBJECT_SPHERE_1);
    hit = nearer(hit, sphere2Crossing(ray), OBJECT_SPHERE_2);
    hit = nearer(hit, sphere3Crossing(ray), OBJECT_SPHERE_3);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if floorCrossing(ray) < NO_HIT { return true; }
    if sphere1Crossing(ray) < NO_HIT { return true; }
    if sphere2Crossing(ray) < NO_HIT { return true; }
    if sphere3Crossing(ray) < NO_HIT { return true; }
    return false;
}

/// objects[0] "floor": Plane()
fn floorCrossing(ray: Ray) -> f32 {
    return plane(ray, vec3f(0.0, 1.0, 0.0), 0.0);
}

fn floorSurfaceAt(p: vec3f) -> Surface {
    return planeSurface(p, vec3f(0.0, 1.0, 0.0), 0.0);
}

/// objects[1] "Sphere 1": Sphere(center: (-2.6, 1, 0))
fn sphere1Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(-2.6, 1.0, 0.0), 1.0);
}

fn sphere1SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(-2.6, 1.0, 0.0), 1.0);
}

/// objects[2] "Sphere 2": Sphere(center: (0, 1, 0))
fn sphere2Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0, 1.0, 0.0), 1.0);
}

fn sphere2SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0, 1.0, 0.0), 1.0);
}

/// objects[3] "Sphere 3": Sphere(center: (2.6, 1, 0))
fn sphere3Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(2.6, 1.0, 0.0), 1.0);
}

fn sphere3SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(2.6, 1.0, 0.0), 1.0);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_FLOOR: { return placed(floorSurfaceAt(p), p); }
        case OBJECT_SPHERE_1: { return placed(sphere1SurfaceAt(p), p); }
        case OBJECT_SPHERE_2: { return placed(sphere2SurfaceAt(p), p); }
        case OBJECT_SPHERE_3: { return placed(sphere3SurfaceAt(p), p); }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_FLOOR: { return floorMaterial(at); }
        case OBJECT_SPHERE_1: { return sphere1Material(at); }
        case OBJECT_SPHERE_2: { return sphere2Material(at); }
        case OBJECT_SPHERE_3: { return sphere3Material(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "floor": (color: Checker(scale: 1, even: Noise(scale: 6), odd: Stripes(scale: 4, even:…
fn floorMaterial(at: Surface) -> Material {
    return matte(
        checker(
            at,
            1.0,
            vec3f(noise(at, 6.0)),
            stripes(
                at,
                4.0,
                vec3f(0.015996294, 0.033104766, 0.057805438),
                vec3f(0.13286832, 0.18447499, 0.24620135),
            ),
        ),
    );
}

/// material "Sphere 1": (color: "veins", specular: 0.4)
fn sphere1Material(at: Surface) -> Material {
    var material = matte(veinsTexture(at));
    material.specular = 0.4;
    return material;
}

/// material "Sphere 2": (color: Brick(scale: 3, joint: Noise(scale: 20)), bump: (height: Brick(sca…
fn sphere2Material(at: Surface) -> Material {
    return matte(
        brick(
            at,
            3.0,
            3.0,
            0u,
            0.1,
            0.15,
            vec3f(0.3712377, 0.084376216, 0.04231141),
            vec3f(noise(at, 20.0)),
        ),
    );
}

/// material "Sphere 3": (color: Marble(scale: 2, at: Turbulence(amount: 0.4, scale: 2)), specular:…
fn sphere3Material(at: Surface) -> Material {
    let at1 = turbulence(at, 0.4, 2.0, 4u);
    var material = matte(
        marble(
            at1,
            2.0,
            6u,
            2.0,
            5.0,
            vec3f(0.8879231, 0.8631572, 0.8148466),
            vec3f(0.0703601, 0.08021983, 0.097587354),
        ),
    );
    material.specular = 0.6;
    material.shininess = 120.0;
    return material;
}

/// Whether the material of `object` varies over its surface.
fn isTextured(object: u32) -> bool {
    return true;
}

/// The world normal of `object` at `met`.
fn normalAt(object: u32, met: Placed) -> vec3f {
    switch object {
        case OBJECT_SPHERE_2: { return bumpedNormal(object, met); }
        default: { return met.normal; }
    }
}

/// The height of `object` over its surface at `at`, scene units.
fn heightAt(object: u32, at: Surface) -> f32 {
    switch object {
        case OBJECT_SPHERE_2: {
            let height = luminance(brick(at, 3.0, 3.0, 0u, 0.1, 0.15, vec3f(1.0), vec3f(0.0)));
            return height * 0.05;
        }
        default: { return 0.0; }
    }
}

/// What a ray sees that leaves the scene in `direction`.
fn background(direction: vec3f) -> vec3f {
    let at = skyPoint(direction);
    return gradient(
        at,
        vec3f(0.035601314, 0.08021983, 0.19461784),
        vec3f(0.8069523, 0.8549926, 0.91309863),
    );
}

fn ambientLight() -> vec3f {
    return vec3f(0.2);
}

/// texture "veins": Ramp(by: Fbm(octaves: 5, scale: 2), stops: [(0.0, "#2b2118"), (0.45, "#8a6a4a"…
fn veinsTexture(at: Surface) -> vec3f {
    let by1 = fbm(at, 2.0, 5u, 2.0, 0.5);
    var ramp2 = vec3f(0.024157634, 0.015208516, 0.009134059);
    ramp2 = mix(ramp2, vec3f(0.25415212, 0.14412847, 0.068478175), rampStep(0.0, 0.45, by1));
    ramp2 = mix(ramp2, vec3f(0.8631572, 0.76815116, 0.62396044), rampStep(0.45, 0.55, by1));
    ramp2 = mix(ramp2, vec3f(1.0), rampStep(0.55, 1.0, by1));
    return ramp2;
}

/// The light `index` as the world point `p` sees it.
fn lightAt(index: u32, p: vec3f) -> Light {
    switch index {
        // lights[0]: Point(position: (-4, 7, 6), radius: 0.5)
        case 0u: { return pointLight(p, vec3f(-4.0, 7.0, 6.0), 0.5, vec3f(1.0)); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
