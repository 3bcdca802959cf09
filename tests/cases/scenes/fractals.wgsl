// Generated from scenes/fractals.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   ground, sponge, bulb, gyroid, bitten SmoothBalls 0, bite
//   shapes    Plane, MengerSponge, Mandelbulb, Gyroid, SmoothBalls
//   textures  Hexagon, ScaleBy, Clouds

const OBJECT_GROUND: u32 = 0u;
const OBJECT_SPONGE: u32 = 1u;
const OBJECT_BULB: u32 = 2u;
const OBJECT_GYROID: u32 = 3u;
const OBJECT_BITTEN_SMOOTHBALLS_0: u32 = 4u;
const OBJECT_BITE: u32 = 5u;
const LIGHTS: u32 = 1u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    // objects[0] "ground": Plane()
    hit = nearer(hit, plane(ray, vec3f(0.0, 1.0, 0.0), 0.0), OBJECT_GROUND);
    // objects[1] "sponge": MengerSponge(center: (-1.55, 0.86, -0.4), size: 1.7, rotate_deg: (0, 18…
    hit = nearer(
        hit,
        mengerSponge(
            rayInto(
                Space(
                    vec4f(0.95105654, 0.0, -0.309017, 0.0),
                    vec4f(0.0, 1.0, 0.0, 0.0),
                    vec4f(0.309017, 0.0, 0.95105654, 0.0),
                ),
                ray,
            ),
            vec3f(-1.55, 0.86, -0.4),
            1.7,
            3u,
        ),
        OBJECT_SPONGE,
    );
    // objects[2] "bulb": Mandelbulb(center: (0.75, 0.95, -1.3), size: 1.05)
    hit = nearer(hit, mandelbulb(ray, vec3f(0.75, 0.95, -1.3), 1.05, 8.0, 5u), OBJECT_BULB);
    // objects[3] "gyroid": Gyroid(center: (0.35, 0.6, 1.2), radius: 0.6, period: 0.62, thickness: …
    hit = nearer(hit, gyroid(ray, vec3f(0.35, 0.6, 1.2), 0.6, 0.62, 0.05), OBJECT_GYROID);
    // "bitten": Difference(translate: (2.1, 0.6, 0.2))
    hit = nearerCrossing(hit, bittenSolid(ray));
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if plane(ray, vec3f(0.0, 1.0, 0.0), 0.0) < NO_HIT { return true; }
    if mengerSponge(
        rayInto(
            Space(
                vec4f(0.95105654, 0.0, -0.309017, 0.0),
                vec4f(0.0, 1.0, 0.0, 0.0),
                vec4f(0.309017, 0.0, 0.95105654, 0.0),
            ),
            ray,
        ),
        vec3f(-1.55, 0.86, -0.4),
        1.7,
        3u,
    ) < NO_HIT { return true; }
    if mandelbulb(ray, vec3f(0.75, 0.95, -1.3), 1.05, 8.0, 5u) < NO_HIT { return true; }
    if gyroid(ray, vec3f(0.35, 0.6, 1.2), 0.6, 0.62, 0.05) < NO_HIT { return true; }
    if bittenSolid(ray).t < NO_HIT { return true; }
    return false;
}

/// "bitten": Difference(translate: (2.1, 0.6, 0.2))
fn bittenSolid(ray: Ray) -> Crossing {
    var rest = ray;
    var moved0 = rayInto(
        Space(vec4f(1.0, 0.0, 0.0, -2.1), vec4f(0.0, 1.0, 0.0, -0.6), vec4f(0.0, 0.0, 1.0, -0.2)),
        ray,
    );
    var smoothBalls0Part = notAsked();
    var bitePart = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if smoothBalls0Part.t <= rest.t_min {
            let t = smoothBalls(
                moved0,
                vec3f(-0.3, 0.0, 0.0),
                vec3f(0.45, 0.2, 0.0),
                0.6,
                0.42,
                0.4,
            );
            let on = smoothBallsSurface(
                pointAt(moved0, t),
                vec3f(-0.3, 0.0, 0.0),
                vec3f(0.45, 0.2, 0.0),
                0.6,
                0.42,
                0.4,
            );
            smoothBalls0Part = crossing(
                moved0,
                t,
                OBJECT_BITTEN_SMOOTHBALLS_0,
                on.geometric_normal,
            );
        }
        if bitePart.t <= rest.t_min {
            let t = mengerSponge(moved0, vec3f(0.2, 0.5, 0.5), 1.0, 2u);
            let on = mengerSpongeSurface(pointAt(moved0, t), vec3f(0.2, 0.5, 0.5), 1.0, 2u);
            bitePart = crossing(moved0, t, OBJECT_BITE, on.geometric_normal);
        }
        let t = min(smoothBalls0Part.t, bitePart.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        let smoothBalls0Turns = smoothBalls0Part.t <= rest.t_min;
        let biteTurns = bitePart.t <= rest.t_min;
        let before = smoothBalls0Part.leaves && !bitePart.leaves;
        let behind = smoothBalls0Part.leaves != smoothBalls0Turns && bitePart.leaves == biteTurns;
        if before != behind {
            return Crossing(
                t,
                select(bitePart.object, smoothBalls0Part.object, smoothBalls0Turns),
                before,
            );
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_GROUND: {
            return placed(planeSurface(p, vec3f(0.0, 1.0, 0.0), 0.0), p);
        }
        case OBJECT_SPONGE: {
            let space = Space(
                vec4f(0.95105654, 0.0, -0.309017, 0.0),
                vec4f(0.0, 1.0, 0.0, 0.0),
                vec4f(0.309017, 0.0, 0.95105654, 0.0),
            );
            return placedFrom(
                space,
                mengerSpongeSurface(pointInto(space, p), vec3f(-1.55, 0.86, -0.4), 1.7, 3u),
                p,
            );
        }
        case OBJECT_BULB: {
            return placed(mandelbulbSurface(p, vec3f(0.75, 0.95, -1.3), 1.05, 8.0, 5u), p);
        }
        case OBJECT_GYROID: {
            return placed(gyroidSurface(p, vec3f(0.35, 0.6, 1.2), 0.6, 0.62, 0.05), p);
        }
        case OBJECT_BITTEN_SMOOTHBALLS_0: {
            let space = Space(
                vec4f(1.0, 0.0, 0.0, -2.1),
                vec4f(0.0, 1.0, 0.0, -0.6),
                vec4f(0.0, 0.0, 1.0, -0.2),
            );
            return placedFrom(
                space,
                smoothBallsSurface(
                    pointInto(space, p),
                    vec3f(-0.3, 0.0, 0.0),
                    vec3f(0.45, 0.2, 0.0),
                    0.6,
                    0.42,
                    0.4,
                ),
                p,
            );
        }
        case OBJECT_BITE: {
            let space = Space(
                vec4f(1.0, 0.0, 0.0, -2.1),
                vec4f(0.0, 1.0, 0.0, -0.6),
                vec4f(0.0, 0.0, 1.0, -0.2),
            );
            return placedFrom(
                space,
                inverted(mengerSpongeSurface(pointInto(space, p), vec3f(0.2, 0.5, 0.5), 1.0, 2u)),
                p,
            );
        }
        default: {
            return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p);
        }
    }
}

/// Where `ray` first changes sides of mengerSpongeDistance.
fn mengerSponge(ray: Ray, given_center: vec3f, given_size: f32, given_levels: u32) -> f32 {
    var march = marchFrom(ray, mengerSpongeBounds(given_center, given_size, given_levels));
    for (var i = 0u; march.t < march.end && i < MARCH_STEPS; i++) {
        let p = ray.origin + march.t * ray.direction;
        if !marches(
            &march,
            mengerSpongeDistance(p, given_center, given_size, given_levels),
        ) { break; }
    }
    return marched(ray, march);
}

fn mengerSpongeSurface(
    p: vec3f,
    given_center: vec3f,
    given_size: f32,
    given_levels: u32,
) -> Surface {
    let step = normalStep(mengerSpongeBounds(given_center, given_size, given_levels));
    var slope = vec3f(0.0, 1e-20, 0.0);
    for (var i = 0u; i < 4u; i++) {
        let corner = tetrahedronCorner(i);
        slope += corner * mengerSpongeDistance(
            p + step * corner,
            given_center,
            given_size,
            given_levels,
        );
    }
    let normal = normalize(slope);
    return surface(p, normal, p * flatTangents(normal));
}

/// Where `ray` first changes sides of mandelbulbDistance.
fn mandelbulb(
    ray: Ray,
    given_center: vec3f,
    given_size: f32,
    given_power: f32,
    given_iterations: u32,
) -> f32 {
    var march = marchFrom(
        ray,
        mandelbulbBounds(given_center, given_size, given_power, given_iterations),
    );
    for (var i = 0u; march.t < march.end && i < MARCH_STEPS; i++) {
        let p = ray.origin + march.t * ray.direction;
        if !marches(
            &march,
            mandelbulbDistance(p, given_center, given_size, given_power, given_iterations),
        ) { break; }
    }
    return marched(ray, march);
}

fn mandelbulbSurface(
    p: vec3f,
    given_center: vec3f,
    given_size: f32,
    given_power: f32,
    given_iterations: u32,
) -> Surface {
    let step = normalStep(
        mandelbulbBounds(given_center, given_size, given_power, given_iterations),
    );
    var slope = vec3f(0.0, 1e-20, 0.0);
    for (var i = 0u; i < 4u; i++) {
        let corner = tetrahedronCorner(i);
        slope += corner * mandelbulbDistance(
            p + step * corner,
            given_center,
            given_size,
            given_power,
            given_iterations,
        );
    }
    let normal = normalize(slope);
    return surface(p, normal, p * flatTangents(normal));
}

/// Where `ray` first changes sides of gyroidDistance.
fn gyroid(
    ray: Ray,
    given_center: vec3f,
    given_radius: f32,
    given_period: f32,
    given_thickness: f32,
) -> f32 {
    var march = marchFrom(
        ray,
        gyroidBounds(given_center, given_radius, given_period, given_thickness),
    );
    for (var i = 0u; march.t < march.end && i < MARCH_STEPS; i++) {
        let p = ray.origin + march.t * ray.direction;
        if !marches(
            &march,
            gyroidDistance(p, given_center, given_radius, given_period, given_thickness),
        ) { break; }
    }
    return marched(ray, march);
}

fn gyroidSurface(
    p: vec3f,
    given_center: vec3f,
    given_radius: f32,
    given_period: f32,
    given_thickness: f32,
) -> Surface {
    let step = normalStep(gyroidBounds(given_center, given_radius, given_period, given_thickness));
    var slope = vec3f(0.0, 1e-20, 0.0);
    for (var i = 0u; i < 4u; i++) {
        let corner = tetrahedronCorner(i);
        slope += corner * gyroidDistance(
            p + step * corner,
            given_center,
            given_radius,
            given_period,
            given_thickness,
        );
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
        case OBJECT_GROUND: { return groundMaterial(at); }
        case OBJECT_SPONGE: { return spongeMaterial(at); }
        case OBJECT_BULB: { return bulbMaterial(at); }
        case OBJECT_GYROID: { return gyroidMaterial(at); }
        case OBJECT_BITTEN_SMOOTHBALLS_0: { return bittenMaterial(at); }
        case OBJECT_BITE: { return biteMaterial(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

fn groundMaterial(at: Surface) -> Material {
    var material = matte(
        hexagon(
            at,
            2.0,
            0.06,
            3u,
            vec3f(0.791298, 0.73791045, 0.62396044),
            vec3f(0.20507874, 0.32314324, 0.2622507),
            vec3f(0.033104766, 0.08021983, 0.10224174),
            vec3f(0.5394795, 0.4793202, 0.38132605),
        ),
    );
    material.reflectivity = 0.05;
    material.fresnel = 5.0;
    return material;
}

fn spongeMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.6866853, 0.36130682, 0.068478175));
    material.specular = 0.2;
    return material;
}

fn bulbMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.48514995, 0.09530747, 0.068478175));
    material.specular = 0.3;
    return material;
}

fn gyroidMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.068478175, 0.2383976, 0.3915725));
    material.specular = 0.5;
    return material;
}

fn bittenMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.19461784, 0.32314324, 0.09530747));
    material.specular = 0.4;
    return material;
}

fn biteMaterial(at: Surface) -> Material {
    return matte(vec3f(0.8796224, 0.7758222, 0.5457245));
}

/// Whether the material of `object` varies over its surface.
fn isTextured(object: u32) -> bool {
    switch object {
        case OBJECT_GROUND: { return true; }
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
    let at1 = scaleBy(at, vec3f(0.4));
    return clouds(
        at1,
        0.8,
        5u,
        0.5,
        0.5,
        vec3f(0.10946172, 0.24620135, 0.58407843),
        vec3f(0.9646863, 0.9559733, 0.9301109),
        vec3f(0.5457245, 0.60382736, 0.6866853),
    );
}

fn ambientLight() -> vec3f {
    return vec3f(0.22);
}

/// The light `index` as the world point `p` sees it.
fn lightAt(index: u32, p: vec3f) -> Light {
    switch index {
        // lights[0]: Directional(direction: (-1.2, -2, -1.1), color: "#fff2dc", intensity: 0.9)
        case 0u: { return directionalLight(
            vec3f(-0.46534005, -0.7755667, -0.42656168),
            0.0,
            vec3f(0.9, 0.7991308, 0.64412415),
        ); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
