// Generated from tests/cases/library/shapes.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   RoundedCone 0, Wedge 1, Pyramid 2, Paraboloid 3, Hyperboloid 4, Superellipsoid 5
//   shapes    RoundedCone, Wedge, Pyramid, Paraboloid, Hyperboloid, Superellipsoid

const OBJECT_ROUNDEDCONE_0: u32 = 0u;
const OBJECT_WEDGE_1: u32 = 1u;
const OBJECT_PYRAMID_2: u32 = 2u;
const OBJECT_PARABOLOID_3: u32 = 3u;
const OBJECT_HYPERBOLOID_4: u32 = 4u;
const OBJECT_SUPERELLIPSOID_5: u32 = 5u;
const LIGHTS: u32 = 0u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(
        hit,
        roundedCone0Crossing(rayInto(roundedCone0Space(), ray)),
        OBJECT_ROUNDEDCONE_0,
    );
    hit = nearer(hit, wedge1Crossing(rayInto(wedge1Space(), ray)), OBJECT_WEDGE_1);
    hit = nearer(hit, pyramid2Crossing(rayInto(pyramid2Space(), ray)), OBJECT_PYRAMID_2);
    hit = nearer(hit, paraboloid3Crossing(rayInto(paraboloid3Space(), ray)), OBJECT_PARABOLOID_3);
    hit = nearer(
        hit,
        hyperboloid4Crossing(rayInto(hyperboloid4Space(), ray)),
        OBJECT_HYPERBOLOID_4,
    );
    hit = nearer(
        hit,
        superellipsoid5Crossing(rayInto(superellipsoid5Space(), ray)),
        OBJECT_SUPERELLIPSOID_5,
    );
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if roundedCone0Crossing(rayInto(roundedCone0Space(), ray)) < NO_HIT { return true; }
    if wedge1Crossing(rayInto(wedge1Space(), ray)) < NO_HIT { return true; }
    if pyramid2Crossing(rayInto(pyramid2Space(), ray)) < NO_HIT { return true; }
    if paraboloid3Crossing(rayInto(paraboloid3Space(), ray)) < NO_HIT { return true; }
    if hyperboloid4Crossing(rayInto(hyperboloid4Space(), ray)) < NO_HIT { return true; }
    if superellipsoid5Crossing(rayInto(superellipsoid5Space(), ray)) < NO_HIT { return true; }
    return false;
}

/// objects[0] "RoundedCone 0": RoundedCone(translate: (0, 0, 0))
fn roundedCone0Crossing(ray: Ray) -> f32 {
    return roundedCone(ray, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 0.5, 0.25);
}

fn roundedCone0SurfaceAt(p: vec3f) -> Surface {
    return roundedConeSurface(p, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 0.5, 0.25);
}

fn roundedCone0Space() -> Space {
    return Space(vec4f(1.0, 0.0, 0.0, 0.0), vec4f(0.0, 1.0, 0.0, 0.0), vec4f(0.0, 0.0, 1.0, 0.0));
}

/// objects[1] "Wedge 1": Wedge(translate: (2, 0, 0))
fn wedge1Crossing(ray: Ray) -> f32 {
    return wedge(ray, vec3f(-1.0), vec3f(1.0));
}

fn wedge1SurfaceAt(p: vec3f) -> Surface {
    return wedgeSurface(p, vec3f(-1.0), vec3f(1.0));
}

fn wedge1Space() -> Space {
    return Space(vec4f(1.0, 0.0, 0.0, -2.0), vec4f(0.0, 1.0, 0.0, 0.0), vec4f(0.0, 0.0, 1.0, 0.0));
}

/// objects[2] "Pyramid 2": Pyramid(translate: (4, 0, 0))
fn pyramid2Crossing(ray: Ray) -> f32 {
    return pyramid(ray, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 2.0, 0.0);
}

fn pyramid2SurfaceAt(p: vec3f) -> Surface {
    return pyramidSurface(p, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 2.0, 0.0);
}

fn pyramid2Space() -> Space {
    return Space(vec4f(1.0, 0.0, 0.0, -4.0), vec4f(0.0, 1.0, 0.0, 0.0), vec4f(0.0, 0.0, 1.0, 0.0));
}

/// objects[3] "Paraboloid 3": Paraboloid(translate: (6, 0, 0))
fn paraboloid3Crossing(ray: Ray) -> f32 {
    return paraboloid(ray, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0);
}

fn paraboloid3SurfaceAt(p: vec3f) -> Surface {
    return paraboloidSurface(p, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0);
}

fn paraboloid3Space() -> Space {
    return Space(vec4f(1.0, 0.0, 0.0, -6.0), vec4f(0.0, 1.0, 0.0, 0.0), vec4f(0.0, 0.0, 1.0, 0.0));
}

/// objects[4] "Hyperboloid 4": Hyperboloid(translate: (8, 0, 0))
fn hyperboloid4Crossing(ray: Ray) -> f32 {
    return hyperboloid(ray, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0, 0.5);
}

fn hyperboloid4SurfaceAt(p: vec3f) -> Surface {
    return hyperboloidSurface(p, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0, 0.5);
}

fn hyperboloid4Space() -> Space {
    return Space(vec4f(1.0, 0.0, 0.0, -8.0), vec4f(0.0, 1.0, 0.0, 0.0), vec4f(0.0, 0.0, 1.0, 0.0));
}

/// objects[5] "Superellipsoid 5": Superellipsoid(translate: (10, 0, 0))
fn superellipsoid5Crossing(ray: Ray) -> f32 {
    return superellipsoid(ray, vec3f(0.0), vec3f(1.0), 0.4, 0.4);
}

fn superellipsoid5SurfaceAt(p: vec3f) -> Surface {
    return superellipsoidSurface(p, vec3f(0.0), vec3f(1.0), 0.4, 0.4);
}

fn superellipsoid5Space() -> Space {
    return Space(vec4f(1.0, 0.0, 0.0, -10.0), vec4f(0.0, 1.0, 0.0, 0.0), vec4f(0.0, 0.0, 1.0, 0.0));
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_ROUNDEDCONE_0: {
            return placedFrom(
                roundedCone0Space(),
                roundedCone0SurfaceAt(pointInto(roundedCone0Space(), p)),
                p,
            );
        }
        case OBJECT_WEDGE_1: {
            return placedFrom(wedge1Space(), wedge1SurfaceAt(pointInto(wedge1Space(), p)), p);
        }
        case OBJECT_PYRAMID_2: {
            return placedFrom(pyramid2Space(), pyramid2SurfaceAt(pointInto(pyramid2Space(), p)), p);
        }
        case OBJECT_PARABOLOID_3: {
            return placedFrom(
                paraboloid3Space(),
                paraboloid3SurfaceAt(pointInto(paraboloid3Space(), p)),
                p,
            );
        }
        case OBJECT_HYPERBOLOID_4: {
            return placedFrom(
                hyperboloid4Space(),
                hyperboloid4SurfaceAt(pointInto(hyperboloid4Space(), p)),
                p,
            );
        }
        case OBJECT_SUPERELLIPSOID_5: {
            return placedFrom(
                superellipsoid5Space(),
                superellipsoid5SurfaceAt(pointInto(superellipsoid5Space(), p)),
                p,
            );
        }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_ROUNDEDCONE_0,
             OBJECT_WEDGE_1,
             OBJECT_PYRAMID_2,
             OBJECT_PARABOLOID_3,
             OBJECT_HYPERBOLOID_4,
             OBJECT_SUPERELLIPSOID_5: {
            return defaultMaterial(at);
        }
        default: { return matte(vec3f(0.0)); }
    }
}

/// The material of objects that have none in the scene.
fn defaultMaterial(at: Surface) -> Material {
    return matte(vec3f(0.8));
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
