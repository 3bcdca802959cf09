// Generated from tests/cases/lights/falloff.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Plane 0
//   shapes    Plane

const OBJECT_PLANE_0: u32 = 0u;
const LIGHTS: u32 = 3u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, plane0Crossing(ray), OBJECT_PLANE_0);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if plane0Crossing(ray) < NO_HIT { return true; }
    return false;
}

/// objects[0] "Plane 0": Plane()
fn plane0Crossing(ray: Ray) -> f32 {
    return plane(ray, vec3f(0.0, 1.0, 0.0), 0.0);
}

fn plane0SurfaceAt(p: vec3f) -> Surface {
    return planeSurface(p, vec3f(0.0, 1.0, 0.0), 0.0);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_PLANE_0: { return placed(plane0SurfaceAt(p), p); }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_PLANE_0: { return defaultMaterial(at); }
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
        // lights[0]: Point(position: (0, 4, 0), intensity: 16, falloff: InverseSquare)
        case 0u: { return inverseSquare(pointLight(p, vec3f(0.0, 4.0, 0.0), 0.0, vec3f(16.0))); }
        // lights[1]: Spot(position: (3, 4, 0), intensity: 16, falloff: InverseSquare)
        case 1u: { return inverseSquare(
            spotLight(
                p,
                vec3f(3.0, 4.0, 0.0),
                0.0,
                vec3f(-0.6, -0.8, 0.0),
                0.9723699,
                0.9659258,
                vec3f(16.0),
            ),
        ); }
        // lights[2]: Rect(corner: (0, 3, -2), u: (1, 0, 0), v: (0, 0, 1), falloff: None)
        case 2u: { return rectLight(
            p,
            vec3f(0.0, 3.0, -2.0),
            vec3f(1.0, 0.0, 0.0),
            vec3f(0.0, 0.0, 1.0),
            vec3f(1.0),
        ); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
