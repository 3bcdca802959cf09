// Generated from tests/cases/patterns/triplanar.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Plane 0, ball, ring
//   shapes    Plane, Sphere, Torus
//   textures  Rotate, Dots, Brick

const OBJECT_PLANE_0: u32 = 0u;
const OBJECT_BALL: u32 = 1u;
const OBJECT_RING: u32 = 2u;
const LIGHTS: u32 = 1u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, plane0Crossing(ray), OBJECT_PLANE_0);
    hit = nearer(hit, ballCrossing(ray), OBJECT_BALL);
    hit = nearer(hit, ringCrossing(rayInto(ringSpace(), ray)), OBJECT_RING);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if plane0Crossing(ray) < NO_HIT { return true; }
    if ballCrossing(ray) < NO_HIT { return true; }
    if ringCrossing(rayInto(ringSpace(), ray)) < NO_HIT { return true; }
    return false;
}

/// objects[0] "Plane 0": Plane(offset: -1)
fn plane0Crossing(ray: Ray) -> f32 {
    return plane(ray, vec3f(0.0, 1.0, 0.0), -1.0);
}

fn plane0SurfaceAt(p: vec3f) -> Surface {
    return planeSurface(p, vec3f(0.0, 1.0, 0.0), -1.0);
}

/// objects[1] "ball": Sphere()
fn ballCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 1.0);
}

fn ballSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 1.0);
}

/// objects[2] "ring": Torus(translate: (0, 0, 2))
fn ringCrossing(ray: Ray) -> f32 {
    return torus(ray, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0, 0.25);
}

fn ringSurfaceAt(p: vec3f) -> Surface {
    return torusSurface(p, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0, 0.25);
}

fn ringSpace() -> Space {
    return Space(vec4f(1.0, 0.0, 0.0, 0.0), vec4f(0.0, 1.0, 0.0, 0.0), vec4f(0.0, 0.0, 1.0, -2.0));
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_PLANE_0: { return placed(plane0SurfaceAt(p), p); }
        case OBJECT_BALL: { return placed(ballSurfaceAt(p), p); }
        case OBJECT_RING: {
            return placedFrom(ringSpace(), ringSurfaceAt(pointInto(ringSpace(), p)), p);
        }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_PLANE_0: { return defaultMaterial(at); }
        case OBJECT_BALL: { return ballMaterial(at); }
        case OBJECT_RING: { return ringMaterial(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// The material of objects that have none in the scene.
fn defaultMaterial(at: Surface) -> Material {
    return matte(vec3f(0.8));
}

/// material "ball": (color: Triplanar(of: "bricks", sharpness: 8))
fn ballMaterial(at: Surface) -> Material {
    var sides1 = vec3f(0.0);
    for (var side = 0u; side < 3u; side++) {
        let at2 = sideOf(at, side);
        let side_color3 = bricksTexture(at2);
        sides1 += side_color3 * sideShare(at, side, 8.0);
    }
    return matte(sides1);
}

/// material "ring": (color: Triplanar(at: Rotate(), of: Ramp(by: Dots(), stops: [(0, "#234"), (1, …
fn ringMaterial(at: Surface) -> Material {
    let at1 = rotate(at, vec3f(0.0, 30.0, 0.0));
    var sides2 = vec3f(0.0);
    for (var side = 0u; side < 3u; side++) {
        let at3 = sideOf(at1, side);
        let by4 = luminance(
            dots(
                at3,
                2.0,
                0.3,
                0.0,
                1u,
                vec3f(0.46207702, 0.06480327, 0.04231141),
                vec3f(0.8631572, 0.791298, 0.66538733),
            ),
        );
        var ramp5 = vec3f(0.015996294, 0.033104766, 0.057805438);
        ramp5 = mix(ramp5, vec3f(1.0, 0.6795425, 0.0), rampStep(0.0, 1.0, by4));
        let side_color6 = ramp5;
        sides2 += side_color6 * sideShare(at1, side, 4.0);
    }
    return matte(sides2);
}

/// Whether the material of `object` varies over its surface.
fn isTextured(object: u32) -> bool {
    switch object {
        case OBJECT_BALL, OBJECT_RING: { return true; }
        default: { return false; }
    }
}

/// The world normal of `object` at `met`.
fn normalAt(object: u32, met: Placed) -> vec3f {
    switch object {
        case OBJECT_RING: { return bumpedNormal(object, met); }
        default: { return met.normal; }
    }
}

/// The height of `object` over its surface at `at`, scene units.
fn heightAt(object: u32, at: Surface) -> f32 {
    switch object {
        case OBJECT_RING: {
            var sides1 = vec3f(0.0);
            for (var side = 0u; side < 3u; side++) {
                let at2 = sideOf(at, side);
                let side_color3 = dots(
                    at2,
                    2.0,
                    0.3,
                    0.0,
                    1u,
                    vec3f(0.46207702, 0.06480327, 0.04231141),
                    vec3f(0.8631572, 0.791298, 0.66538733),
                );
                sides1 += side_color3 * sideShare(at, side, 4.0);
            }
            let height = luminance(sides1);
            return height * 0.1;
        }
        default: { return 0.0; }
    }
}

/// What a ray sees that leaves the scene in `direction`.
fn background(direction: vec3f) -> vec3f {
    return vec3f(0.0);
}

fn ambientLight() -> vec3f {
    return vec3f(0.1);
}

/// texture "bricks": Brick(scale: 3)
fn bricksTexture(at: Surface) -> vec3f {
    return brick(
        at,
        3.0,
        3.0,
        0u,
        0.1,
        0.15,
        vec3f(0.3712377, 0.084376216, 0.04231141),
        vec3f(0.62396044, 0.57112485, 0.4910209),
    );
}

/// The light `index` as the world point `p` sees it.
fn lightAt(index: u32, p: vec3f) -> Light {
    switch index {
        // lights[0]: Point(position: (4, 6, 5))
        case 0u: { return pointLight(p, vec3f(4.0, 6.0, 5.0), 0.0, vec3f(1.0)); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
