// Generated from scenes/models.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   floor, knot, gem
//   shapes    Plane, Mesh
//   textures  Fbm, Gradient

const OBJECT_FLOOR: u32 = 0u;
const OBJECT_KNOT: u32 = 1u;
const OBJECT_GEM: u32 = 2u;
/// scenes/models/knot.obj
const MODEL_KNOT: Model = Model(0u, false);
/// scenes/models/gem.glb
const MODEL_GEM: Model = Model(41620u, false);
const LIGHTS: u32 = 2u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = true;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, floorCrossing(ray), OBJECT_FLOOR);
    hit = nearer(hit, knotCrossing(rayInto(knotSpace(), ray)), OBJECT_KNOT);
    hit = nearer(hit, gemCrossing(rayInto(gemSpace(), ray)), OBJECT_GEM);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if floorCrossing(ray) < NO_HIT { return true; }
    if knotCrossing(rayInto(knotSpace(), ray)) < NO_HIT { return true; }
    return false;
}

/// objects[0] "floor": Plane()
fn floorCrossing(ray: Ray) -> f32 {
    return plane(ray, vec3f(0.0, 1.0, 0.0), 0.0);
}

fn floorSurfaceAt(p: vec3f) -> Surface {
    return planeSurface(p, vec3f(0.0, 1.0, 0.0), 0.0);
}

/// objects[1] "knot": Mesh(file: "models/knot.obj", rotate_deg: (62, 20, 0), translate: (-0.75, 1.…
fn knotCrossing(ray: Ray) -> f32 {
    return mesh(ray, MODEL_KNOT, true);
}

fn knotSurfaceAt(p: vec3f) -> Surface {
    return meshSurface(p, MODEL_KNOT, true);
}

fn knotSpace() -> Space {
    return Space(
        vec4f(0.98915017, 0.0, -0.3600212, 0.5258499),
        vec4f(0.31787986, 0.4941806, 0.8733677, 0.09528673),
        vec4f(0.16901971, -0.9294185, 0.46437785, 1.6601065),
    );
}

/// objects[2] "gem": Mesh(file: "models/gem.glb", smooth: false, scale: 0.75, translate: (1.35, 0.…
fn gemCrossing(ray: Ray) -> f32 {
    return mesh(ray, MODEL_GEM, false);
}

fn gemSurfaceAt(p: vec3f) -> Surface {
    return meshSurface(p, MODEL_GEM, false);
}

fn gemSpace() -> Space {
    return Space(
        vec4f(1.2157063, 0.30310962, -0.45602685, -1.4278007),
        vec4f(-0.32256252, 1.2937276, 0.0, -0.40546355),
        vec4f(0.44248092, 0.110322885, 1.2529235, -1.7966902),
    );
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_FLOOR: { return placed(floorSurfaceAt(p), p); }
        case OBJECT_KNOT: {
            return placedFrom(knotSpace(), knotSurfaceAt(pointInto(knotSpace(), p)), p);
        }
        case OBJECT_GEM: {
            return placedFrom(gemSpace(), gemSurfaceAt(pointInto(gemSpace(), p)), p);
        }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_KNOT: { return brassMaterial(at); }
        case OBJECT_GEM: { return glassMaterial(at); }
        case OBJECT_FLOOR: { return slateMaterial(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "brass": (color: "#7a5a22", specular: 0.9, shininess: 120, reflectivity: 0.35, fresnel…
fn brassMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.19461784, 0.10224174, 0.015996294));
    material.specular = 0.9;
    material.shininess = 120.0;
    material.reflectivity = 0.35;
    material.fresnel = 4.0;
    return material;
}

/// material "glass": (color: 0.0, specular: 0.9, shininess: 300, reflectivity: 0.05, fresnel: 5, t…
fn glassMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.0));
    material.specular = 0.9;
    material.shininess = 300.0;
    material.reflectivity = 0.05;
    material.fresnel = 5.0;
    material.transmission = 1.0;
    material.ior = 1.9;
    return material;
}

/// material "slate": (color: Ramp(by: Fbm(scale: 3), stops: [(0.2, "#2b333d"), (0.8, "#5a6675")]),…
fn slateMaterial(at: Surface) -> Material {
    let by1 = fbm(at, 3.0, 5u, 2.0, 0.5);
    var ramp2 = vec3f(0.024157634, 0.033104766, 0.046665087);
    ramp2 = mix(ramp2, vec3f(0.10224174, 0.13286832, 0.17788842), rampStep(0.2, 0.8, by1));
    var material = matte(ramp2);
    material.reflectivity = 0.06;
    return material;
}

/// Whether the material of `object` varies over its surface.
fn isTextured(object: u32) -> bool {
    switch object {
        case OBJECT_FLOOR: { return true; }
        default: { return false; }
    }
}

/// The world normal of `object` at `met`.
fn normalAt(object: u32, met: Placed) -> vec3f {
    return met.normal;
}

/// What a ray sees that leaves the scene in `direction`.
fn background(direction: vec3f) -> vec3f {
    let at = skyPoint(direction);
    return gradient(
        at,
        vec3f(0.012286489, 0.04231141, 0.18782078),
        vec3f(0.8069523, 0.58407843, 0.3712377),
    );
}

fn ambientLight() -> vec3f {
    return vec3f(0.15);
}

/// The light `index` as the world point `p` sees it.
fn lightAt(index: u32, p: vec3f) -> Light {
    switch index {
        // lights[0]: Point(position: (-4, 7, 5), radius: 0.5, intensity: 0.8)
        case 0u: { return pointLight(p, vec3f(-4.0, 7.0, 5.0), 0.5, vec3f(0.8)); }
        // lights[1]: Directional(direction: (-3, -4, -1), color: "#ffd9b0", intensity: 0.35)
        case 1u: { return directionalLight(
            vec3f(-0.5883484, -0.78446454, -0.19611613),
            0.0,
            vec3f(0.35, 0.24285513, 0.15195379),
        ); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
