// Generated from scenes/solids.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   table, cube RoundedBox 0, cube Sphere 1, one, two a, two b, three a, three b,
//             three c, cup RoundedCylinder 0, hollow, ring, inside, blank HexPrism 0, turned,
//             bore, front, back
//   shapes    Plane, RoundedBox, Sphere, RoundedCylinder, Torus, Cylinder, HexPrism
//   textures  Wood, Gradient

const OBJECT_TABLE: u32 = 0u;
const OBJECT_CUBE_ROUNDEDBOX_0: u32 = 1u;
const OBJECT_CUBE_SPHERE_1: u32 = 2u;
const OBJECT_ONE: u32 = 3u;
const OBJECT_TWO_A: u32 = 4u;
const OBJECT_TWO_B: u32 = 5u;
const OBJECT_THREE_A: u32 = 6u;
const OBJECT_THREE_B: u32 = 7u;
const OBJECT_THREE_C: u32 = 8u;
const OBJECT_CUP_ROUNDEDCYLINDER_0: u32 = 9u;
const OBJECT_HOLLOW: u32 = 10u;
const OBJECT_RING: u32 = 11u;
const OBJECT_INSIDE: u32 = 12u;
const OBJECT_BLANK_HEXPRISM_0: u32 = 13u;
const OBJECT_TURNED: u32 = 14u;
const OBJECT_BORE: u32 = 15u;
const OBJECT_FRONT: u32 = 16u;
const OBJECT_BACK: u32 = 17u;
const LIGHTS: u32 = 1u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = true;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    // objects[0] "table": Plane()
    hit = nearer(hit, plane(ray, vec3f(0.0, 1.0, 0.0), 0.0), OBJECT_TABLE);
    // "die": Difference(translate: (-1.9, 1, 0.4), rotate_deg: (0, 28, 0))
    hit = nearerCrossing(hit, dieSolid(ray));
    // "mug": Union(translate: (0.7, 0, -1.4), rotate_deg: (0, -35, 0))
    hit = nearerCrossing(hit, mugSolid(ray));
    // "nut": Difference(translate: (0.35, 0, 1.7), rotate_deg: (0, 15, 0))
    hit = nearerCrossing(hit, nutSolid(ray));
    // "lens": Intersection(translate: (2.6, 0.95, 0.6), rotate_deg: (0, 52, 0), casts_shadow: fals…
    hit = nearerCrossing(hit, lensSolid(ray));
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if plane(ray, vec3f(0.0, 1.0, 0.0), 0.0) < NO_HIT { return true; }
    if dieSolid(ray).t < NO_HIT { return true; }
    if mugSolid(ray).t < NO_HIT { return true; }
    if nutSolid(ray).t < NO_HIT { return true; }
    return false;
}

/// "die": Difference(translate: (-1.9, 1, 0.4), rotate_deg: (0, 28, 0))
fn dieSolid(ray: Ray) -> Crossing {
    var rest = ray;
    var moved0 = rayInto(
        Space(
            vec4f(0.88294756, 0.0, -0.46947157, 1.8653891),
            vec4f(0.0, 1.0, 0.0, -1.0),
            vec4f(0.46947157, 0.0, 0.88294756, 0.5388169),
        ),
        ray,
    );
    var cubePart = notAsked();
    var onePart = notAsked();
    var twoAPart = notAsked();
    var twoBPart = notAsked();
    var threeAPart = notAsked();
    var threeBPart = notAsked();
    var threeCPart = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if cubePart.t <= rest.t_min {
            cubePart = cubeSolid(rest);
        }
        if onePart.t <= rest.t_min {
            let t = sphere(moved0, vec3f(0.0, 1.12, 0.0), 0.32);
            let on = sphereSurface(pointAt(moved0, t), vec3f(0.0, 1.12, 0.0), 0.32);
            onePart = crossing(moved0, t, OBJECT_ONE, on.geometric_normal);
        }
        if twoAPart.t <= rest.t_min {
            let t = sphere(moved0, vec3f(-0.45, 0.45, 1.1), 0.24);
            let on = sphereSurface(pointAt(moved0, t), vec3f(-0.45, 0.45, 1.1), 0.24);
            twoAPart = crossing(moved0, t, OBJECT_TWO_A, on.geometric_normal);
        }
        if twoBPart.t <= rest.t_min {
            let t = sphere(moved0, vec3f(0.45, -0.45, 1.1), 0.24);
            let on = sphereSurface(pointAt(moved0, t), vec3f(0.45, -0.45, 1.1), 0.24);
            twoBPart = crossing(moved0, t, OBJECT_TWO_B, on.geometric_normal);
        }
        if threeAPart.t <= rest.t_min {
            let t = sphere(moved0, vec3f(1.1, 0.5, -0.5), 0.24);
            let on = sphereSurface(pointAt(moved0, t), vec3f(1.1, 0.5, -0.5), 0.24);
            threeAPart = crossing(moved0, t, OBJECT_THREE_A, on.geometric_normal);
        }
        if threeBPart.t <= rest.t_min {
            let t = sphere(moved0, vec3f(1.1, 0.0, 0.0), 0.24);
            let on = sphereSurface(pointAt(moved0, t), vec3f(1.1, 0.0, 0.0), 0.24);
            threeBPart = crossing(moved0, t, OBJECT_THREE_B, on.geometric_normal);
        }
        if threeCPart.t <= rest.t_min {
            let t = sphere(moved0, vec3f(1.1, -0.5, 0.5), 0.24);
            let on = sphereSurface(pointAt(moved0, t), vec3f(1.1, -0.5, 0.5), 0.24);
            threeCPart = crossing(moved0, t, OBJECT_THREE_C, on.geometric_normal);
        }
        let t = min(
            min(
                min(min(min(min(cubePart.t, onePart.t), twoAPart.t), twoBPart.t), threeAPart.t),
                threeBPart.t,
            ),
            threeCPart.t,
        );
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        let cubeTurns = cubePart.t <= rest.t_min;
        let oneTurns = onePart.t <= rest.t_min;
        let twoATurns = twoAPart.t <= rest.t_min;
        let twoBTurns = twoBPart.t <= rest.t_min;
        let threeATurns = threeAPart.t <= rest.t_min;
        let threeBTurns = threeBPart.t <= rest.t_min;
        let threeCTurns = threeCPart.t <= rest.t_min;
        let before = cubePart.leaves
            && !onePart.leaves
            && !twoAPart.leaves
            && !twoBPart.leaves
            && !threeAPart.leaves
            && !threeBPart.leaves
            && !threeCPart.leaves;
        let behind = cubePart.leaves != cubeTurns
            && onePart.leaves == oneTurns
            && twoAPart.leaves == twoATurns
            && twoBPart.leaves == twoBTurns
            && threeAPart.leaves == threeATurns
            && threeBPart.leaves == threeBTurns
            && threeCPart.leaves == threeCTurns;
        if before != behind {
            return Crossing(
                t,
                select(
                    select(
                        select(
                            select(
                                select(
                                    select(threeCPart.object, threeBPart.object, threeBTurns),
                                    threeAPart.object,
                                    threeATurns,
                                ),
                                twoBPart.object,
                                twoBTurns,
                            ),
                            twoAPart.object,
                            twoATurns,
                        ),
                        onePart.object,
                        oneTurns,
                    ),
                    cubePart.object,
                    cubeTurns,
                ),
                before,
            );
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// "cube": Intersection()
fn cubeSolid(ray: Ray) -> Crossing {
    var rest = ray;
    var moved0 = rayInto(
        Space(
            vec4f(0.88294756, 0.0, -0.46947157, 1.8653891),
            vec4f(0.0, 1.0, 0.0, -1.0),
            vec4f(0.46947157, 0.0, 0.88294756, 0.5388169),
        ),
        ray,
    );
    var roundedBox0Part = notAsked();
    var sphere1Part = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if roundedBox0Part.t <= rest.t_min {
            let t = roundedBox(moved0, vec3f(-1.0), vec3f(1.0), 0.12);
            let on = roundedBoxSurface(pointAt(moved0, t), vec3f(-1.0), vec3f(1.0), 0.12);
            roundedBox0Part = crossing(moved0, t, OBJECT_CUBE_ROUNDEDBOX_0, on.geometric_normal);
        }
        if sphere1Part.t <= rest.t_min {
            let t = sphere(moved0, vec3f(0.0), 1.5);
            let on = sphereSurface(pointAt(moved0, t), vec3f(0.0), 1.5);
            sphere1Part = crossing(moved0, t, OBJECT_CUBE_SPHERE_1, on.geometric_normal);
        }
        let t = min(roundedBox0Part.t, sphere1Part.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        let roundedBox0Turns = roundedBox0Part.t <= rest.t_min;
        let sphere1Turns = sphere1Part.t <= rest.t_min;
        let before = roundedBox0Part.leaves && sphere1Part.leaves;
        let behind = roundedBox0Part.leaves != roundedBox0Turns
            && sphere1Part.leaves != sphere1Turns;
        if before != behind {
            return Crossing(
                t,
                select(sphere1Part.object, roundedBox0Part.object, roundedBox0Turns),
                before,
            );
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// "mug": Union(translate: (0.7, 0, -1.4), rotate_deg: (0, -35, 0))
fn mugSolid(ray: Ray) -> Crossing {
    var rest = ray;
    var cupPart = notAsked();
    var handlePart = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if cupPart.t <= rest.t_min {
            cupPart = cupSolid(rest);
        }
        if handlePart.t <= rest.t_min {
            handlePart = handleSolid(rest);
        }
        let t = min(cupPart.t, handlePart.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        let cupTurns = cupPart.t <= rest.t_min;
        let handleTurns = handlePart.t <= rest.t_min;
        let before = cupPart.leaves || handlePart.leaves;
        let behind = cupPart.leaves != cupTurns || handlePart.leaves != handleTurns;
        if before != behind {
            return Crossing(t, select(handlePart.object, cupPart.object, cupTurns), before);
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// "cup": Difference()
fn cupSolid(ray: Ray) -> Crossing {
    var rest = ray;
    var moved0 = rayInto(
        Space(
            vec4f(0.81915206, 0.0, 0.57357645, 0.22960058),
            vec4f(0.0, 1.0, 0.0, 0.0),
            vec4f(-0.57357645, 0.0, 0.81915206, 1.5483164),
        ),
        ray,
    );
    var roundedCylinder0Part = notAsked();
    var hollowPart = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if roundedCylinder0Part.t <= rest.t_min {
            let t = roundedCylinder(moved0, vec3f(0.0), vec3f(0.0, 1.9, 0.0), 0.85, 0.06);
            let on = roundedCylinderSurface(
                pointAt(moved0, t),
                vec3f(0.0),
                vec3f(0.0, 1.9, 0.0),
                0.85,
                0.06,
            );
            roundedCylinder0Part = crossing(
                moved0,
                t,
                OBJECT_CUP_ROUNDEDCYLINDER_0,
                on.geometric_normal,
            );
        }
        if hollowPart.t <= rest.t_min {
            let t = roundedCylinder(moved0, vec3f(0.0, 0.12, 0.0), vec3f(0.0, 3.0, 0.0), 0.74, 0.1);
            let on = roundedCylinderSurface(
                pointAt(moved0, t),
                vec3f(0.0, 0.12, 0.0),
                vec3f(0.0, 3.0, 0.0),
                0.74,
                0.1,
            );
            hollowPart = crossing(moved0, t, OBJECT_HOLLOW, on.geometric_normal);
        }
        let t = min(roundedCylinder0Part.t, hollowPart.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        let roundedCylinder0Turns = roundedCylinder0Part.t <= rest.t_min;
        let hollowTurns = hollowPart.t <= rest.t_min;
        let before = roundedCylinder0Part.leaves && !hollowPart.leaves;
        let behind = roundedCylinder0Part.leaves != roundedCylinder0Turns
            && hollowPart.leaves == hollowTurns;
        if before != behind {
            return Crossing(
                t,
                select(hollowPart.object, roundedCylinder0Part.object, roundedCylinder0Turns),
                before,
            );
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// "handle": Difference()
fn handleSolid(ray: Ray) -> Crossing {
    var rest = ray;
    var moved0 = rayInto(
        Space(
            vec4f(0.81915206, 0.0, 0.57357645, 0.22960058),
            vec4f(0.0, 1.0, 0.0, 0.0),
            vec4f(-0.57357645, 0.0, 0.81915206, 1.5483164),
        ),
        ray,
    );
    var ringPart = notAsked();
    var insidePart = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if ringPart.t <= rest.t_min {
            let t = torus(moved0, vec3f(0.85, 0.95, 0.0), vec3f(0.0, 0.0, 1.0), 0.48, 0.1);
            let on = torusSurface(
                pointAt(moved0, t),
                vec3f(0.85, 0.95, 0.0),
                vec3f(0.0, 0.0, 1.0),
                0.48,
                0.1,
            );
            ringPart = crossing(moved0, t, OBJECT_RING, on.geometric_normal);
        }
        if insidePart.t <= rest.t_min {
            let t = cylinder(moved0, vec3f(0.0, -1.0, 0.0), vec3f(0.0, 3.0, 0.0), 0.8);
            let on = cylinderSurface(
                pointAt(moved0, t),
                vec3f(0.0, -1.0, 0.0),
                vec3f(0.0, 3.0, 0.0),
                0.8,
            );
            insidePart = crossing(moved0, t, OBJECT_INSIDE, on.geometric_normal);
        }
        let t = min(ringPart.t, insidePart.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        let ringTurns = ringPart.t <= rest.t_min;
        let insideTurns = insidePart.t <= rest.t_min;
        let before = ringPart.leaves && !insidePart.leaves;
        let behind = ringPart.leaves != ringTurns && insidePart.leaves == insideTurns;
        if before != behind {
            return Crossing(t, select(insidePart.object, ringPart.object, ringTurns), before);
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// "nut": Difference(translate: (0.35, 0, 1.7), rotate_deg: (0, 15, 0))
fn nutSolid(ray: Ray) -> Crossing {
    var rest = ray;
    var moved0 = rayInto(
        Space(
            vec4f(0.9659258, 0.0, -0.25881904, 0.10191834),
            vec4f(0.0, 1.0, 0.0, 0.0),
            vec4f(0.25881904, 0.0, 0.9659258, -1.7326605),
        ),
        ray,
    );
    var blankPart = notAsked();
    var borePart = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if blankPart.t <= rest.t_min {
            blankPart = blankSolid(rest);
        }
        if borePart.t <= rest.t_min {
            let t = cylinder(moved0, vec3f(0.0, -1.0, 0.0), vec3f(0.0, 2.0, 0.0), 0.42);
            let on = cylinderSurface(
                pointAt(moved0, t),
                vec3f(0.0, -1.0, 0.0),
                vec3f(0.0, 2.0, 0.0),
                0.42,
            );
            borePart = crossing(moved0, t, OBJECT_BORE, on.geometric_normal);
        }
        let t = min(blankPart.t, borePart.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        let blankTurns = blankPart.t <= rest.t_min;
        let boreTurns = borePart.t <= rest.t_min;
        let before = blankPart.leaves && !borePart.leaves;
        let behind = blankPart.leaves != blankTurns && borePart.leaves == boreTurns;
        if before != behind {
            return Crossing(t, select(borePart.object, blankPart.object, blankTurns), before);
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// "blank": Intersection()
fn blankSolid(ray: Ray) -> Crossing {
    var rest = ray;
    var moved0 = rayInto(
        Space(
            vec4f(0.9659258, 0.0, -0.25881904, 0.10191834),
            vec4f(0.0, 1.0, 0.0, 0.0),
            vec4f(0.25881904, 0.0, 0.9659258, -1.7326605),
        ),
        ray,
    );
    var hexPrism0Part = notAsked();
    var turnedPart = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if hexPrism0Part.t <= rest.t_min {
            let t = hexPrism(moved0, vec3f(0.0, 0.3, 0.0), vec3f(0.0, 1.0, 0.0), 0.8, 0.6);
            let on = hexPrismSurface(
                pointAt(moved0, t),
                vec3f(0.0, 0.3, 0.0),
                vec3f(0.0, 1.0, 0.0),
                0.8,
                0.6,
            );
            hexPrism0Part = crossing(moved0, t, OBJECT_BLANK_HEXPRISM_0, on.geometric_normal);
        }
        if turnedPart.t <= rest.t_min {
            let t = sphere(moved0, vec3f(0.0, 0.3, 0.0), 0.82);
            let on = sphereSurface(pointAt(moved0, t), vec3f(0.0, 0.3, 0.0), 0.82);
            turnedPart = crossing(moved0, t, OBJECT_TURNED, on.geometric_normal);
        }
        let t = min(hexPrism0Part.t, turnedPart.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        let hexPrism0Turns = hexPrism0Part.t <= rest.t_min;
        let turnedTurns = turnedPart.t <= rest.t_min;
        let before = hexPrism0Part.leaves && turnedPart.leaves;
        let behind = hexPrism0Part.leaves != hexPrism0Turns && turnedPart.leaves != turnedTurns;
        if before != behind {
            return Crossing(
                t,
                select(turnedPart.object, hexPrism0Part.object, hexPrism0Turns),
                before,
            );
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// "lens": Intersection(translate: (2.6, 0.95, 0.6), rotate_deg: (0, 52, 0), casts_shadow: false)
fn lensSolid(ray: Ray) -> Crossing {
    var rest = ray;
    var moved0 = rayInto(
        Space(
            vec4f(0.6156615, 0.0, -0.7880108, -1.1279134),
            vec4f(0.0, 1.0, 0.0, -0.95),
            vec4f(0.7880108, 0.0, 0.6156615, -2.4182248),
        ),
        ray,
    );
    var frontPart = notAsked();
    var backPart = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if frontPart.t <= rest.t_min {
            let t = sphere(moved0, vec3f(0.0, 0.0, 1.1), 1.45);
            let on = sphereSurface(pointAt(moved0, t), vec3f(0.0, 0.0, 1.1), 1.45);
            frontPart = crossing(moved0, t, OBJECT_FRONT, on.geometric_normal);
        }
        if backPart.t <= rest.t_min {
            let t = sphere(moved0, vec3f(0.0, 0.0, -1.1), 1.45);
            let on = sphereSurface(pointAt(moved0, t), vec3f(0.0, 0.0, -1.1), 1.45);
            backPart = crossing(moved0, t, OBJECT_BACK, on.geometric_normal);
        }
        let t = min(frontPart.t, backPart.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        let frontTurns = frontPart.t <= rest.t_min;
        let backTurns = backPart.t <= rest.t_min;
        let before = frontPart.leaves && backPart.leaves;
        let behind = frontPart.leaves != frontTurns && backPart.leaves != backTurns;
        if before != behind {
            return Crossing(t, select(backPart.object, frontPart.object, frontTurns), before);
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    var its_surface: Placed;
    switch object {
        case OBJECT_TABLE: {
            its_surface = placed(planeSurface(p, vec3f(0.0, 1.0, 0.0), 0.0), p);
        }
        case OBJECT_CUBE_ROUNDEDBOX_0: {
            let space = Space(
                vec4f(0.88294756, 0.0, -0.46947157, 1.8653891),
                vec4f(0.0, 1.0, 0.0, -1.0),
                vec4f(0.46947157, 0.0, 0.88294756, 0.5388169),
            );
            its_surface = placedFrom(
                space,
                roundedBoxSurface(pointInto(space, p), vec3f(-1.0), vec3f(1.0), 0.12),
                p,
            );
        }
        case OBJECT_CUBE_SPHERE_1: {
            let space = Space(
                vec4f(0.88294756, 0.0, -0.46947157, 1.8653891),
                vec4f(0.0, 1.0, 0.0, -1.0),
                vec4f(0.46947157, 0.0, 0.88294756, 0.5388169),
            );
            its_surface = placedFrom(space, sphereSurface(pointInto(space, p), vec3f(0.0), 1.5), p);
        }
        case OBJECT_ONE: {
            let space = Space(
                vec4f(0.88294756, 0.0, -0.46947157, 1.8653891),
                vec4f(0.0, 1.0, 0.0, -1.0),
                vec4f(0.46947157, 0.0, 0.88294756, 0.5388169),
            );
            its_surface = placedFrom(
                space,
                inverted(sphereSurface(pointInto(space, p), vec3f(0.0, 1.12, 0.0), 0.32)),
                p,
            );
        }
        case OBJECT_TWO_A: {
            let space = Space(
                vec4f(0.88294756, 0.0, -0.46947157, 1.8653891),
                vec4f(0.0, 1.0, 0.0, -1.0),
                vec4f(0.46947157, 0.0, 0.88294756, 0.5388169),
            );
            its_surface = placedFrom(
                space,
                inverted(sphereSurface(pointInto(space, p), vec3f(-0.45, 0.45, 1.1), 0.24)),
                p,
            );
        }
        case OBJECT_TWO_B: {
            let space = Space(
                vec4f(0.88294756, 0.0, -0.46947157, 1.8653891),
                vec4f(0.0, 1.0, 0.0, -1.0),
                vec4f(0.46947157, 0.0, 0.88294756, 0.5388169),
            );
            its_surface = placedFrom(
                space,
                inverted(sphereSurface(pointInto(space, p), vec3f(0.45, -0.45, 1.1), 0.24)),
                p,
            );
        }
        case OBJECT_THREE_A: {
            let space = Space(
                vec4f(0.88294756, 0.0, -0.46947157, 1.8653891),
                vec4f(0.0, 1.0, 0.0, -1.0),
                vec4f(0.46947157, 0.0, 0.88294756, 0.5388169),
            );
            its_surface = placedFrom(
                space,
                inverted(sphereSurface(pointInto(space, p), vec3f(1.1, 0.5, -0.5), 0.24)),
                p,
            );
        }
        case OBJECT_THREE_B: {
            let space = Space(
                vec4f(0.88294756, 0.0, -0.46947157, 1.8653891),
                vec4f(0.0, 1.0, 0.0, -1.0),
                vec4f(0.46947157, 0.0, 0.88294756, 0.5388169),
            );
            its_surface = placedFrom(
                space,
                inverted(sphereSurface(pointInto(space, p), vec3f(1.1, 0.0, 0.0), 0.24)),
                p,
            );
        }
        case OBJECT_THREE_C: {
            let space = Space(
                vec4f(0.88294756, 0.0, -0.46947157, 1.8653891),
                vec4f(0.0, 1.0, 0.0, -1.0),
                vec4f(0.46947157, 0.0, 0.88294756, 0.5388169),
            );
            its_surface = placedFrom(
                space,
                inverted(sphereSurface(pointInto(space, p), vec3f(1.1, -0.5, 0.5), 0.24)),
                p,
            );
        }
        case OBJECT_CUP_ROUNDEDCYLINDER_0: {
            let space = Space(
                vec4f(0.81915206, 0.0, 0.57357645, 0.22960058),
                vec4f(0.0, 1.0, 0.0, 0.0),
                vec4f(-0.57357645, 0.0, 0.81915206, 1.5483164),
            );
            its_surface = placedFrom(
                space,
                roundedCylinderSurface(
                    pointInto(space, p),
                    vec3f(0.0),
                    vec3f(0.0, 1.9, 0.0),
                    0.85,
                    0.06,
                ),
                p,
            );
        }
        case OBJECT_HOLLOW: {
            let space = Space(
                vec4f(0.81915206, 0.0, 0.57357645, 0.22960058),
                vec4f(0.0, 1.0, 0.0, 0.0),
                vec4f(-0.57357645, 0.0, 0.81915206, 1.5483164),
            );
            its_surface = placedFrom(
                space,
                inverted(
                    roundedCylinderSurface(
                        pointInto(space, p),
                        vec3f(0.0, 0.12, 0.0),
                        vec3f(0.0, 3.0, 0.0),
                        0.74,
                        0.1,
                    ),
                ),
                p,
            );
        }
        case OBJECT_RING: {
            let space = Space(
                vec4f(0.81915206, 0.0, 0.57357645, 0.22960058),
                vec4f(0.0, 1.0, 0.0, 0.0),
                vec4f(-0.57357645, 0.0, 0.81915206, 1.5483164),
            );
            its_surface = placedFrom(
                space,
                torusSurface(
                    pointInto(space, p),
                    vec3f(0.85, 0.95, 0.0),
                    vec3f(0.0, 0.0, 1.0),
                    0.48,
                    0.1,
                ),
                p,
            );
        }
        case OBJECT_INSIDE: {
            let space = Space(
                vec4f(0.81915206, 0.0, 0.57357645, 0.22960058),
                vec4f(0.0, 1.0, 0.0, 0.0),
                vec4f(-0.57357645, 0.0, 0.81915206, 1.5483164),
            );
            its_surface = placedFrom(
                space,
                inverted(
                    cylinderSurface(
                        pointInto(space, p),
                        vec3f(0.0, -1.0, 0.0),
                        vec3f(0.0, 3.0, 0.0),
                        0.8,
                    ),
                ),
                p,
            );
        }
        case OBJECT_BLANK_HEXPRISM_0: {
            let space = Space(
                vec4f(0.9659258, 0.0, -0.25881904, 0.10191834),
                vec4f(0.0, 1.0, 0.0, 0.0),
                vec4f(0.25881904, 0.0, 0.9659258, -1.7326605),
            );
            its_surface = placedFrom(
                space,
                hexPrismSurface(
                    pointInto(space, p),
                    vec3f(0.0, 0.3, 0.0),
                    vec3f(0.0, 1.0, 0.0),
                    0.8,
                    0.6,
                ),
                p,
            );
        }
        case OBJECT_TURNED: {
            let space = Space(
                vec4f(0.9659258, 0.0, -0.25881904, 0.10191834),
                vec4f(0.0, 1.0, 0.0, 0.0),
                vec4f(0.25881904, 0.0, 0.9659258, -1.7326605),
            );
            its_surface = placedFrom(
                space,
                sphereSurface(pointInto(space, p), vec3f(0.0, 0.3, 0.0), 0.82),
                p,
            );
        }
        case OBJECT_BORE: {
            let space = Space(
                vec4f(0.9659258, 0.0, -0.25881904, 0.10191834),
                vec4f(0.0, 1.0, 0.0, 0.0),
                vec4f(0.25881904, 0.0, 0.9659258, -1.7326605),
            );
            its_surface = placedFrom(
                space,
                inverted(
                    cylinderSurface(
                        pointInto(space, p),
                        vec3f(0.0, -1.0, 0.0),
                        vec3f(0.0, 2.0, 0.0),
                        0.42,
                    ),
                ),
                p,
            );
        }
        case OBJECT_FRONT: {
            let space = Space(
                vec4f(0.6156615, 0.0, -0.7880108, -1.1279134),
                vec4f(0.0, 1.0, 0.0, -0.95),
                vec4f(0.7880108, 0.0, 0.6156615, -2.4182248),
            );
            its_surface = placedFrom(
                space,
                sphereSurface(pointInto(space, p), vec3f(0.0, 0.0, 1.1), 1.45),
                p,
            );
        }
        case OBJECT_BACK: {
            let space = Space(
                vec4f(0.6156615, 0.0, -0.7880108, -1.1279134),
                vec4f(0.0, 1.0, 0.0, -0.95),
                vec4f(0.7880108, 0.0, 0.6156615, -2.4182248),
            );
            its_surface = placedFrom(
                space,
                sphereSurface(pointInto(space, p), vec3f(0.0, 0.0, -1.1), 1.45),
                p,
            );
        }
        default: {
            its_surface = placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p);
        }
    }
    return its_surface;
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_CUBE_ROUNDEDBOX_0, OBJECT_CUBE_SPHERE_1: { return ivoryMaterial(at); }
        case OBJECT_ONE,
             OBJECT_TWO_A,
             OBJECT_TWO_B,
             OBJECT_THREE_A,
             OBJECT_THREE_B,
             OBJECT_THREE_C: { return inkMaterial(at); }
        case OBJECT_BLANK_HEXPRISM_0, OBJECT_TURNED, OBJECT_BORE: { return steelMaterial(at); }
        case OBJECT_TABLE: { return tableMaterial(at); }
        case OBJECT_CUP_ROUNDEDCYLINDER_0,
             OBJECT_HOLLOW,
             OBJECT_RING,
             OBJECT_INSIDE: { return mugMaterial(at); }
        case OBJECT_FRONT, OBJECT_BACK: { return lensMaterial(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

fn ivoryMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.8631572, 0.791298, 0.6444797));
    material.specular = 0.4;
    material.shininess = 80.0;
    return material;
}

fn inkMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.023153368, 0.020288564, 0.029556835));
    material.specular = 0.3;
    return material;
}

fn steelMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.32314324, 0.3712377, 0.4178851));
    material.specular = 0.8;
    material.shininess = 120.0;
    material.reflectivity = 0.25;
    return material;
}

fn tableMaterial(at: Surface) -> Material {
    var material = matte(
        wood(
            at,
            0.8,
            vec3f(1.0, 0.12, 0.06),
            0.5,
            0.4,
            vec3f(0.57112485, 0.32314324, 0.12477182),
            vec3f(0.20507874, 0.068478175, 0.017641956),
        ),
    );
    material.reflectivity = 0.04;
    material.fresnel = 5.0;
    return material;
}

fn mugMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.049706567, 0.15896083, 0.27467734));
    material.specular = 0.5;
    material.reflectivity = 0.05;
    material.fresnel = 5.0;
    return material;
}

fn lensMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.02));
    material.specular = 0.6;
    material.reflectivity = 0.04;
    material.fresnel = 5.0;
    material.transmission = 1.0;
    material.ior = 1.5;
    return material;
}

/// Whether the material of `object` varies over its surface.
fn isTextured(object: u32) -> bool {
    switch object {
        case OBJECT_TABLE: { return true; }
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
        vec3f(0.21223076, 0.36625263, 0.62396044),
        vec3f(0.8549926, 0.8879231, 0.92158186),
    );
}

fn ambientLight() -> vec3f {
    return vec3f(0.25);
}

/// The light `index` as the world point `p` sees it.
fn lightAt(index: u32, p: vec3f) -> Light {
    switch index {
        // lights[0]: Point(position: (-5, 9, 6), radius: 0.6, color: "#fff3e0", intensity: 0.85)
        case 0u: { return pointLight(
            p,
            vec3f(-5.0, 9.0, 6.0),
            0.6,
            vec3f(0.85, 0.761829, 0.6335936),
        ); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
