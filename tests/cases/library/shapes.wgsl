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
    // objects[0] "RoundedCone 0": RoundedCone(translate: (0, 0, 0))
    hit = nearer(
        hit,
        roundedCone(
            rayInto(
                Space(
                    vec4f(1.0, 0.0, 0.0, 0.0),
                    vec4f(0.0, 1.0, 0.0, 0.0),
                    vec4f(0.0, 0.0, 1.0, 0.0),
                ),
                ray,
            ),
            vec3f(0.0),
            vec3f(0.0, 1.0, 0.0),
            0.5,
            0.25,
        ),
        OBJECT_ROUNDEDCONE_0,
    );
    // objects[1] "Wedge 1": Wedge(translate: (2, 0, 0))
    hit = nearer(
        hit,
        wedge(
            rayInto(
                Space(
                    vec4f(1.0, 0.0, 0.0, -2.0),
                    vec4f(0.0, 1.0, 0.0, 0.0),
                    vec4f(0.0, 0.0, 1.0, 0.0),
                ),
                ray,
            ),
            vec3f(-1.0),
            vec3f(1.0),
        ),
        OBJECT_WEDGE_1,
    );
    // objects[2] "Pyramid 2": Pyramid(translate: (4, 0, 0))
    hit = nearer(
        hit,
        pyramid(
            rayInto(
                Space(
                    vec4f(1.0, 0.0, 0.0, -4.0),
                    vec4f(0.0, 1.0, 0.0, 0.0),
                    vec4f(0.0, 0.0, 1.0, 0.0),
                ),
                ray,
            ),
            vec3f(0.0),
            vec3f(0.0, 1.0, 0.0),
            2.0,
            0.0,
        ),
        OBJECT_PYRAMID_2,
    );
    // objects[3] "Paraboloid 3": Paraboloid(translate: (6, 0, 0))
    hit = nearer(
        hit,
        paraboloid(
            rayInto(
                Space(
                    vec4f(1.0, 0.0, 0.0, -6.0),
                    vec4f(0.0, 1.0, 0.0, 0.0),
                    vec4f(0.0, 0.0, 1.0, 0.0),
                ),
                ray,
            ),
            vec3f(0.0),
            vec3f(0.0, 1.0, 0.0),
            1.0,
        ),
        OBJECT_PARABOLOID_3,
    );
    // objects[4] "Hyperboloid 4": Hyperboloid(translate: (8, 0, 0))
    hit = nearer(
        hit,
        hyperboloid(
            rayInto(
                Space(
                    vec4f(1.0, 0.0, 0.0, -8.0),
                    vec4f(0.0, 1.0, 0.0, 0.0),
                    vec4f(0.0, 0.0, 1.0, 0.0),
                ),
                ray,
            ),
            vec3f(0.0),
            vec3f(0.0, 1.0, 0.0),
            1.0,
            0.5,
        ),
        OBJECT_HYPERBOLOID_4,
    );
    // objects[5] "Superellipsoid 5": Superellipsoid(translate: (10, 0, 0))
    hit = nearer(
        hit,
        superellipsoid(
            rayInto(
                Space(
                    vec4f(1.0, 0.0, 0.0, -10.0),
                    vec4f(0.0, 1.0, 0.0, 0.0),
                    vec4f(0.0, 0.0, 1.0, 0.0),
                ),
                ray,
            ),
            vec3f(0.0),
            vec3f(1.0),
            0.4,
            0.4,
        ),
        OBJECT_SUPERELLIPSOID_5,
    );
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if roundedCone(
        rayInto(
            Space(vec4f(1.0, 0.0, 0.0, 0.0), vec4f(0.0, 1.0, 0.0, 0.0), vec4f(0.0, 0.0, 1.0, 0.0)),
            ray,
        ),
        vec3f(0.0),
        vec3f(0.0, 1.0, 0.0),
        0.5,
        0.25,
    ) < NO_HIT { return true; }
    if wedge(
        rayInto(
            Space(vec4f(1.0, 0.0, 0.0, -2.0), vec4f(0.0, 1.0, 0.0, 0.0), vec4f(0.0, 0.0, 1.0, 0.0)),
            ray,
        ),
        vec3f(-1.0),
        vec3f(1.0),
    ) < NO_HIT { return true; }
    if pyramid(
        rayInto(
            Space(vec4f(1.0, 0.0, 0.0, -4.0), vec4f(0.0, 1.0, 0.0, 0.0), vec4f(0.0, 0.0, 1.0, 0.0)),
            ray,
        ),
        vec3f(0.0),
        vec3f(0.0, 1.0, 0.0),
        2.0,
        0.0,
    ) < NO_HIT { return true; }
    if paraboloid(
        rayInto(
            Space(vec4f(1.0, 0.0, 0.0, -6.0), vec4f(0.0, 1.0, 0.0, 0.0), vec4f(0.0, 0.0, 1.0, 0.0)),
            ray,
        ),
        vec3f(0.0),
        vec3f(0.0, 1.0, 0.0),
        1.0,
    ) < NO_HIT { return true; }
    if hyperboloid(
        rayInto(
            Space(vec4f(1.0, 0.0, 0.0, -8.0), vec4f(0.0, 1.0, 0.0, 0.0), vec4f(0.0, 0.0, 1.0, 0.0)),
            ray,
        ),
        vec3f(0.0),
        vec3f(0.0, 1.0, 0.0),
        1.0,
        0.5,
    ) < NO_HIT { return true; }
    if superellipsoid(
        rayInto(
            Space(
                vec4f(1.0, 0.0, 0.0, -10.0),
                vec4f(0.0, 1.0, 0.0, 0.0),
                vec4f(0.0, 0.0, 1.0, 0.0),
            ),
            ray,
        ),
        vec3f(0.0),
        vec3f(1.0),
        0.4,
        0.4,
    ) < NO_HIT { return true; }
    return false;
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_ROUNDEDCONE_0: {
            let space = Space(
                vec4f(1.0, 0.0, 0.0, 0.0),
                vec4f(0.0, 1.0, 0.0, 0.0),
                vec4f(0.0, 0.0, 1.0, 0.0),
            );
            return placedFrom(
                space,
                roundedConeSurface(
                    pointInto(space, p),
                    vec3f(0.0),
                    vec3f(0.0, 1.0, 0.0),
                    0.5,
                    0.25,
                ),
                p,
            );
        }
        case OBJECT_WEDGE_1: {
            let space = Space(
                vec4f(1.0, 0.0, 0.0, -2.0),
                vec4f(0.0, 1.0, 0.0, 0.0),
                vec4f(0.0, 0.0, 1.0, 0.0),
            );
            return placedFrom(space, wedgeSurface(pointInto(space, p), vec3f(-1.0), vec3f(1.0)), p);
        }
        case OBJECT_PYRAMID_2: {
            let space = Space(
                vec4f(1.0, 0.0, 0.0, -4.0),
                vec4f(0.0, 1.0, 0.0, 0.0),
                vec4f(0.0, 0.0, 1.0, 0.0),
            );
            return placedFrom(
                space,
                pyramidSurface(pointInto(space, p), vec3f(0.0), vec3f(0.0, 1.0, 0.0), 2.0, 0.0),
                p,
            );
        }
        case OBJECT_PARABOLOID_3: {
            let space = Space(
                vec4f(1.0, 0.0, 0.0, -6.0),
                vec4f(0.0, 1.0, 0.0, 0.0),
                vec4f(0.0, 0.0, 1.0, 0.0),
            );
            return placedFrom(
                space,
                paraboloidSurface(pointInto(space, p), vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0),
                p,
            );
        }
        case OBJECT_HYPERBOLOID_4: {
            let space = Space(
                vec4f(1.0, 0.0, 0.0, -8.0),
                vec4f(0.0, 1.0, 0.0, 0.0),
                vec4f(0.0, 0.0, 1.0, 0.0),
            );
            return placedFrom(
                space,
                hyperboloidSurface(pointInto(space, p), vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0, 0.5),
                p,
            );
        }
        case OBJECT_SUPERELLIPSOID_5: {
            let space = Space(
                vec4f(1.0, 0.0, 0.0, -10.0),
                vec4f(0.0, 1.0, 0.0, 0.0),
                vec4f(0.0, 0.0, 1.0, 0.0),
            );
            return placedFrom(
                space,
                superellipsoidSurface(pointInto(space, p), vec3f(0.0), vec3f(1.0), 0.4, 0.4),
                p,
            );
        }
        default: {
            return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p);
        }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_ROUNDEDCONE_0: { return roundedCone0Material(at); }
        case OBJECT_WEDGE_1: { return wedge1Material(at); }
        case OBJECT_PYRAMID_2: { return pyramid2Material(at); }
        case OBJECT_PARABOLOID_3: { return paraboloid3Material(at); }
        case OBJECT_HYPERBOLOID_4: { return hyperboloid4Material(at); }
        case OBJECT_SUPERELLIPSOID_5: { return superellipsoid5Material(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

fn roundedCone0Material(at: Surface) -> Material {
    return matte(vec3f(0.8));
}

fn wedge1Material(at: Surface) -> Material {
    return matte(vec3f(0.8));
}

fn pyramid2Material(at: Surface) -> Material {
    return matte(vec3f(0.8));
}

fn paraboloid3Material(at: Surface) -> Material {
    return matte(vec3f(0.8));
}

fn hyperboloid4Material(at: Surface) -> Material {
    return matte(vec3f(0.8));
}

fn superellipsoid5Material(at: Surface) -> Material {
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
