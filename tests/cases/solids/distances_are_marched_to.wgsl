// Generated from tests/cases/solids/distances_are_marched_to.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Plane 0, pebble, balls, bitten Pebble 1
//   shapes    Plane, Pebble, SmoothBalls

const OBJECT_PLANE_0: u32 = 0u;
const OBJECT_PEBBLE: u32 = 1u;
const OBJECT_BALLS: u32 = 2u;
const OBJECT_BITTEN_PEBBLE_1: u32 = 3u;
const LIGHTS: u32 = 1u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = nearer(hit, plane0Crossing(ray), OBJECT_PLANE_0);
    hit = nearer(hit, pebbleCrossing(rayInto(pebbleSpace(), ray)), OBJECT_PEBBLE);
    hit = nearerCrossing(hit, bittenSolid(ray));
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if plane0Crossing(ray) < NO_HIT { return true; }
    if pebbleCrossing(rayInto(pebbleSpace(), ray)) < NO_HIT { return true; }
    if bittenSolid(ray).t < NO_HIT { return true; }
    return false;
}

/// objects[0] "Plane 0": Plane()
fn plane0Crossing(ray: Ray) -> f32 {
    return plane(ray, vec3f(0.0, 1.0, 0.0), 0.0);
}

fn plane0SurfaceAt(p: vec3f) -> Surface {
    return planeSurface(p, vec3f(0.0, 1.0, 0.0), 0.0);
}

/// objects[1] "pebble": Pebble(min: (-0.6, 0, -0.4), translate: (0, 0.2, 0))
fn pebbleCrossing(ray: Ray) -> f32 {
    return pebble(ray, vec3f(-0.6, 0.0, -0.4), vec3f(0.5, 0.4, 0.5), 0.15);
}

fn pebbleSurfaceAt(p: vec3f) -> Surface {
    return pebbleSurface(p, vec3f(-0.6, 0.0, -0.4), vec3f(0.5, 0.4, 0.5), 0.15);
}

fn pebbleSpace() -> Space {
    return Space(vec4f(1.0, 0.0, 0.0, 0.0), vec4f(0.0, 1.0, 0.0, -0.2), vec4f(0.0, 0.0, 1.0, 0.0));
}

/// "balls": SmoothBalls(translate: (0, 0.9, -1))
fn ballsCrossing(ray: Ray) -> f32 {
    return smoothBalls(ray, vec3f(-0.6, 0.0, 0.0), vec3f(0.7, 0.3, 0.0), 0.8, 0.55, 0.5);
}

fn ballsSurfaceAt(p: vec3f) -> Surface {
    return smoothBallsSurface(p, vec3f(-0.6, 0.0, 0.0), vec3f(0.7, 0.3, 0.0), 0.8, 0.55, 0.5);
}

fn ballsSpace() -> Space {
    return Space(vec4f(1.0, 0.0, 0.0, 0.0), vec4f(0.0, 1.0, 0.0, -0.9), vec4f(0.0, 0.0, 1.0, 1.0));
}

/// "bitten Pebble 1": Pebble(translate: (-0.6, 0.9, -0.2))
fn bittenPebble1Crossing(ray: Ray) -> f32 {
    return pebble(ray, vec3f(-0.5, 0.0, -0.5), vec3f(0.5, 0.4, 0.5), 0.15);
}

fn bittenPebble1SurfaceAt(p: vec3f) -> Surface {
    return pebbleSurface(p, vec3f(-0.5, 0.0, -0.5), vec3f(0.5, 0.4, 0.5), 0.15);
}

fn bittenPebble1Space() -> Space {
    return Space(vec4f(1.0, 0.0, 0.0, 0.6), vec4f(0.0, 1.0, 0.0, -0.9), vec4f(0.0, 0.0, 1.0, 0.2));
}

/// objects[2] "bitten": Difference()
fn bittenSolid(ray: Ray) -> Crossing {
    var rest = ray;
    var moved0 = rayInto(ballsSpace(), ray);
    var moved1 = rayInto(bittenPebble1Space(), ray);
    var balls_part = notAsked();
    var pebble_1_part = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if balls_part.t <= rest.t_min {
            let t = ballsCrossing(moved0);
            let on = ballsSurfaceAt(pointAt(moved0, t));
            balls_part = crossing(moved0, t, OBJECT_BALLS, on.geometric_normal);
        }
        if pebble_1_part.t <= rest.t_min {
            let t = bittenPebble1Crossing(moved1);
            let on = bittenPebble1SurfaceAt(pointAt(moved1, t));
            pebble_1_part = crossing(moved1, t, OBJECT_BITTEN_PEBBLE_1, on.geometric_normal);
        }
        let t = min(balls_part.t, pebble_1_part.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        moved1.t_min = rest.t_min;
        let balls_turns = balls_part.t <= rest.t_min;
        let pebble_1_turns = pebble_1_part.t <= rest.t_min;
        let before = balls_part.leaves && !pebble_1_part.leaves;
        let behind = balls_part.leaves != balls_turns && pebble_1_part.leaves == pebble_1_turns;
        if before != behind {
            return Crossing(
                t,
                select(pebble_1_part.object, balls_part.object, balls_turns),
                before,
            );
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_PLANE_0: { return placed(plane0SurfaceAt(p), p); }
        case OBJECT_PEBBLE: {
            return placedFrom(pebbleSpace(), pebbleSurfaceAt(pointInto(pebbleSpace(), p)), p);
        }
        case OBJECT_BALLS: {
            return placedFrom(ballsSpace(), ballsSurfaceAt(pointInto(ballsSpace(), p)), p);
        }
        case OBJECT_BITTEN_PEBBLE_1: {
            return placedFrom(
                bittenPebble1Space(),
                inverted(bittenPebble1SurfaceAt(pointInto(bittenPebble1Space(), p))),
                p,
            );
        }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// Where `ray` first changes sides of pebbleDistance.
fn pebble(ray: Ray, given_min: vec3f, given_max: vec3f, given_radius: f32) -> f32 {
    var march = marchFrom(ray, pebbleBounds(given_min, given_max, given_radius));
    for (var i = 0u; march.t < march.end && i < MARCH_STEPS; i++) {
        let p = ray.origin + march.t * ray.direction;
        if !marches(&march, pebbleDistance(p, given_min, given_max, given_radius)) { break; }
    }
    return marched(ray, march);
}

fn pebbleSurface(p: vec3f, given_min: vec3f, given_max: vec3f, given_radius: f32) -> Surface {
    let step = normalStep(pebbleBounds(given_min, given_max, given_radius));
    var slope = vec3f(0.0, 1e-20, 0.0);
    for (var i = 0u; i < 4u; i++) {
        let corner = tetrahedronCorner(i);
        slope += corner * pebbleDistance(p + step * corner, given_min, given_max, given_radius);
    }
    let normal = normalize(slope);
    return surface(p, normal, p * flatTangents(normal));
}

/// Where `ray` first changes sides of smoothBallsDistance.
fn smoothBalls(
    ray: Ray,
    given_a: vec3f,
    given_b: vec3f,
    given_radius_a: f32,
    given_radius_b: f32,
    given_blend: f32,
) -> f32 {
    var march = marchFrom(
        ray,
        smoothBallsBounds(given_a, given_b, given_radius_a, given_radius_b, given_blend),
    );
    for (var i = 0u; march.t < march.end && i < MARCH_STEPS; i++) {
        let p = ray.origin + march.t * ray.direction;
        if !marches(
            &march,
            smoothBallsDistance(p, given_a, given_b, given_radius_a, given_radius_b, given_blend),
        ) { break; }
    }
    return marched(ray, march);
}

fn smoothBallsSurface(
    p: vec3f,
    given_a: vec3f,
    given_b: vec3f,
    given_radius_a: f32,
    given_radius_b: f32,
    given_blend: f32,
) -> Surface {
    let step = normalStep(
        smoothBallsBounds(given_a, given_b, given_radius_a, given_radius_b, given_blend),
    );
    var slope = vec3f(0.0, 1e-20, 0.0);
    for (var i = 0u; i < 4u; i++) {
        let corner = tetrahedronCorner(i);
        slope += corner * smoothBallsDistance(
            p + step * corner,
            given_a,
            given_b,
            given_radius_a,
            given_radius_b,
            given_blend,
        );
    }
    let normal = normalize(slope);
    return surface(p, normal, p * flatTangents(normal));
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_PLANE_0, OBJECT_BALLS, OBJECT_BITTEN_PEBBLE_1: { return defaultMaterial(at); }
        case OBJECT_PEBBLE: { return pebbleMaterial(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// The material of objects that have none in the scene.
fn defaultMaterial(at: Surface) -> Material {
    return matte(vec3f(0.8));
}

/// material "pebble": (color: "tan")
fn pebbleMaterial(at: Surface) -> Material {
    return matte(vec3f(0.6444797, 0.45641103, 0.2622507));
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
        // lights[0]: Point(position: (4, 6, 3))
        case 0u: { return pointLight(p, vec3f(4.0, 6.0, 3.0), 0.0, vec3f(1.0)); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
