// Generated from tests/cases/geometry/flat.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Plane 0, Disk 1, Triangle 2, Quad 3
//   shapes    Plane, Disk, Triangle, Quad
//   textures  Checker

const OBJECT_PLANE_0: u32 = 0u;
const OBJECT_DISK_1: u32 = 1u;
const OBJECT_TRIANGLE_2: u32 = 2u;
const OBJECT_QUAD_3: u32 = 3u;
const LIGHTS: u32 = 1u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, plane0Crossing(ray), OBJECT_PLANE_0);
    hit = nearer(hit, disk1Crossing(ray), OBJECT_DISK_1);
    hit = nearer(hit, triangle2Crossing(ray), OBJECT_TRIANGLE_2);
    hit = nearer(hit, quad3Crossing(ray), OBJECT_QUAD_3);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if plane0Crossing(ray) < NO_HIT { return true; }
    if disk1Crossing(ray) < NO_HIT { return true; }
    if triangle2Crossing(ray) < NO_HIT { return true; }
    if quad3Crossing(ray) < NO_HIT { return true; }
    return false;
}

/// objects[0] "Plane 0": Plane(normal: (0, 2, 0), offset: -1)
fn plane0Crossing(ray: Ray) -> f32 {
    return plane(ray, vec3f(0.0, 2.0, 0.0), -1.0);
}

fn plane0SurfaceAt(p: vec3f) -> Surface {
    return planeSurface(p, vec3f(0.0, 2.0, 0.0), -1.0);
}

/// objects[1] "Disk 1": Disk(center: (-2.4, 0.6, 0), normal: (0.3, 0.4, -1), radius: 1, inner_radi…
fn disk1Crossing(ray: Ray) -> f32 {
    return disk(ray, vec3f(-2.4, 0.6, 0.0), vec3f(0.3, 0.4, -1.0), 1.0, 0.4);
}

fn disk1SurfaceAt(p: vec3f) -> Surface {
    return diskSurface(p, vec3f(-2.4, 0.6, 0.0), vec3f(0.3, 0.4, -1.0), 1.0, 0.4);
}

/// objects[2] "Triangle 2": Triangle(a: (-0.9, -0.4, 0), b: (0, 1.6, 0), c: (0.9, -0.4, -0.4))
fn triangle2Crossing(ray: Ray) -> f32 {
    return triangle(ray, vec3f(-0.9, -0.4, 0.0), vec3f(0.0, 1.6, 0.0), vec3f(0.9, -0.4, -0.4));
}

fn triangle2SurfaceAt(p: vec3f) -> Surface {
    return triangleSurface(p, vec3f(-0.9, -0.4, 0.0), vec3f(0.0, 1.6, 0.0), vec3f(0.9, -0.4, -0.4));
}

/// objects[3] "Quad 3": Quad(corner: (1.4, -0.6, 0), u: (1.6, 0, -0.8), v: (0.3, 1.8, 0))
fn quad3Crossing(ray: Ray) -> f32 {
    return quad(ray, vec3f(1.4, -0.6, 0.0), vec3f(1.6, 0.0, -0.8), vec3f(0.3, 1.8, 0.0));
}

fn quad3SurfaceAt(p: vec3f) -> Surface {
    return quadSurface(p, vec3f(1.4, -0.6, 0.0), vec3f(1.6, 0.0, -0.8), vec3f(0.3, 1.8, 0.0));
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_PLANE_0: { return placed(plane0SurfaceAt(p), p); }
        case OBJECT_DISK_1: { return placed(disk1SurfaceAt(p), p); }
        case OBJECT_TRIANGLE_2: { return placed(triangle2SurfaceAt(p), p); }
        case OBJECT_QUAD_3: { return placed(quad3SurfaceAt(p), p); }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_PLANE_0: { return plane0Material(at); }
        case OBJECT_DISK_1: { return disk1Material(at); }
        case OBJECT_TRIANGLE_2: { return triangle2Material(at); }
        case OBJECT_QUAD_3: { return quad3Material(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "Plane 0": (color: 0.5)
fn plane0Material(at: Surface) -> Material {
    return matte(vec3f(0.5));
}

/// material "Disk 1": (color: "tomato")
fn disk1Material(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.12477182, 0.06301002));
}

/// material "Triangle 2": (color: "gold")
fn triangle2Material(at: Surface) -> Material {
    return matte(vec3f(1.0, 0.6795425, 0.0));
}

/// material "Quad 3": (color: Checker(scale: 4))
fn quad3Material(at: Surface) -> Material {
    return matte(
        checker(
            at,
            4.0,
            vec3f(0.838799, 0.791298, 0.6866853),
            vec3f(0.0409152, 0.05448028, 0.07618539),
        ),
    );
}

/// Whether the material of `object` varies over its surface.
fn isTextured(object: u32) -> bool {
    switch object {
        case OBJECT_QUAD_3: { return true; }
        default: { return false; }
    }
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
        // lights[0]: Point(position: (3, 6, 6))
        case 0u: { return pointLight(p, vec3f(3.0, 6.0, 6.0), 0.0, vec3f(1.0)); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
