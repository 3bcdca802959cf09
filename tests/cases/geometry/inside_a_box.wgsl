// Generated from tests/cases/geometry/inside_a_box.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Box 0, Cylinder 1
//   shapes    Box, Cylinder
//   textures  Stripes

const OBJECT_BOX_0: u32 = 0u;
const OBJECT_CYLINDER_1: u32 = 1u;
const LIGHTS: u32 = 1u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, box0Crossing(ray), OBJECT_BOX_0);
    hit = nearer(hit, cylinder1Crossing(ray), OBJECT_CYLINDER_1);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if box0Crossing(ray) < NO_HIT { return true; }
    if cylinder1Crossing(ray) < NO_HIT { return true; }
    return false;
}

/// objects[0] "Box 0": Box(min: (-3, -2, -3), max: (3, 2, 3))
fn box0Crossing(ray: Ray) -> f32 {
    return box(ray, vec3f(-3.0, -2.0, -3.0), vec3f(3.0, 2.0, 3.0));
}

fn box0SurfaceAt(p: vec3f) -> Surface {
    return boxSurface(p, vec3f(-3.0, -2.0, -3.0), vec3f(3.0, 2.0, 3.0));
}

/// objects[1] "Cylinder 1": Cylinder(base: (-0.5, -2, -1), top: (-0.5, -0.6, -1), radius: 0.5)
fn cylinder1Crossing(ray: Ray) -> f32 {
    return cylinder(ray, vec3f(-0.5, -2.0, -1.0), vec3f(-0.5, -0.6, -1.0), 0.5);
}

fn cylinder1SurfaceAt(p: vec3f) -> Surface {
    return cylinderSurface(p, vec3f(-0.5, -2.0, -1.0), vec3f(-0.5, -0.6, -1.0), 0.5);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_BOX_0: { return placed(box0SurfaceAt(p), p); }
        case OBJECT_CYLINDER_1: { return placed(cylinder1SurfaceAt(p), p); }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_BOX_0: { return box0Material(at); }
        case OBJECT_CYLINDER_1: { return cylinder1Material(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "Box 0": (color: Stripes(scale: 2, even: "#e8d5b0", odd: "#8c6a5a"))
fn box0Material(at: Surface) -> Material {
    return matte(
        stripes(
            at,
            2.0,
            vec3f(0.8069523, 0.66538733, 0.43415368),
            vec3f(0.2622507, 0.14412847, 0.10224174),
        ),
    );
}

/// material "Cylinder 1": (color: "skyblue")
fn cylinder1Material(at: Surface) -> Material {
    return matte(vec3f(0.24228115, 0.6172066, 0.8307699));
}

/// Whether the material of `object` varies over its surface.
fn isTextured(object: u32) -> bool {
    switch object {
        case OBJECT_BOX_0: { return true; }
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

/// The light `index` as the world point `p` sees it.
fn lightAt(index: u32, p: vec3f) -> Light {
    switch index {
        // lights[0]: Point(position: (0, 1.6, 0))
        case 0u: { return pointLight(p, vec3f(0.0, 1.6, 0.0), 0.0, vec3f(1.0)); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
