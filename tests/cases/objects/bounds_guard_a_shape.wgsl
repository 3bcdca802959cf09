// Generated from tests/cases/objects/bounds_guard_a_shape.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Torus 0, moved
//   shapes    Torus

const OBJECT_TORUS_0: u32 = 0u;
const OBJECT_MOVED: u32 = 1u;
const LIGHTS: u32 = 0u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    // objects[0] "Torus 0": Torus(bounds: (min: (-1.25, -0.25, -1.25), max: (1.25, 0.25, 1.25)))
    if meetsBounds(ray, vec3f(-1.25, -0.25, -1.25), vec3f(1.25, 0.25, 1.25)) {
        hit = nearer(hit, torus(ray, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0, 0.25), OBJECT_TORUS_0);
    }
    // objects[1] "moved": Torus(translate: (3, 0, 0), rotate_deg: (0, 0, 90), bounds: (min: (-1.25…
    if meetsBounds(
        rayInto(
            Space(vec4f(0.0, 1.0, 0.0, 0.0), vec4f(-1.0, 0.0, 0.0, 3.0), vec4f(0.0, 0.0, 1.0, 0.0)),
            ray,
        ),
        vec3f(-1.25, -0.25, -1.25),
        vec3f(1.25, 0.25, 1.25),
    ) {
        hit = nearer(
            hit,
            torus(
                rayInto(
                    Space(
                        vec4f(0.0, 1.0, 0.0, 0.0),
                        vec4f(-1.0, 0.0, 0.0, 3.0),
                        vec4f(0.0, 0.0, 1.0, 0.0),
                    ),
                    ray,
                ),
                vec3f(0.0),
                vec3f(0.0, 1.0, 0.0),
                1.0,
                0.25,
            ),
            OBJECT_MOVED,
        );
    }
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if meetsBounds(ray, vec3f(-1.25, -0.25, -1.25), vec3f(1.25, 0.25, 1.25)) {
        if torus(ray, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0, 0.25) < NO_HIT { return true; }
    }
    if meetsBounds(
        rayInto(
            Space(vec4f(0.0, 1.0, 0.0, 0.0), vec4f(-1.0, 0.0, 0.0, 3.0), vec4f(0.0, 0.0, 1.0, 0.0)),
            ray,
        ),
        vec3f(-1.25, -0.25, -1.25),
        vec3f(1.25, 0.25, 1.25),
    ) {
        if torus(
            rayInto(
                Space(
                    vec4f(0.0, 1.0, 0.0, 0.0),
                    vec4f(-1.0, 0.0, 0.0, 3.0),
                    vec4f(0.0, 0.0, 1.0, 0.0),
                ),
                ray,
            ),
            vec3f(0.0),
            vec3f(0.0, 1.0, 0.0),
            1.0,
            0.25,
        ) < NO_HIT { return true; }
    }
    return false;
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_TORUS_0: {
            return placed(torusSurface(p, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0, 0.25), p);
        }
        case OBJECT_MOVED: {
            let space = Space(
                vec4f(0.0, 1.0, 0.0, 0.0),
                vec4f(-1.0, 0.0, 0.0, 3.0),
                vec4f(0.0, 0.0, 1.0, 0.0),
            );
            return placedFrom(
                space,
                torusSurface(pointInto(space, p), vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0, 0.25),
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
        case OBJECT_TORUS_0: { return torus0Material(at); }
        case OBJECT_MOVED: { return movedMaterial(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

fn torus0Material(at: Surface) -> Material {
    return matte(vec3f(0.8));
}

fn movedMaterial(at: Surface) -> Material {
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
