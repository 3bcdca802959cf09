// Generated from tests/cases/lights/soft.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Plane 0, Box 1
//   shapes    Plane, Box

const OBJECT_PLANE_0: u32 = 0u;
const OBJECT_BOX_1: u32 = 1u;
const LIGHTS: u32 = 3u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, plane0Crossing(ray), OBJECT_PLANE_0);
    hit = nearer(hit, box1Crossing(ray), OBJECT_BOX_1);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if plane0Crossing(ray) < NO_HIT { return true; }
    if box1Crossing(ray) < NO_HIT { return true; }
    return false;
}

/// objects[0] "Plane 0": Plane()
fn plane0Crossing(ray: Ray) -> f32 {
    return plane(ray, vec3f(0.0, 1.0, 0.0), 0.0);
}

fn plane0SurfaceAt(p: vec3f) -> Surface {
    return planeSurface(p, vec3f(0.0, 1.0, 0.0), 0.0);
}

/// objects[1] "Box 1": Box(min: (-0.4, 0, -0.4), max: (0.4, 2, 0.4))
fn box1Crossing(ray: Ray) -> f32 {
    return box(ray, vec3f(-0.4, 0.0, -0.4), vec3f(0.4, 2.0, 0.4));
}

fn box1SurfaceAt(p: vec3f) -> Surface {
    return boxSurface(p, vec3f(-0.4, 0.0, -0.4), vec3f(0.4, 2.0, 0.4));
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_PLANE_0: { return placed(plane0SurfaceAt(p), p); }
        case OBJECT_BOX_1: { return placed(box1SurfaceAt(p), p); }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_PLANE_0, OBJECT_BOX_1: { return defaultMaterial(at); }
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
        // lights[0]: Rect(corner: (-4, 4, -1), u: (1.5, 0, 0), v: (0, 0, 1.5), intensity: 0.7)
        case 0u: { return rectLight(
            p,
            vec3f(-4.0, 4.0, -1.0),
            vec3f(1.5, 0.0, 0.0),
            vec3f(0.0, 0.0, 1.5),
            vec3f(0.7),
        ); }
        // lights[1]: Spot(position: (4, 4, 2), cone_deg: 50, radius: 0.4, intensity: 0.5)
        case 1u: { return spotLight(
            p,
            vec3f(4.0, 4.0, 2.0),
            0.4,
            vec3f(-0.6666667, -0.6666667, -0.33333334),
            0.92387956,
            0.90630776,
            vec3f(0.5),
        ); }
        // lights[2]: Directional(direction: (0, -1, -0.4), angle_deg: 5, intensity: 0.2)
        case 2u: { return directionalLight(
            vec3f(0.0, -0.92847675, -0.3713907),
            0.043660942,
            vec3f(0.2),
        ); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
