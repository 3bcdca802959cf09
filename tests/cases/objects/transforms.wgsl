// Generated from tests/cases/objects/transforms.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   moved, turned, mirrored, stretched
//   shapes    Box, Cone, Torus

const OBJECT_MOVED: u32 = 0u;
const OBJECT_TURNED: u32 = 1u;
const OBJECT_MIRRORED: u32 = 2u;
const OBJECT_STRETCHED: u32 = 3u;
const LIGHTS: u32 = 1u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, movedCrossing(rayInto(movedSpace(), ray)), OBJECT_MOVED);
    hit = nearer(hit, turnedCrossing(rayInto(turnedSpace(), ray)), OBJECT_TURNED);
    hit = nearer(hit, mirroredCrossing(rayInto(mirroredSpace(), ray)), OBJECT_MIRRORED);
    hit = nearer(hit, stretchedCrossing(rayInto(stretchedSpace(), ray)), OBJECT_STRETCHED);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if movedCrossing(rayInto(movedSpace(), ray)) < NO_HIT { return true; }
    if turnedCrossing(rayInto(turnedSpace(), ray)) < NO_HIT { return true; }
    if mirroredCrossing(rayInto(mirroredSpace(), ray)) < NO_HIT { return true; }
    if stretchedCrossing(rayInto(stretchedSpace(), ray)) < NO_HIT { return true; }
    return false;
}

/// objects[0] "moved": Box(translate: (-3, 0, 0), scale: 0.7)
fn movedCrossing(ray: Ray) -> f32 {
    return box(ray, vec3f(-1.0), vec3f(1.0));
}

fn movedSurfaceAt(p: vec3f) -> Surface {
    return boxSurface(p, vec3f(-1.0), vec3f(1.0));
}

fn movedSpace() -> Space {
    return Space(
        vec4f(1.4285715, 0.0, 0.0, 4.285714),
        vec4f(0.0, 1.4285715, 0.0, 0.0),
        vec4f(0.0, 0.0, 1.4285715, 0.0),
    );
}

/// objects[1] "turned": Box(rotate_deg: (30, 45, 0), scale: (1, 0.4, 0.6))
fn turnedCrossing(ray: Ray) -> f32 {
    return box(ray, vec3f(-1.0), vec3f(1.0));
}

fn turnedSurfaceAt(p: vec3f) -> Surface {
    return boxSurface(p, vec3f(-1.0), vec3f(1.0));
}

fn turnedSpace() -> Space {
    return Space(
        vec4f(0.70710677, 0.0, -0.70710677, 0.0),
        vec4f(0.8838835, 2.1650634, 0.8838835, 0.0),
        vec4f(1.0206207, -0.8333333, 1.0206207, 0.0),
    );
}

/// objects[2] "mirrored": Cone(translate: (2.6, 1, 0), scale: (0.8, -1.6, 0.8))
fn mirroredCrossing(ray: Ray) -> f32 {
    return cone(ray, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0, 0.0);
}

fn mirroredSurfaceAt(p: vec3f) -> Surface {
    return coneSurface(p, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0, 0.0);
}

fn mirroredSpace() -> Space {
    return Space(
        vec4f(1.25, 0.0, 0.0, -3.25),
        vec4f(0.0, -0.625, 0.0, 0.625),
        vec4f(0.0, 0.0, 1.25, 0.0),
    );
}

/// objects[3] "stretched": Torus(translate: (0.4, 1.9, 0), rotate_deg: (90, 0, 20), scale: (2, 1, …
fn stretchedCrossing(ray: Ray) -> f32 {
    return torus(ray, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0, 0.25);
}

fn stretchedSurfaceAt(p: vec3f) -> Surface {
    return torusSurface(p, vec3f(0.0), vec3f(0.0, 1.0, 0.0), 1.0, 0.25);
}

fn stretchedSpace() -> Space {
    return Space(
        vec4f(0.4698463, 0.17101008, 0.0, -0.5128577),
        vec4f(0.0, 0.0, 1.0, 0.0),
        vec4f(0.6840403, -1.8793852, 0.0, 3.297216),
    );
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_MOVED: {
            return placedFrom(movedSpace(), movedSurfaceAt(pointInto(movedSpace(), p)), p);
        }
        case OBJECT_TURNED: {
            return placedFrom(turnedSpace(), turnedSurfaceAt(pointInto(turnedSpace(), p)), p);
        }
        case OBJECT_MIRRORED: {
            return placedFrom(mirroredSpace(), mirroredSurfaceAt(pointInto(mirroredSpace(), p)), p);
        }
        case OBJECT_STRETCHED: {
            return placedFrom(
                stretchedSpace(),
                stretchedSurfaceAt(pointInto(stretchedSpace(), p)),
                p,
            );
        }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_MOVED: { return movedMaterial(at); }
        case OBJECT_TURNED: { return turnedMaterial(at); }
        case OBJECT_MIRRORED: { return mirroredMaterial(at); }
        case OBJECT_STRETCHED: { return stretchedMaterial(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "moved": (color: "tomato")
fn movedMaterial(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.12477182, 0.06301002));
}

/// material "turned": (color: "gold")
fn turnedMaterial(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.6795425, 0.0));
}

/// material "mirrored": (color: "skyblue")
fn mirroredMaterial(at: Surface) -> Material {
    return matte(vec3f(0.24228115, 0.6172066, 0.8307699));
}

/// material "stretched": (color: "plum")
fn stretchedMaterial(at: Surface) -> Material {
    return matte(vec3f(0.7230551, 0.35153264, 0.7230551));
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
    return vec3f(0.019382363, 0.029556835, 0.045186203);
}

fn ambientLight() -> vec3f {
    return vec3f(0.1);
}

/// The light `index` as the world point `p` sees it.
fn lightAt(index: u32, p: vec3f) -> Light {
    switch index {
        // lights[0]: Point(position: (-3, 7, 6))
        case 0u: { return pointLight(p, vec3f(-3.0, 7.0, 6.0), 0.0, vec3f(1.0)); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
