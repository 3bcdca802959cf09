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
    // objects[0] "Plane 0": Plane()
    hit = nearer(hit, plane(ray, vec3f(0.0, 1.0, 0.0), 0.0), OBJECT_PLANE_0);
    // objects[1] "pebble": Pebble(min: (-0.6, 0, -0.4), translate: (0, 0.2, 0))
    hit = nearer(
        hit,
        pebble(
            rayInto(
                Space(
                    vec4f(1.0, 0.0, 0.0, 0.0),
                    vec4f(0.0, 1.0, 0.0, -0.2),
                    vec4f(0.0, 0.0, 1.0, 0.0),
                ),
                ray,
            ),
            vec3f(-0.6, 0.0, -0.4),
            vec3f(0.5, 0.4, 0.5),
            0.15,
        ),
        OBJECT_PEBBLE,
    );
    // "bitten": Difference()
    hit = nearerCrossing(hit, bittenSolid(ray));
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if plane(ray, vec3f(0.0, 1.0, 0.0), 0.0) < NO_HIT { return true; }
    if pebble(
        rayInto(
            Space(vec4f(1.0, 0.0, 0.0, 0.0), vec4f(0.0, 1.0, 0.0, -0.2), vec4f(0.0, 0.0, 1.0, 0.0)),
            ray,
        ),
        vec3f(-0.6, 0.0, -0.4),
        vec3f(0.5, 0.4, 0.5),
        0.15,
    ) < NO_HIT { return true; }
    if bittenSolid(ray).t < NO_HIT { return true; }
    return false;
}

/// "bitten": Difference()
fn bittenSolid(ray: Ray) -> Crossing {
    var rest = ray;
    var moved0 = rayInto(
        Space(vec4f(1.0, 0.0, 0.0, 0.0), vec4f(0.0, 1.0, 0.0, -0.9), vec4f(0.0, 0.0, 1.0, 1.0)),
        ray,
    );
    var moved1 = rayInto(
        Space(vec4f(1.0, 0.0, 0.0, 0.6), vec4f(0.0, 1.0, 0.0, -0.9), vec4f(0.0, 0.0, 1.0, 0.2)),
        ray,
    );
    var ballsPart = notAsked();
    var pebble1Part = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if ballsPart.t <= rest.t_min {
            let t = smoothBalls(
                moved0,
                vec3f(-0.6, 0.0, 0.0),
                vec3f(0.7, 0.3, 0.0),
                0.8,
                0.55,
                0.5,
            );
            let on = smoothBallsSurface(
                pointAt(moved0, t),
                vec3f(-0.6, 0.0, 0.0),
                vec3f(0.7, 0.3, 0.0),
                0.8,
                0.55,
                0.5,
            );
            ballsPart = crossing(moved0, t, OBJECT_BALLS, on.geometric_normal);
        }
        if pebble1Part.t <= rest.t_min {
            let t = pebble(moved1, vec3f(-0.5, 0.0, -0.5), vec3f(0.5, 0.4, 0.5), 0.15);
            let on = pebbleSurface(
                pointAt(moved1, t),
                vec3f(-0.5, 0.0, -0.5),
                vec3f(0.5, 0.4, 0.5),
                0.15,
            );
            pebble1Part = crossing(moved1, t, OBJECT_BITTEN_PEBBLE_1, on.geometric_normal);
        }
        let t = min(ballsPart.t, pebble1Part.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        moved1.t_min = rest.t_min;
        let ballsTurns = ballsPart.t <= rest.t_min;
        let pebble1Turns = pebble1Part.t <= rest.t_min;
        let before = ballsPart.leaves && !pebble1Part.leaves;
        let behind = ballsPart.leaves != ballsTurns && pebble1Part.leaves == pebble1Turns;
        if before != behind {
            return Crossing(t, select(pebble1Part.object, ballsPart.object, ballsTurns), before);
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_PLANE_0: {
            return placed(planeSurface(p, vec3f(0.0, 1.0, 0.0), 0.0), p);
        }
        case OBJECT_PEBBLE: {
            let space = Space(
                vec4f(1.0, 0.0, 0.0, 0.0),
                vec4f(0.0, 1.0, 0.0, -0.2),
                vec4f(0.0, 0.0, 1.0, 0.0),
            );
            return placedFrom(
                space,
                pebbleSurface(
                    pointInto(space, p),
                    vec3f(-0.6, 0.0, -0.4),
                    vec3f(0.5, 0.4, 0.5),
                    0.15,
                ),
                p,
            );
        }
        case OBJECT_BALLS: {
            let space = Space(
                vec4f(1.0, 0.0, 0.0, 0.0),
                vec4f(0.0, 1.0, 0.0, -0.9),
                vec4f(0.0, 0.0, 1.0, 1.0),
            );
            return placedFrom(
                space,
                smoothBallsSurface(
                    pointInto(space, p),
                    vec3f(-0.6, 0.0, 0.0),
                    vec3f(0.7, 0.3, 0.0),
                    0.8,
                    0.55,
                    0.5,
                ),
                p,
            );
        }
        case OBJECT_BITTEN_PEBBLE_1: {
            let space = Space(
                vec4f(1.0, 0.0, 0.0, 0.6),
                vec4f(0.0, 1.0, 0.0, -0.9),
                vec4f(0.0, 0.0, 1.0, 0.2),
            );
            return placedFrom(
                space,
                inverted(
                    pebbleSurface(
                        pointInto(space, p),
                        vec3f(-0.5, 0.0, -0.5),
                        vec3f(0.5, 0.4, 0.5),
                        0.15,
                    ),
                ),
                p,
            );
        }
        default: {
            return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p);
        }
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
        case OBJECT_PLANE_0: { return plane0Material(at); }
        case OBJECT_PEBBLE: { return pebbleMaterial(at); }
        case OBJECT_BALLS: { return ballsMaterial(at); }
        case OBJECT_BITTEN_PEBBLE_1: { return bittenPebble1Material(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

fn plane0Material(at: Surface) -> Material {
    return matte(vec3f(0.8));
}

fn pebbleMaterial(at: Surface) -> Material {
    return matte(vec3f(0.6444797, 0.45641103, 0.2622507));
}

fn ballsMaterial(at: Surface) -> Material {
    return matte(vec3f(0.8));
}

fn bittenPebble1Material(at: Surface) -> Material {
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
        // lights[0]: Point(position: (4, 6, 3))
        case 0u: { return pointLight(p, vec3f(4.0, 6.0, 3.0), 0.0, vec3f(1.0)); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
