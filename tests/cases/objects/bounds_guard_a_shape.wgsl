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
    if torus0InReach(ray) {
        hit = nearer(hit, torus0Crossing(ray), OBJECT_TORUS_0);
    }
    if movedInReach(ray) {
        hit = nearer(hit, movedCrossing(rayInto(movedSpace(), ray)), OBJECT_MOVED);
    }
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if torus0InReach(ray) {
        if torus0Crossing(ray) < NO_HIT { return true; }
    }
    if movedInReach(ray) {
        if movedCrossing(rayInto(movedSpace(), ray)) < NO_HIT { return true; }
    }
    return false;
}

/// objects[0] "Torus 0": Torus(bounds: (min: (-1.25, -0.25, -1.25), max: (1.25, 0.25, 1.25)))
fn torus0Crossing(ray: Ray) -> f32 {
    return torus(ray, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0, 0.25);
}

fn torus0SurfaceAt(p: vec3f) -> Surface {
    return torusSurface(p, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0, 0.25);
}

/// objects[1] "moved": Torus(translate: (3, 0, 0), rotate_deg: (0, 0, 90), bounds: (min: (-1.25, -…
fn movedCrossing(ray: Ray) -> f32 {
    return torus(ray, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0, 0.25);
}

fn movedSurfaceAt(p: vec3f) -> Surface {
    return torusSurface(p, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0, 0.25);
}

fn movedSpace() -> Space {
    return Space(vec4f(0.0, 1.0, 0.0, 0.0), vec4f(-1.0, 0.0, 0.0, 3.0), vec4f(0.0, 0.0, 1.0, 0.0));
}

/// Whether `ray` meets the bounds of "Torus 0".
fn torus0InReach(ray: Ray) -> bool {
    return meetsBounds(ray, vec3f(-1.25, -0.25, -1.25), vec3f(1.25, 0.25, 1.25));
}

/// Whether `ray` meets the bounds of "moved".
fn movedInReach(ray: Ray) -> bool {
    return meetsBounds(
        rayInto(movedSpace(), ray),
        vec3f(-1.25, -0.25, -1.25),
        vec3f(1.25, 0.25, 1.25),
    );
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_TORUS_0: { return placed(torus0SurfaceAt(p), p); }
        case OBJECT_MOVED: {
            return placedFrom(movedSpace(), movedSurfaceAt(pointInto(movedSpace(), p)), p);
        }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_TORUS_0, OBJECT_MOVED: { return defaultMaterial(at); }
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
