// Generated from tests/cases/geometry/edged.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Box 0, RoundedBox 1, Cylinder 2, Cone 3
//   shapes    Box, RoundedBox, Cylinder, Cone

const OBJECT_BOX_0: u32 = 0u;
const OBJECT_ROUNDEDBOX_1: u32 = 1u;
const OBJECT_CYLINDER_2: u32 = 2u;
const OBJECT_CONE_3: u32 = 3u;
const LIGHTS: u32 = 1u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, box0Crossing(ray), OBJECT_BOX_0);
    hit = nearer(hit, roundedBox1Crossing(ray), OBJECT_ROUNDEDBOX_1);
    hit = nearer(hit, cylinder2Crossing(ray), OBJECT_CYLINDER_2);
    hit = nearer(hit, cone3Crossing(ray), OBJECT_CONE_3);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if box0Crossing(ray) < NO_HIT { return true; }
    if roundedBox1Crossing(ray) < NO_HIT { return true; }
    if cylinder2Crossing(ray) < NO_HIT { return true; }
    if cone3Crossing(ray) < NO_HIT { return true; }
    return false;
}

/// objects[0] "Box 0": Box(min: (-3.2, -0.6, -0.8), max: (-1.8, 0.8, 0.8))
fn box0Crossing(ray: Ray) -> f32 {
    return box(ray, vec3f(-3.2, -0.6, -0.8), vec3f(-1.8, 0.8, 0.8));
}

fn box0SurfaceAt(p: vec3f) -> Surface {
    return boxSurface(p, vec3f(-3.2, -0.6, -0.8), vec3f(-1.8, 0.8, 0.8));
}

/// objects[1] "RoundedBox 1": RoundedBox(min: (-1.3, -0.6, -0.8), max: (0.1, 0.8, 0.8), radius: 0.…
fn roundedBox1Crossing(ray: Ray) -> f32 {
    return roundedBox(ray, vec3f(-1.3, -0.6, -0.8), vec3f(0.1, 0.8, 0.8), 0.3);
}

fn roundedBox1SurfaceAt(p: vec3f) -> Surface {
    return roundedBoxSurface(p, vec3f(-1.3, -0.6, -0.8), vec3f(0.1, 0.8, 0.8), 0.3);
}

/// objects[2] "Cylinder 2": Cylinder(base: (1.2, -0.6, 0), top: (1.2, 1, 0.3), radius: 0.6)
fn cylinder2Crossing(ray: Ray) -> f32 {
    return cylinder(ray, vec3f(1.2, -0.6, 0.0), vec3f(1.2, 1.0, 0.3), 0.6);
}

fn cylinder2SurfaceAt(p: vec3f) -> Surface {
    return cylinderSurface(p, vec3f(1.2, -0.6, 0.0), vec3f(1.2, 1.0, 0.3), 0.6);
}

/// objects[3] "Cone 3": Cone(base: (2.9, -0.6, 0), top: (2.9, 1.4, 0), base_radius: 0.8, top_radiu…
fn cone3Crossing(ray: Ray) -> f32 {
    return cone(ray, vec3f(2.9, -0.6, 0.0), vec3f(2.9, 1.4, 0.0), 0.8, 0.25);
}

fn cone3SurfaceAt(p: vec3f) -> Surface {
    return coneSurface(p, vec3f(2.9, -0.6, 0.0), vec3f(2.9, 1.4, 0.0), 0.8, 0.25);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_BOX_0: { return placed(box0SurfaceAt(p), p); }
        case OBJECT_ROUNDEDBOX_1: { return placed(roundedBox1SurfaceAt(p), p); }
        case OBJECT_CYLINDER_2: { return placed(cylinder2SurfaceAt(p), p); }
        case OBJECT_CONE_3: { return placed(cone3SurfaceAt(p), p); }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_BOX_0: { return box0Material(at); }
        case OBJECT_ROUNDEDBOX_1: { return roundedBox1Material(at); }
        case OBJECT_CYLINDER_2: { return cylinder2Material(at); }
        case OBJECT_CONE_3: { return cone3Material(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "Box 0": (color: "tomato")
fn box0Material(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.12477182, 0.06301002));
}

/// material "RoundedBox 1": (color: "gold")
fn roundedBox1Material(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.6795425, 0.0));
}

/// material "Cylinder 2": (color: "skyblue")
fn cylinder2Material(at: Surface) -> Material {
    return matte(vec3f(0.24228115, 0.6172066, 0.8307699));
}

/// material "Cone 3": (color: "plum")
fn cone3Material(at: Surface) -> Material {
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
        // lights[0]: Point(position: (-3, 7, 5))
        case 0u: { return pointLight(p, vec3f(-3.0, 7.0, 5.0), 0.0, vec3f(1.0)); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
