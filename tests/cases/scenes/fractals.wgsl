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
    hit = nearer(hit, groundCrossing(ray), OBJECT_GROUND);
    hit = nearer(hit, spongeCrossing(rayInto(spongeSpace(), ray)), OBJECT_SPONGE);
    hit = nearer(hit, bulbCrossing(ray), OBJECT_BULB);
    hit = nearer(hit, gyroidCrossing(ray), OBJECT_GYROID);
    hit = nearerCrossing(hit, bittenSolid(ray));
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if groundCrossing(ray) < NO_HIT { return true; }
    if spongeCrossing(rayInto(spongeSpace(), ray)) < NO_HIT { return true; }
    if bulbCrossing(ray) < NO_HIT { return true; }
    if gyroidCrossing(ray) < NO_HIT { return true; }
    if bittenSolid(ray).t < NO_HIT { return true; }
    return false;
}

/// objects[0] "ground": Plane()
fn groundCrossing(ray: Ray) -> f32 {
    return plane(ray, vec3f(0.0, 1.0, 0.0), 0.0);
}

fn groundSurfaceAt(p: vec3f) -> Surface {
    return planeSurface(p, vec3f(0.0, 1.0, 0.0), 0.0);
}

/// objects[1] "sponge": MengerSponge(center: (-1.55, 0.86, -0.4), size: 1.7, rotate_deg: (0, 18, 0…
fn spongeCrossing(ray: Ray) -> f32 {
    return mengerSponge(ray, vec3f(-1.55, 0.86, -0.4), 1.7, 3u);
}

fn spongeSurfaceAt(p: vec3f) -> Surface {
    return mengerSpongeSurface(p, vec3f(-1.55, 0.86, -0.4), 1.7, 3u);
}

fn spongeSpace() -> Space {
    return Space(
        vec4f(0.95105654, 0.0, -0.309017, 0.0),
        vec4f(0.0, 1.0, 0.0, 0.0),
        vec4f(0.309017, 0.0, 0.95105654, 0.0),
    );
}

/// objects[2] "bulb": Mandelbulb(center: (0.75, 0.95, -1.3), size: 1.05)
fn bulbCrossing(ray: Ray) -> f32 {
    return mandelbulb(ray, vec3f(0.75, 0.95, -1.3), 1.05, 8.0, 5u);
}

fn bulbSurfaceAt(p: vec3f) -> Surface {
    return mandelbulbSurface(p, vec3f(0.75, 0.95, -1.3), 1.05, 8.0, 5u);
}

/// objects[3] "gyroid": Gyroid(center: (0.35, 0.6, 1.2), radius: 0.6, period: 0.62, thickness: 0.0…
fn gyroidCrossing(ray: Ray) -> f32 {
    return gyroid(ray, vec3f(0.35, 0.6, 1.2), 0.6, 0.62, 0.05);
}

fn gyroidSurfaceAt(p: vec3f) -> Surface {
    return gyroidSurface(p, vec3f(0.35, 0.6, 1.2), 0.6, 0.62, 0.05);
}

/// "bitten SmoothBalls 0": SmoothBalls(a: (-0.3, 0, 0), b: (0.45, 0.2, 0), radius_a: 0.6, radius_b…
fn bittenSmoothBalls0Crossing(ray: Ray) -> f32 {
    return smoothBalls(ray, vec3f(-0.3, 0.0, 0.0), vec3f(0.45, 0.2, 0.0), 0.6, 0.42, 0.4);
}

fn bittenSmoothBalls0SurfaceAt(p: vec3f) -> Surface {
    return smoothBallsSurface(p, vec3f(-0.3, 0.0, 0.0), vec3f(0.45, 0.2, 0.0), 0.6, 0.42, 0.4);
}

fn bittenSmoothBalls0Space() -> Space {
    return Space(
        vec4f(1.0, 0.0, 0.0, -2.1),
        vec4f(0.0, 1.0, 0.0, -0.6),
        vec4f(0.0, 0.0, 1.0, -0.2),
    );
}

/// "bite": MengerSponge(center: (0.2, 0.5, 0.5), size: 1, levels: 2)
fn biteCrossing(ray: Ray) -> f32 {
    return mengerSponge(ray, vec3f(0.2, 0.5, 0.5), 1.0, 2u);
}

fn biteSurfaceAt(p: vec3f) -> Surface {
    return mengerSpongeSurface(p, vec3f(0.2, 0.5, 0.5), 1.0, 2u);
}

fn biteSpace() -> Space {
    return Space(
        vec4f(1.0, 0.0, 0.0, -2.1),
        vec4f(0.0, 1.0, 0.0, -0.6),
        vec4f(0.0, 0.0, 1.0, -0.2),
    );
}

/// objects[4] "bitten": Difference(translate: (2.1, 0.6, 0.2))
fn bittenSolid(ray: Ray) -> Crossing {
    var rest = ray;
    var moved0 = rayInto(bittenSmoothBalls0Space(), ray);
    var smoothballs_0_part = notAsked();
    var bite_part = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if smoothballs_0_part.t <= rest.t_min {
            let t = bittenSmoothBalls0Crossing(moved0);
            let on = bittenSmoothBalls0SurfaceAt(pointAt(moved0, t));
            smoothballs_0_part = crossing(
                moved0,
                t,
                OBJECT_BITTEN_SMOOTHBALLS_0,
                on.geometric_normal,
            );
        }
        if bite_part.t <= rest.t_min {
            let t = biteCrossing(moved0);
            let on = biteSurfaceAt(pointAt(moved0, t));
            bite_part = crossing(moved0, t, OBJECT_BITE, on.geometric_normal);
        }
        let t = min(smoothballs_0_part.t, bite_part.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        let smoothballs_0_turns = smoothballs_0_part.t <= rest.t_min;
        let bite_turns = bite_part.t <= rest.t_min;
        let before = smoothballs_0_part.leaves && !bite_part.leaves;
        let behind = smoothballs_0_part.leaves != smoothballs_0_turns
            && bite_part.leaves == bite_turns;
        if before != behind {
            return Crossing(
                t,
                select(bite_part.object, smoothballs_0_part.object, smoothballs_0_turns),
                before,
            );
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_GROUND: { return placed(groundSurfaceAt(p), p); }
        case OBJECT_SPONGE: {
            return placedFrom(spongeSpace(), spongeSurfaceAt(pointInto(spongeSpace(), p)), p);
        }
        case OBJECT_BULB: { return placed(bulbSurfaceAt(p), p); }
        case OBJECT_GYROID: { return placed(gyroidSurfaceAt(p), p); }
        case OBJECT_BITTEN_SMOOTHBALLS_0: {
            return placedFrom(
                bittenSmoothBalls0Space(),
                bittenSmoothBalls0SurfaceAt(pointInto(bittenSmoothBalls0Space(), p)),
                p,
            );
        }
        case OBJECT_BITE: {
            return placedFrom(biteSpace(), inverted(biteSurfaceAt(pointInto(biteSpace(), p))), p);
        }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
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

/// material "ground": (color: Hexagon(scale: 2), reflectivity: 0.05, fresnel: 5)
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

/// material "sponge": (color: "#d8a24a", specular: 0.2)
fn spongeMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.6866853, 0.36130682, 0.068478175));
    material.specular = 0.2;
    return material;
}

/// material "bulb": (color: "#b9574a", specular: 0.3)
fn bulbMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.48514995, 0.09530747, 0.068478175));
    material.specular = 0.3;
    return material;
}

/// material "gyroid": (color: "#4a86a8", specular: 0.5)
fn gyroidMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.068478175, 0.2383976, 0.3915725));
    material.specular = 0.5;
    return material;
}

/// material "bitten": (color: "#7a9a57", specular: 0.4)
fn bittenMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.19461784, 0.32314324, 0.09530747));
    material.specular = 0.4;
    return material;
}

/// material "bite": (color: "#f1e4c3")
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
