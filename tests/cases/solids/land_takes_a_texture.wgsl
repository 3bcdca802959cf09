// Generated from tests/cases/solids/land_takes_a_texture.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   land, crater, SmoothBalls 1
//   shapes    Heightfield, Sphere, SmoothBalls
//   textures  LinearGradient, Fbm

const OBJECT_LAND: u32 = 0u;
const OBJECT_CRATER: u32 = 1u;
const OBJECT_SMOOTHBALLS_1: u32 = 2u;
const LIGHTS: u32 = 1u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearerCrossing(hit, valleySolid(ray));
    hit = nearer(hit, smoothBalls1Field(rayInto(smoothBalls1Space(), ray)), OBJECT_SMOOTHBALLS_1);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if valleySolid(ray).t < NO_HIT { return true; }
    if smoothBalls1Field(rayInto(smoothBalls1Space(), ray)) < NO_HIT { return true; }
    return false;
}

/// "land": Heightfield(height: "hills", size: (4, 1, 3))

/// "crater": Sphere(center: (0.6, 0.8, 0.5), radius: 0.7)
fn craterCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.6, 0.8, 0.5), 0.7);
}

fn craterSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.6, 0.8, 0.5), 0.7);
}

/// objects[1] "SmoothBalls 1": SmoothBalls(translate: (-0.7, 1.1, -0.5), blend: LinearGradient(sta…

fn smoothBalls1Space() -> Space {
    return Space(vec4f(1.0, 0.0, 0.0, 0.7), vec4f(0.0, 1.0, 0.0, -1.1), vec4f(0.0, 0.0, 1.0, 0.5));
}

/// objects[0] "valley": Difference()
fn valleySolid(ray: Ray) -> Crossing {
    var rest = ray;
    var land_part = notAsked();
    var crater_part = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if land_part.t <= rest.t_min {
            let t = landField(rest);
            let on = landFieldSurface(pointAt(rest, t));
            land_part = crossing(rest, t, OBJECT_LAND, on.geometric_normal);
        }
        if crater_part.t <= rest.t_min {
            let t = craterCrossing(rest);
            let on = craterSurfaceAt(pointAt(rest, t));
            crater_part = crossing(rest, t, OBJECT_CRATER, on.geometric_normal);
        }
        let t = min(land_part.t, crater_part.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        let land_turns = land_part.t <= rest.t_min;
        let crater_turns = crater_part.t <= rest.t_min;
        let before = land_part.leaves && !crater_part.leaves;
        let behind = land_part.leaves != land_turns && crater_part.leaves == crater_turns;
        if before != behind {
            return Crossing(t, select(crater_part.object, land_part.object, land_turns), before);
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_LAND: { return placed(landFieldSurface(p), p); }
        case OBJECT_CRATER: { return placed(inverted(craterSurfaceAt(p)), p); }
        case OBJECT_SMOOTHBALLS_1: {
            return placedFrom(
                smoothBalls1Space(),
                smoothBalls1FieldSurface(pointInto(smoothBalls1Space(), p)),
                p,
            );
        }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The distance to "land", with the textures that shape it.
fn landFieldDistance(p: vec3f) -> f32 {
    let place = heightfieldTexturePoint(p);
    let at = surface(place, vec3f(0.0, 1.0, 0.0), place.xz);
    return heightfieldDistance(p, hillsTexture(at), vec3f(4.0, 1.0, 3.0), 3.0);
}

fn landFieldBounds() -> Bounds {
    return heightfieldBounds(f32(1.0), vec3f(4.0, 1.0, 3.0), 3.0);
}

/// The distance to "SmoothBalls 1", with the textures that shape it.
fn smoothBalls1FieldDistance(p: vec3f) -> f32 {
    let place = p;
    let at = surface(place, vec3f(0.0, 1.0, 0.0), place.xz);
    return smoothBallsDistance(
        p,
        vec3f(-0.6, 0.0, 0.0),
        vec3f(0.7, 0.3, 0.0),
        0.8,
        0.55,
        luminance(linearGradient(at, vec3f(1.0, 1.0, 0.0), -1.0, 1.5, vec3f(0.1), vec3f(0.9))),
    );
}

fn smoothBalls1FieldBounds() -> Bounds {
    return smoothBallsBounds(vec3f(-0.6, 0.0, 0.0), vec3f(0.7, 0.3, 0.0), 0.8, 0.55, f32(1.0));
}

/// Where `ray` first changes sides of landFieldDistance.
fn landField(ray: Ray) -> f32 {
    var march = marchFrom(ray, landFieldBounds());
    for (var i = 0u; march.t < march.end && i < MARCH_STEPS; i++) {
        let p = ray.origin + march.t * ray.direction;
        if !marches(&march, landFieldDistance(p)) { break; }
    }
    return marched(ray, march);
}

fn landFieldSurface(p: vec3f) -> Surface {
    let step = normalStep(landFieldBounds());
    var slope = vec3f(0.0, 1e-20, 0.0);
    for (var i = 0u; i < 4u; i++) {
        let corner = tetrahedronCorner(i);
        slope += corner * landFieldDistance(p + step * corner);
    }
    let normal = normalize(slope);
    return surface(p, normal, p * flatTangents(normal));
}

/// Where `ray` first changes sides of smoothBalls1FieldDistance.
fn smoothBalls1Field(ray: Ray) -> f32 {
    var march = marchFrom(ray, smoothBalls1FieldBounds());
    for (var i = 0u; march.t < march.end && i < MARCH_STEPS; i++) {
        let p = ray.origin + march.t * ray.direction;
        if !marches(&march, smoothBalls1FieldDistance(p)) { break; }
    }
    return marched(ray, march);
}

fn smoothBalls1FieldSurface(p: vec3f) -> Surface {
    let step = normalStep(smoothBalls1FieldBounds());
    var slope = vec3f(0.0, 1e-20, 0.0);
    for (var i = 0u; i < 4u; i++) {
        let corner = tetrahedronCorner(i);
        slope += corner * smoothBalls1FieldDistance(p + step * corner);
    }
    let normal = normalize(slope);
    return surface(p, normal, p * flatTangents(normal));
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_LAND: { return landMaterial(at); }
        case OBJECT_CRATER: { return craterMaterial(at); }
        case OBJECT_SMOOTHBALLS_1: { return defaultMaterial(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "land": (color: "#8a9a5b")
fn landMaterial(at: Surface) -> Material {
    return matte(vec3f(0.25415212, 0.32314324, 0.10461649));
}

/// material "crater": (color: "#7a5a44")
fn craterMaterial(at: Surface) -> Material {
    return matte(vec3f(0.19461784, 0.10224174, 0.057805438));
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

/// texture "hills": Fbm(scale: 0.8, octaves: 4)
fn hillsTexture(at: Surface) -> f32 {
    return fbm(at, 0.8, 4u, 2.0, 0.5);
}

/// The light `index` as the world point `p` sees it.
fn lightAt(index: u32, p: vec3f) -> Light {
    switch index {
        // lights[0]: Directional(direction: (-1, -1, -0.3))
        case 0u: { return directionalLight(
            vec3f(-0.69171447, -0.69171447, -0.20751435),
            0.0,
            vec3f(1.0),
        ); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
