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
    hit = nearer(hit, tableCrossing(ray), OBJECT_TABLE);
    hit = nearerCrossing(hit, dieSolid(ray));
    hit = nearerCrossing(hit, mugSolid(ray));
    hit = nearerCrossing(hit, nutSolid(ray));
    hit = nearerCrossing(hit, lensSolid(ray));
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if tableCrossing(ray) < NO_HIT { return true; }
    if dieSolid(ray).t < NO_HIT { return true; }
    if mugSolid(ray).t < NO_HIT { return true; }
    if nutSolid(ray).t < NO_HIT { return true; }
    return false;
}

/// objects[0] "table": Plane()
fn tableCrossing(ray: Ray) -> f32 {
    return plane(ray, vec3f(0.0, 1.0, 0.0), 0.0);
}

fn tableSurfaceAt(p: vec3f) -> Surface {
    return planeSurface(p, vec3f(0.0, 1.0, 0.0), 0.0);
}

/// "cube RoundedBox 0": RoundedBox(radius: 0.12)
fn cubeRoundedBox0Crossing(ray: Ray) -> f32 {
    return roundedBox(ray, vec3f(-1.0), vec3f(1.0), 0.12);
}

fn cubeRoundedBox0SurfaceAt(p: vec3f) -> Surface {
    return roundedBoxSurface(p, vec3f(-1.0), vec3f(1.0), 0.12);
}

fn cubeRoundedBox0Space() -> Space {
    return Space(
        vec4f(0.88294756, 0.0, -0.46947157, 1.8653891),
        vec4f(0.0, 1.0, 0.0, -1.0),
        vec4f(0.46947157, 0.0, 0.88294756, 0.5388169),
    );
}

/// "cube Sphere 1": Sphere(radius: 1.5)
fn cubeSphere1Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 1.5);
}

fn cubeSphere1SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 1.5);
}

fn cubeSphere1Space() -> Space {
    return Space(
        vec4f(0.88294756, 0.0, -0.46947157, 1.8653891),
        vec4f(0.0, 1.0, 0.0, -1.0),
        vec4f(0.46947157, 0.0, 0.88294756, 0.5388169),
    );
}

/// "one": Sphere(center: (0, 1.12, 0), radius: 0.32)
fn oneCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0, 1.12, 0.0), 0.32);
}

fn oneSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0, 1.12, 0.0), 0.32);
}

fn oneSpace() -> Space {
    return Space(
        vec4f(0.88294756, 0.0, -0.46947157, 1.8653891),
        vec4f(0.0, 1.0, 0.0, -1.0),
        vec4f(0.46947157, 0.0, 0.88294756, 0.5388169),
    );
}

/// "two a": Sphere(center: (-0.45, 0.45, 1.1), radius: 0.24)
fn twoACrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(-0.45, 0.45, 1.1), 0.24);
}

fn twoASurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(-0.45, 0.45, 1.1), 0.24);
}

fn twoASpace() -> Space {
    return Space(
        vec4f(0.88294756, 0.0, -0.46947157, 1.8653891),
        vec4f(0.0, 1.0, 0.0, -1.0),
        vec4f(0.46947157, 0.0, 0.88294756, 0.5388169),
    );
}

/// "two b": Sphere(center: (0.45, -0.45, 1.1), radius: 0.24)
fn twoBCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.45, -0.45, 1.1), 0.24);
}

fn twoBSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.45, -0.45, 1.1), 0.24);
}

fn twoBSpace() -> Space {
    return Space(
        vec4f(0.88294756, 0.0, -0.46947157, 1.8653891),
        vec4f(0.0, 1.0, 0.0, -1.0),
        vec4f(0.46947157, 0.0, 0.88294756, 0.5388169),
    );
}

/// "three a": Sphere(center: (1.1, 0.5, -0.5), radius: 0.24)
fn threeACrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(1.1, 0.5, -0.5), 0.24);
}

fn threeASurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(1.1, 0.5, -0.5), 0.24);
}

fn threeASpace() -> Space {
    return Space(
        vec4f(0.88294756, 0.0, -0.46947157, 1.8653891),
        vec4f(0.0, 1.0, 0.0, -1.0),
        vec4f(0.46947157, 0.0, 0.88294756, 0.5388169),
    );
}

/// "three b": Sphere(center: (1.1, 0, 0), radius: 0.24)
fn threeBCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(1.1, 0.0, 0.0), 0.24);
}

fn threeBSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(1.1, 0.0, 0.0), 0.24);
}

fn threeBSpace() -> Space {
    return Space(
        vec4f(0.88294756, 0.0, -0.46947157, 1.8653891),
        vec4f(0.0, 1.0, 0.0, -1.0),
        vec4f(0.46947157, 0.0, 0.88294756, 0.5388169),
    );
}

/// "three c": Sphere(center: (1.1, -0.5, 0.5), radius: 0.24)
fn threeCCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(1.1, -0.5, 0.5), 0.24);
}

fn threeCSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(1.1, -0.5, 0.5), 0.24);
}

fn threeCSpace() -> Space {
    return Space(
        vec4f(0.88294756, 0.0, -0.46947157, 1.8653891),
        vec4f(0.0, 1.0, 0.0, -1.0),
        vec4f(0.46947157, 0.0, 0.88294756, 0.5388169),
    );
}

/// "cup RoundedCylinder 0": RoundedCylinder(top: (0, 1.9, 0), radius: 0.85, rounding: 0.06)
fn cupRoundedCylinder0Crossing(ray: Ray) -> f32 {
    return roundedCylinder(ray, vec3f(0.0), vec3f(0.0, 1.9, 0.0), 0.85, 0.06);
}

fn cupRoundedCylinder0SurfaceAt(p: vec3f) -> Surface {
    return roundedCylinderSurface(p, vec3f(0.0), vec3f(0.0, 1.9, 0.0), 0.85, 0.06);
}

fn cupRoundedCylinder0Space() -> Space {
    return Space(
        vec4f(0.81915206, 0.0, 0.57357645, 0.22960058),
        vec4f(0.0, 1.0, 0.0, 0.0),
        vec4f(-0.57357645, 0.0, 0.81915206, 1.5483164),
    );
}

/// "hollow": RoundedCylinder(base: (0, 0.12, 0), top: (0, 3, 0), radius: 0.74, rounding: 0.1)
fn hollowCrossing(ray: Ray) -> f32 {
    return roundedCylinder(ray, vec3f(0.0, 0.12, 0.0), vec3f(0.0, 3.0, 0.0), 0.74, 0.1);
}

fn hollowSurfaceAt(p: vec3f) -> Surface {
    return roundedCylinderSurface(p, vec3f(0.0, 0.12, 0.0), vec3f(0.0, 3.0, 0.0), 0.74, 0.1);
}

fn hollowSpace() -> Space {
    return Space(
        vec4f(0.81915206, 0.0, 0.57357645, 0.22960058),
        vec4f(0.0, 1.0, 0.0, 0.0),
        vec4f(-0.57357645, 0.0, 0.81915206, 1.5483164),
    );
}

/// "ring": Torus(center: (0.85, 0.95, 0), axis: (0, 0, 1), major_radius: 0.48, minor_radius: 0.1)
fn ringCrossing(ray: Ray) -> f32 {
    return torus(ray, vec3f(0.85, 0.95, 0.0), vec3f(0.0, 0.0, 1.0), 0.48, 0.1);
}

fn ringSurfaceAt(p: vec3f) -> Surface {
    return torusSurface(p, vec3f(0.85, 0.95, 0.0), vec3f(0.0, 0.0, 1.0), 0.48, 0.1);
}

fn ringSpace() -> Space {
    return Space(
        vec4f(0.81915206, 0.0, 0.57357645, 0.22960058),
        vec4f(0.0, 1.0, 0.0, 0.0),
        vec4f(-0.57357645, 0.0, 0.81915206, 1.5483164),
    );
}

/// "inside": Cylinder(base: (0, -1, 0), top: (0, 3, 0), radius: 0.8)
fn insideCrossing(ray: Ray) -> f32 {
    return cylinder(ray, vec3f(0.0, -1.0, 0.0), vec3f(0.0, 3.0, 0.0), 0.8);
}

fn insideSurfaceAt(p: vec3f) -> Surface {
    return cylinderSurface(p, vec3f(0.0, -1.0, 0.0), vec3f(0.0, 3.0, 0.0), 0.8);
}

fn insideSpace() -> Space {
    return Space(
        vec4f(0.81915206, 0.0, 0.57357645, 0.22960058),
        vec4f(0.0, 1.0, 0.0, 0.0),
        vec4f(-0.57357645, 0.0, 0.81915206, 1.5483164),
    );
}

/// "blank HexPrism 0": HexPrism(center: (0, 0.3, 0), radius: 0.8, height: 0.6)
fn blankHexPrism0Crossing(ray: Ray) -> f32 {
    return hexPrism(ray, vec3f(0.0, 0.3, 0.0), vec3f(0.0, 1.0, 0.0), 0.8, 0.6);
}

fn blankHexPrism0SurfaceAt(p: vec3f) -> Surface {
    return hexPrismSurface(p, vec3f(0.0, 0.3, 0.0), vec3f(0.0, 1.0, 0.0), 0.8, 0.6);
}

fn blankHexPrism0Space() -> Space {
    return Space(
        vec4f(0.9659258, 0.0, -0.25881904, 0.10191834),
        vec4f(0.0, 1.0, 0.0, 0.0),
        vec4f(0.25881904, 0.0, 0.9659258, -1.7326605),
    );
}

/// "turned": Sphere(center: (0, 0.3, 0), radius: 0.82)
fn turnedCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0, 0.3, 0.0), 0.82);
}

fn turnedSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0, 0.3, 0.0), 0.82);
}

fn turnedSpace() -> Space {
    return Space(
        vec4f(0.9659258, 0.0, -0.25881904, 0.10191834),
        vec4f(0.0, 1.0, 0.0, 0.0),
        vec4f(0.25881904, 0.0, 0.9659258, -1.7326605),
    );
}

/// "bore": Cylinder(base: (0, -1, 0), top: (0, 2, 0), radius: 0.42)
fn boreCrossing(ray: Ray) -> f32 {
    return cylinder(ray, vec3f(0.0, -1.0, 0.0), vec3f(0.0, 2.0, 0.0), 0.42);
}

fn boreSurfaceAt(p: vec3f) -> Surface {
    return cylinderSurface(p, vec3f(0.0, -1.0, 0.0), vec3f(0.0, 2.0, 0.0), 0.42);
}

fn boreSpace() -> Space {
    return Space(
        vec4f(0.9659258, 0.0, -0.25881904, 0.10191834),
        vec4f(0.0, 1.0, 0.0, 0.0),
        vec4f(0.25881904, 0.0, 0.9659258, -1.7326605),
    );
}

/// "front": Sphere(center: (0, 0, 1.1), radius: 1.45)
fn frontCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0, 0.0, 1.1), 1.45);
}

fn frontSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0, 0.0, 1.1), 1.45);
}

fn frontSpace() -> Space {
    return Space(
        vec4f(0.6156615, 0.0, -0.7880108, -1.1279134),
        vec4f(0.0, 1.0, 0.0, -0.95),
        vec4f(0.7880108, 0.0, 0.6156615, -2.4182248),
    );
}

/// "back": Sphere(center: (0, 0, -1.1), radius: 1.45)
fn backCrossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0, 0.0, -1.1), 1.45);
}

fn backSurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0, 0.0, -1.1), 1.45);
}

fn backSpace() -> Space {
    return Space(
        vec4f(0.6156615, 0.0, -0.7880108, -1.1279134),
        vec4f(0.0, 1.0, 0.0, -0.95),
        vec4f(0.7880108, 0.0, 0.6156615, -2.4182248),
    );
}

/// objects[1] "die": Difference(translate: (-1.9, 1, 0.4), rotate_deg: (0, 28, 0))
fn dieSolid(ray: Ray) -> Crossing {
    var rest = ray;
    var moved0 = rayInto(oneSpace(), ray);
    var cube_part = notAsked();
    var one_part = notAsked();
    var two_a_part = notAsked();
    var two_b_part = notAsked();
    var three_a_part = notAsked();
    var three_b_part = notAsked();
    var three_c_part = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if cube_part.t <= rest.t_min {
            cube_part = cubeSolid(rest);
        }
        if one_part.t <= rest.t_min {
            let t = oneCrossing(moved0);
            let on = oneSurfaceAt(pointAt(moved0, t));
            one_part = crossing(moved0, t, OBJECT_ONE, on.geometric_normal);
        }
        if two_a_part.t <= rest.t_min {
            let t = twoACrossing(moved0);
            let on = twoASurfaceAt(pointAt(moved0, t));
            two_a_part = crossing(moved0, t, OBJECT_TWO_A, on.geometric_normal);
        }
        if two_b_part.t <= rest.t_min {
            let t = twoBCrossing(moved0);
            let on = twoBSurfaceAt(pointAt(moved0, t));
            two_b_part = crossing(moved0, t, OBJECT_TWO_B, on.geometric_normal);
        }
        if three_a_part.t <= rest.t_min {
            let t = threeACrossing(moved0);
            let on = threeASurfaceAt(pointAt(moved0, t));
            three_a_part = crossing(moved0, t, OBJECT_THREE_A, on.geometric_normal);
        }
        if three_b_part.t <= rest.t_min {
            let t = threeBCrossing(moved0);
            let on = threeBSurfaceAt(pointAt(moved0, t));
            three_b_part = crossing(moved0, t, OBJECT_THREE_B, on.geometric_normal);
        }
        if three_c_part.t <= rest.t_min {
            let t = threeCCrossing(moved0);
            let on = threeCSurfaceAt(pointAt(moved0, t));
            three_c_part = crossing(moved0, t, OBJECT_THREE_C, on.geometric_normal);
        }
        let t = min(
            min(
                min(
                    min(min(min(cube_part.t, one_part.t), two_a_part.t), two_b_part.t),
                    three_a_part.t,
                ),
                three_b_part.t,
            ),
            three_c_part.t,
        );
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        let cube_turns = cube_part.t <= rest.t_min;
        let one_turns = one_part.t <= rest.t_min;
        let two_a_turns = two_a_part.t <= rest.t_min;
        let two_b_turns = two_b_part.t <= rest.t_min;
        let three_a_turns = three_a_part.t <= rest.t_min;
        let three_b_turns = three_b_part.t <= rest.t_min;
        let three_c_turns = three_c_part.t <= rest.t_min;
        let before = cube_part.leaves
            && !one_part.leaves
            && !two_a_part.leaves
            && !two_b_part.leaves
            && !three_a_part.leaves
            && !three_b_part.leaves
            && !three_c_part.leaves;
        let behind = cube_part.leaves != cube_turns
            && one_part.leaves == one_turns
            && two_a_part.leaves == two_a_turns
            && two_b_part.leaves == two_b_turns
            && three_a_part.leaves == three_a_turns
            && three_b_part.leaves == three_b_turns
            && three_c_part.leaves == three_c_turns;
        if before != behind {
            return Crossing(
                t,
                select(
                    select(
                        select(
                            select(
                                select(
                                    select(three_c_part.object, three_b_part.object, three_b_turns),
                                    three_a_part.object,
                                    three_a_turns,
                                ),
                                two_b_part.object,
                                two_b_turns,
                            ),
                            two_a_part.object,
                            two_a_turns,
                        ),
                        one_part.object,
                        one_turns,
                    ),
                    cube_part.object,
                    cube_turns,
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
    var moved0 = rayInto(cubeRoundedBox0Space(), ray);
    var roundedbox_0_part = notAsked();
    var sphere_1_part = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if roundedbox_0_part.t <= rest.t_min {
            let t = cubeRoundedBox0Crossing(moved0);
            let on = cubeRoundedBox0SurfaceAt(pointAt(moved0, t));
            roundedbox_0_part = crossing(moved0, t, OBJECT_CUBE_ROUNDEDBOX_0, on.geometric_normal);
        }
        if sphere_1_part.t <= rest.t_min {
            let t = cubeSphere1Crossing(moved0);
            let on = cubeSphere1SurfaceAt(pointAt(moved0, t));
            sphere_1_part = crossing(moved0, t, OBJECT_CUBE_SPHERE_1, on.geometric_normal);
        }
        let t = min(roundedbox_0_part.t, sphere_1_part.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        let roundedbox_0_turns = roundedbox_0_part.t <= rest.t_min;
        let sphere_1_turns = sphere_1_part.t <= rest.t_min;
        let before = roundedbox_0_part.leaves && sphere_1_part.leaves;
        let behind = roundedbox_0_part.leaves != roundedbox_0_turns
            && sphere_1_part.leaves != sphere_1_turns;
        if before != behind {
            return Crossing(
                t,
                select(sphere_1_part.object, roundedbox_0_part.object, roundedbox_0_turns),
                before,
            );
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// objects[2] "mug": Union(translate: (0.7, 0, -1.4), rotate_deg: (0, -35, 0))
fn mugSolid(ray: Ray) -> Crossing {
    var rest = ray;
    var cup_part = notAsked();
    var handle_part = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if cup_part.t <= rest.t_min {
            cup_part = cupSolid(rest);
        }
        if handle_part.t <= rest.t_min {
            handle_part = handleSolid(rest);
        }
        let t = min(cup_part.t, handle_part.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        let cup_turns = cup_part.t <= rest.t_min;
        let handle_turns = handle_part.t <= rest.t_min;
        let before = cup_part.leaves || handle_part.leaves;
        let behind = cup_part.leaves != cup_turns || handle_part.leaves != handle_turns;
        if before != behind {
            return Crossing(t, select(handle_part.object, cup_part.object, cup_turns), before);
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// "cup": Difference()
fn cupSolid(ray: Ray) -> Crossing {
    var rest = ray;
    var moved0 = rayInto(cupRoundedCylinder0Space(), ray);
    var roundedcylinder_0_part = notAsked();
    var hollow_part = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if roundedcylinder_0_part.t <= rest.t_min {
            let t = cupRoundedCylinder0Crossing(moved0);
            let on = cupRoundedCylinder0SurfaceAt(pointAt(moved0, t));
            roundedcylinder_0_part = crossing(
                moved0,
                t,
                OBJECT_CUP_ROUNDEDCYLINDER_0,
                on.geometric_normal,
            );
        }
        if hollow_part.t <= rest.t_min {
            let t = hollowCrossing(moved0);
            let on = hollowSurfaceAt(pointAt(moved0, t));
            hollow_part = crossing(moved0, t, OBJECT_HOLLOW, on.geometric_normal);
        }
        let t = min(roundedcylinder_0_part.t, hollow_part.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        let roundedcylinder_0_turns = roundedcylinder_0_part.t <= rest.t_min;
        let hollow_turns = hollow_part.t <= rest.t_min;
        let before = roundedcylinder_0_part.leaves && !hollow_part.leaves;
        let behind = roundedcylinder_0_part.leaves != roundedcylinder_0_turns
            && hollow_part.leaves == hollow_turns;
        if before != behind {
            return Crossing(
                t,
                select(hollow_part.object, roundedcylinder_0_part.object, roundedcylinder_0_turns),
                before,
            );
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// "handle": Difference()
fn handleSolid(ray: Ray) -> Crossing {
    var rest = ray;
    var moved0 = rayInto(ringSpace(), ray);
    var ring_part = notAsked();
    var inside_part = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if ring_part.t <= rest.t_min {
            let t = ringCrossing(moved0);
            let on = ringSurfaceAt(pointAt(moved0, t));
            ring_part = crossing(moved0, t, OBJECT_RING, on.geometric_normal);
        }
        if inside_part.t <= rest.t_min {
            let t = insideCrossing(moved0);
            let on = insideSurfaceAt(pointAt(moved0, t));
            inside_part = crossing(moved0, t, OBJECT_INSIDE, on.geometric_normal);
        }
        let t = min(ring_part.t, inside_part.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        let ring_turns = ring_part.t <= rest.t_min;
        let inside_turns = inside_part.t <= rest.t_min;
        let before = ring_part.leaves && !inside_part.leaves;
        let behind = ring_part.leaves != ring_turns && inside_part.leaves == inside_turns;
        if before != behind {
            return Crossing(t, select(inside_part.object, ring_part.object, ring_turns), before);
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// objects[3] "nut": Difference(translate: (0.35, 0, 1.7), rotate_deg: (0, 15, 0))
fn nutSolid(ray: Ray) -> Crossing {
    var rest = ray;
    var moved0 = rayInto(boreSpace(), ray);
    var blank_part = notAsked();
    var bore_part = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if blank_part.t <= rest.t_min {
            blank_part = blankSolid(rest);
        }
        if bore_part.t <= rest.t_min {
            let t = boreCrossing(moved0);
            let on = boreSurfaceAt(pointAt(moved0, t));
            bore_part = crossing(moved0, t, OBJECT_BORE, on.geometric_normal);
        }
        let t = min(blank_part.t, bore_part.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        let blank_turns = blank_part.t <= rest.t_min;
        let bore_turns = bore_part.t <= rest.t_min;
        let before = blank_part.leaves && !bore_part.leaves;
        let behind = blank_part.leaves != blank_turns && bore_part.leaves == bore_turns;
        if before != behind {
            return Crossing(t, select(bore_part.object, blank_part.object, blank_turns), before);
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// "blank": Intersection()
fn blankSolid(ray: Ray) -> Crossing {
    var rest = ray;
    var moved0 = rayInto(blankHexPrism0Space(), ray);
    var hexprism_0_part = notAsked();
    var turned_part = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if hexprism_0_part.t <= rest.t_min {
            let t = blankHexPrism0Crossing(moved0);
            let on = blankHexPrism0SurfaceAt(pointAt(moved0, t));
            hexprism_0_part = crossing(moved0, t, OBJECT_BLANK_HEXPRISM_0, on.geometric_normal);
        }
        if turned_part.t <= rest.t_min {
            let t = turnedCrossing(moved0);
            let on = turnedSurfaceAt(pointAt(moved0, t));
            turned_part = crossing(moved0, t, OBJECT_TURNED, on.geometric_normal);
        }
        let t = min(hexprism_0_part.t, turned_part.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        let hexprism_0_turns = hexprism_0_part.t <= rest.t_min;
        let turned_turns = turned_part.t <= rest.t_min;
        let before = hexprism_0_part.leaves && turned_part.leaves;
        let behind = hexprism_0_part.leaves != hexprism_0_turns
            && turned_part.leaves != turned_turns;
        if before != behind {
            return Crossing(
                t,
                select(turned_part.object, hexprism_0_part.object, hexprism_0_turns),
                before,
            );
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// objects[4] "lens": Intersection(translate: (2.6, 0.95, 0.6), rotate_deg: (0, 52, 0), casts_shad…
fn lensSolid(ray: Ray) -> Crossing {
    var rest = ray;
    var moved0 = rayInto(frontSpace(), ray);
    var front_part = notAsked();
    var back_part = notAsked();
    for (var i = 0u; i < MAX_CROSSINGS; i++) {
        if front_part.t <= rest.t_min {
            let t = frontCrossing(moved0);
            let on = frontSurfaceAt(pointAt(moved0, t));
            front_part = crossing(moved0, t, OBJECT_FRONT, on.geometric_normal);
        }
        if back_part.t <= rest.t_min {
            let t = backCrossing(moved0);
            let on = backSurfaceAt(pointAt(moved0, t));
            back_part = crossing(moved0, t, OBJECT_BACK, on.geometric_normal);
        }
        let t = min(front_part.t, back_part.t);
        if t >= NO_HIT { break; }
        rest.t_min = sameUpTo(rest, t);
        moved0.t_min = rest.t_min;
        let front_turns = front_part.t <= rest.t_min;
        let back_turns = back_part.t <= rest.t_min;
        let before = front_part.leaves && back_part.leaves;
        let behind = front_part.leaves != front_turns && back_part.leaves != back_turns;
        if before != behind {
            return Crossing(t, select(back_part.object, front_part.object, front_turns), before);
        }
    }
    return Crossing(NO_HIT, NO_OBJECT, false);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    var its_surface: Placed;
    switch object {
        case OBJECT_TABLE: { its_surface = placed(tableSurfaceAt(p), p); }
        case OBJECT_CUBE_ROUNDEDBOX_0: {
            its_surface = placedFrom(
                cubeRoundedBox0Space(),
                cubeRoundedBox0SurfaceAt(pointInto(cubeRoundedBox0Space(), p)),
                p,
            );
        }
        case OBJECT_CUBE_SPHERE_1: {
            its_surface = placedFrom(
                cubeSphere1Space(),
                cubeSphere1SurfaceAt(pointInto(cubeSphere1Space(), p)),
                p,
            );
        }
        case OBJECT_ONE: {
            its_surface = placedFrom(
                oneSpace(),
                inverted(oneSurfaceAt(pointInto(oneSpace(), p))),
                p,
            );
        }
        case OBJECT_TWO_A: {
            its_surface = placedFrom(
                twoASpace(),
                inverted(twoASurfaceAt(pointInto(twoASpace(), p))),
                p,
            );
        }
        case OBJECT_TWO_B: {
            its_surface = placedFrom(
                twoBSpace(),
                inverted(twoBSurfaceAt(pointInto(twoBSpace(), p))),
                p,
            );
        }
        case OBJECT_THREE_A: {
            its_surface = placedFrom(
                threeASpace(),
                inverted(threeASurfaceAt(pointInto(threeASpace(), p))),
                p,
            );
        }
        case OBJECT_THREE_B: {
            its_surface = placedFrom(
                threeBSpace(),
                inverted(threeBSurfaceAt(pointInto(threeBSpace(), p))),
                p,
            );
        }
        case OBJECT_THREE_C: {
            its_surface = placedFrom(
                threeCSpace(),
                inverted(threeCSurfaceAt(pointInto(threeCSpace(), p))),
                p,
            );
        }
        case OBJECT_CUP_ROUNDEDCYLINDER_0: {
            its_surface = placedFrom(
                cupRoundedCylinder0Space(),
                cupRoundedCylinder0SurfaceAt(pointInto(cupRoundedCylinder0Space(), p)),
                p,
            );
        }
        case OBJECT_HOLLOW: {
            its_surface = placedFrom(
                hollowSpace(),
                inverted(hollowSurfaceAt(pointInto(hollowSpace(), p))),
                p,
            );
        }
        case OBJECT_RING: {
            its_surface = placedFrom(ringSpace(), ringSurfaceAt(pointInto(ringSpace(), p)), p);
        }
        case OBJECT_INSIDE: {
            its_surface = placedFrom(
                insideSpace(),
                inverted(insideSurfaceAt(pointInto(insideSpace(), p))),
                p,
            );
        }
        case OBJECT_BLANK_HEXPRISM_0: {
            its_surface = placedFrom(
                blankHexPrism0Space(),
                blankHexPrism0SurfaceAt(pointInto(blankHexPrism0Space(), p)),
                p,
            );
        }
        case OBJECT_TURNED: {
            its_surface = placedFrom(
                turnedSpace(),
                turnedSurfaceAt(pointInto(turnedSpace(), p)),
                p,
            );
        }
        case OBJECT_BORE: {
            its_surface = placedFrom(
                boreSpace(),
                inverted(boreSurfaceAt(pointInto(boreSpace(), p))),
                p,
            );
        }
        case OBJECT_FRONT: {
            its_surface = placedFrom(frontSpace(), frontSurfaceAt(pointInto(frontSpace(), p)), p);
        }
        case OBJECT_BACK: {
            its_surface = placedFrom(backSpace(), backSurfaceAt(pointInto(backSpace(), p)), p);
        }
        default: { its_surface = placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
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
             OBJECT_THREE_C: {
            return inkMaterial(at);
        }
        case OBJECT_BLANK_HEXPRISM_0, OBJECT_TURNED, OBJECT_BORE: { return steelMaterial(at); }
        case OBJECT_TABLE: { return tableMaterial(at); }
        case OBJECT_CUP_ROUNDEDCYLINDER_0, OBJECT_HOLLOW, OBJECT_RING, OBJECT_INSIDE: {
            return mugMaterial(at);
        }
        case OBJECT_FRONT, OBJECT_BACK: { return lensMaterial(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "ivory": (color: "#efe6d2", specular: 0.4, shininess: 80)
fn ivoryMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.8631572, 0.791298, 0.6444797));
    material.specular = 0.4;
    material.shininess = 80.0;
    return material;
}

/// material "ink": (color: "#2a2730", specular: 0.3)
fn inkMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.023153368, 0.020288564, 0.029556835));
    material.specular = 0.3;
    return material;
}

/// material "steel": (color: "#9aa4ad", specular: 0.8, shininess: 120, reflectivity: 0.25)
fn steelMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.32314324, 0.3712377, 0.4178851));
    material.specular = 0.8;
    material.shininess = 120.0;
    material.reflectivity = 0.25;
    return material;
}

/// material "table": (color: Wood(scale: 0.8), reflectivity: 0.04, fresnel: 5)
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

/// material "mug": (color: "#3f6f8f", specular: 0.5, reflectivity: 0.05, fresnel: 5)
fn mugMaterial(at: Surface) -> Material {
    var material = matte(vec3f(0.049706567, 0.15896083, 0.27467734));
    material.specular = 0.5;
    material.reflectivity = 0.05;
    material.fresnel = 5.0;
    return material;
}

/// material "lens": (color: 0.02, specular: 0.6, reflectivity: 0.04, fresnel: 5, transmission: 1, …
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
