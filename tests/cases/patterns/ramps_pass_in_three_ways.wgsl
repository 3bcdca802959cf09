// Generated from tests/cases/patterns/ramps_pass_in_three_ways.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Plane 0, Sphere 1
//   shapes    Plane, Sphere
//   textures  Noise

const OBJECT_PLANE_0: u32 = 0u;
const OBJECT_SPHERE_1: u32 = 1u;
const LIGHTS: u32 = 0u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, plane0Crossing(ray), OBJECT_PLANE_0);
    hit = nearer(hit, sphere1Crossing(ray), OBJECT_SPHERE_1);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if plane0Crossing(ray) < NO_HIT { return true; }
    if sphere1Crossing(ray) < NO_HIT { return true; }
    return false;
}

/// objects[0] "Plane 0": Plane()
fn plane0Crossing(ray: Ray) -> f32 {
    return plane(ray, vec3f(0.0, 1.0, 0.0), 0.0);
}

fn plane0SurfaceAt(p: vec3f) -> Surface {
    return planeSurface(p, vec3f(0.0, 1.0, 0.0), 0.0);
}

/// objects[1] "Sphere 1": Sphere()
fn sphere1Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 1.0);
}

fn sphere1SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 1.0);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_PLANE_0: { return placed(plane0SurfaceAt(p), p); }
        case OBJECT_SPHERE_1: { return placed(sphere1SurfaceAt(p), p); }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_PLANE_0: { return plane0Material(at); }
        case OBJECT_SPHERE_1: { return sphere1Material(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "Plane 0": (color: Ramp(by: Noise(), stops: [(0.3, "#000"), (0.5, "tomato"), (0.7, "#f…
fn plane0Material(at: Surface) -> Material {
    let by1 = noise(at, 1.5);
    var ramp2 = vec3f(0.0);
    ramp2 = mix(ramp2, vec3f(1.0, 0.12477182, 0.06301002), rampSmooth(0.3, 0.5, by1));
    ramp2 = mix(ramp2, vec3f(1.0), rampSmooth(0.5, 0.7, by1));
    return matte(ramp2);
}

/// material "Sphere 1": (color: Ramp(by: Noise(), stops: [(0.3, "#000"), (0.5, "tomato")], interpo…
fn sphere1Material(at: Surface) -> Material {
    let by1 = noise(at, 1.5);
    var ramp2 = vec3f(0.0);
    ramp2 = mix(ramp2, vec3f(1.0, 0.12477182, 0.06301002), rampConstant(0.3, 0.5, by1));
    return matte(ramp2);
}

/// Whether the material of `object` varies over its surface.
fn isTextured(object: u32) -> bool {
    return true;
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
