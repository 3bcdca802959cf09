// Generated from tests/cases/patterns/image.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Plane 0, Quad 1, Sphere 2
//   shapes    Plane, Quad, Sphere

const OBJECT_PLANE_0: u32 = 0u;
const OBJECT_QUAD_1: u32 = 1u;
const OBJECT_SPHERE_2: u32 = 2u;
const LIGHTS: u32 = 1u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, plane0Crossing(ray), OBJECT_PLANE_0);
    hit = nearer(hit, quad1Crossing(ray), OBJECT_QUAD_1);
    hit = nearer(hit, sphere2Crossing(ray), OBJECT_SPHERE_2);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if plane0Crossing(ray) < NO_HIT { return true; }
    if quad1Crossing(ray) < NO_HIT { return true; }
    if sphere2Crossing(ray) < NO_HIT { return true; }
    return false;
}

/// objects[0] "Plane 0": Plane()
fn plane0Crossing(ray: Ray) -> f32 {
    return plane(ray, vec3f(0.0, 1.0, 0.0), 0.0);
}

fn plane0SurfaceAt(p: vec3f) -> Surface {
    return planeSurface(p, vec3f(0.0, 1.0, 0.0), 0.0);
}

/// objects[1] "Quad 1": Quad(corner: (-1.2, 0.05, 0), u: (1.4, 0, 0), v: (0, 1.05, 0))
fn quad1Crossing(ray: Ray) -> f32 {
    return quad(ray, vec3f(-1.2, 0.05, 0.0), vec3f(1.4, 0.0, 0.0), vec3f(0.0, 1.05, 0.0));
}

fn quad1SurfaceAt(p: vec3f) -> Surface {
    return quadSurface(p, vec3f(-1.2, 0.05, 0.0), vec3f(1.4, 0.0, 0.0), vec3f(0.0, 1.05, 0.0));
}

/// objects[2] "Sphere 2": Sphere(center: (1.2, 0.6, 0), radius: 0.6)
fn sphere2Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(1.2, 0.6, 0.0), 0.6);
}

fn sphere2SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(1.2, 0.6, 0.0), 0.6);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_PLANE_0: { return placed(plane0SurfaceAt(p), p); }
        case OBJECT_QUAD_1: { return placed(quad1SurfaceAt(p), p); }
        case OBJECT_SPHERE_2: { return placed(sphere2SurfaceAt(p), p); }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// tests/cases/patterns/photo.jpg
@group(1) @binding(1) var image0: texture_2d<f32>;

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_PLANE_0: { return plane0Material(at); }
        case OBJECT_QUAD_1: { return quad1Material(at); }
        case OBJECT_SPHERE_2: { return sphere2Material(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "Plane 0": (color: Image(file: "photo.jpg", width: 0.8))
fn plane0Material(at: Surface) -> Material {
    return matte(imageColor(image0, at, 0.8, true));
}

/// material "Quad 1": (color: Image(file: "photo.jpg", width: 1.4, repeat: false))
fn quad1Material(at: Surface) -> Material {
    return matte(imageColor(image0, at, 1.4, false));
}

/// material "Sphere 2": (color: Triplanar(of: Image(file: "photo.jpg", width: 0.6)))
fn sphere2Material(at: Surface) -> Material {
    var sides1 = vec3f(0.0);
    for (var side = 0u; side < 3u; side++) {
        let at2 = sideOf(at, side);
        let side_color3 = imageColor(image0, at2, 0.6, true);
        sides1 += side_color3 * sideShare(at, side, 4.0);
    }
    return matte(sides1);
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
        // lights[0]: Point(position: (4, 6, 5))
        case 0u: { return pointLight(p, vec3f(4.0, 6.0, 5.0), 0.0, vec3f(1.0)); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
