// Generated from tests/cases/export/files_beside_it.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Plane 0, Mesh 1
//   shapes    Plane, Mesh

const OBJECT_PLANE_0: u32 = 0u;
const OBJECT_MESH_1: u32 = 1u;
/// scenes/models/gem.glb
const MODEL_GEM: Model = Model(0u, false);
const LIGHTS: u32 = 1u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, plane0Crossing(ray), OBJECT_PLANE_0);
    hit = nearer(hit, mesh1Crossing(rayInto(mesh1Space(), ray)), OBJECT_MESH_1);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if plane0Crossing(ray) < NO_HIT { return true; }
    if mesh1Crossing(rayInto(mesh1Space(), ray)) < NO_HIT { return true; }
    return false;
}

/// objects[0] "Plane 0": Plane()
fn plane0Crossing(ray: Ray) -> f32 {
    return plane(ray, vec3f(0.0, 1.0, 0.0), 0.0);
}

fn plane0SurfaceAt(p: vec3f) -> Surface {
    return planeSurface(p, vec3f(0.0, 1.0, 0.0), 0.0);
}

/// objects[1] "Mesh 1": Mesh(file: "../../../scenes/models/gem.glb", smooth: false, scale: 0.9, tr…
fn mesh1Crossing(ray: Ray) -> f32 {
    return mesh(ray, MODEL_GEM, false);
}

fn mesh1SurfaceAt(p: vec3f) -> Surface {
    return meshSurface(p, MODEL_GEM, false);
}

fn mesh1Space() -> Space {
    return Space(
        vec4f(1.1111112, 0.0, 0.0, 0.0),
        vec4f(0.0, 1.1111112, 0.0, -0.8888889),
        vec4f(0.0, 0.0, 1.1111112, 0.0),
    );
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_PLANE_0: { return placed(plane0SurfaceAt(p), p); }
        case OBJECT_MESH_1: {
            return placedFrom(mesh1Space(), mesh1SurfaceAt(pointInto(mesh1Space(), p)), p);
        }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// tests/cases/patterns/photo.jpg
@group(1) @binding(1) var image0: texture_2d<f32>;

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_PLANE_0: { return plane0Material(at); }
        case OBJECT_MESH_1: { return defaultMaterial(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "Plane 0": (color: Image(file: "../patterns/photo.jpg", width: 0.8))
fn plane0Material(at: Surface) -> Material {
    return matte(imageColor(image0, at, 0.8, true));
}

/// The material of objects that have none in the scene.
fn defaultMaterial(at: Surface) -> Material {
    return matte(vec3f(0.8));
}

/// Whether the material of `object` varies over its surface.
fn isTextured(object: u32) -> bool {
    switch object {
        case OBJECT_PLANE_0: { return true; }
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
        // lights[0]: Point(position: (3, 6, 5))
        case 0u: { return pointLight(p, vec3f(3.0, 6.0, 5.0), 0.0, vec3f(1.0)); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
