// Generated from tests/cases/objects/forty_objects_go_in_parts.ron
// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.
//
//   objects   Sphere 0, Sphere 1, Sphere 2, Sphere 3, Sphere 4, Sphere 5, Sphere 6, Sphere 7,
//             Sphere 8, Sphere 9, Sphere 10, Sphere 11, Sphere 12, Sphere 13, Sphere 14,
//             Sphere 15, Sphere 16, Sphere 17, Sphere 18, Sphere 19, Sphere 20, Sphere 21,
//             Sphere 22, Sphere 23, Sphere 24, Sphere 25, Sphere 26, Sphere 27, Sphere 28,
//             Sphere 29, Sphere 30, Sphere 31, Sphere 32, Sphere 33, Sphere 34, Sphere 35,
//             Sphere 36, Sphere 37, Sphere 38, Sphere 39
//   shapes    Sphere

const OBJECT_SPHERE_0: u32 = 0u;
const OBJECT_SPHERE_1: u32 = 1u;
const OBJECT_SPHERE_2: u32 = 2u;
const OBJECT_SPHERE_3: u32 = 3u;
const OBJECT_SPHERE_4: u32 = 4u;
const OBJECT_SPHERE_5: u32 = 5u;
const OBJECT_SPHERE_6: u32 = 6u;
const OBJECT_SPHERE_7: u32 = 7u;
const OBJECT_SPHERE_8: u32 = 8u;
const OBJECT_SPHERE_9: u32 = 9u;
const OBJECT_SPHERE_10: u32 = 10u;
const OBJECT_SPHERE_11: u32 = 11u;
const OBJECT_SPHERE_12: u32 = 12u;
const OBJECT_SPHERE_13: u32 = 13u;
const OBJECT_SPHERE_14: u32 = 14u;
const OBJECT_SPHERE_15: u32 = 15u;
const OBJECT_SPHERE_16: u32 = 16u;
const OBJECT_SPHERE_17: u32 = 17u;
const OBJECT_SPHERE_18: u32 = 18u;
const OBJECT_SPHERE_19: u32 = 19u;
const OBJECT_SPHERE_20: u32 = 20u;
const OBJECT_SPHERE_21: u32 = 21u;
const OBJECT_SPHERE_22: u32 = 22u;
const OBJECT_SPHERE_23: u32 = 23u;
const OBJECT_SPHERE_24: u32 = 24u;
const OBJECT_SPHERE_25: u32 = 25u;
const OBJECT_SPHERE_26: u32 = 26u;
const OBJECT_SPHERE_27: u32 = 27u;
const OBJECT_SPHERE_28: u32 = 28u;
const OBJECT_SPHERE_29: u32 = 29u;
const OBJECT_SPHERE_30: u32 = 30u;
const OBJECT_SPHERE_31: u32 = 31u;
const OBJECT_SPHERE_32: u32 = 32u;
const OBJECT_SPHERE_33: u32 = 33u;
const OBJECT_SPHERE_34: u32 = 34u;
const OBJECT_SPHERE_35: u32 = 35u;
const OBJECT_SPHERE_36: u32 = 36u;
const OBJECT_SPHERE_37: u32 = 37u;
const OBJECT_SPHERE_38: u32 = 38u;
const OBJECT_SPHERE_39: u32 = 39u;
const LIGHTS: u32 = 0u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    hit = rayTracePart0(ray, hit);
    hit = rayTracePart1(ray, hit);
    return hit;
}

fn rayTracePart0(ray: Ray, before: Hit) -> Hit {
    var hit = before;
    hit = nearer(hit, sphere0Crossing(ray), OBJECT_SPHERE_0);
    hit = nearer(hit, sphere1Crossing(ray), OBJECT_SPHERE_1);
    hit = nearer(hit, sphere2Crossing(ray), OBJECT_SPHERE_2);
    hit = nearer(hit, sphere3Crossing(ray), OBJECT_SPHERE_3);
    hit = nearer(hit, sphere4Crossing(ray), OBJECT_SPHERE_4);
    hit = nearer(hit, sphere5Crossing(ray), OBJECT_SPHERE_5);
    hit = nearer(hit, sphere6Crossing(ray), OBJECT_SPHERE_6);
    hit = nearer(hit, sphere7Crossing(ray), OBJECT_SPHERE_7);
    hit = nearer(hit, sphere8Crossing(ray), OBJECT_SPHERE_8);
    hit = nearer(hit, sphere9Crossing(ray), OBJECT_SPHERE_9);
    hit = nearer(hit, sphere10Crossing(ray), OBJECT_SPHERE_10);
    hit = nearer(hit, sphere11Crossing(ray), OBJECT_SPHERE_11);
    hit = nearer(hit, sphere12Crossing(ray), OBJECT_SPHERE_12);
    hit = nearer(hit, sphere13Crossing(ray), OBJECT_SPHERE_13);
    hit = nearer(hit, sphere14Crossing(ray), OBJECT_SPHERE_14);
    hit = nearer(hit, sphere15Crossing(ray), OBJECT_SPHERE_15);
    hit = nearer(hit, sphere16Crossing(ray), OBJECT_SPHERE_16);
    hit = nearer(hit, sphere17Crossing(ray), OBJECT_SPHERE_17);
    hit = nearer(hit, sphere18Crossing(ray), OBJECT_SPHERE_18);
    hit = nearer(hit, sphere19Crossing(ray), OBJECT_SPHERE_19);
    hit = nearer(hit, sphere20Crossing(ray), OBJECT_SPHERE_20);
    hit = nearer(hit, sphere21Crossing(ray), OBJECT_SPHERE_21);
    hit = nearer(hit, sphere22Crossing(ray), OBJECT_SPHERE_22);
    hit = nearer(hit, sphere23Crossing(ray), OBJECT_SPHERE_23);
    hit = nearer(hit, sphere24Crossing(ray), OBJECT_SPHERE_24);
    hit = nearer(hit, sphere25Crossing(ray), OBJECT_SPHERE_25);
    hit = nearer(hit, sphere26Crossing(ray), OBJECT_SPHERE_26);
    hit = nearer(hit, sphere27Crossing(ray), OBJECT_SPHERE_27);
    hit = nearer(hit, sphere28Crossing(ray), OBJECT_SPHERE_28);
    hit = nearer(hit, sphere29Crossing(ray), OBJECT_SPHERE_29);
    hit = nearer(hit, sphere30Crossing(ray), OBJECT_SPHERE_30);
    hit = nearer(hit, sphere31Crossing(ray), OBJECT_SPHERE_31);
    return hit;
}

fn rayTracePart1(ray: Ray, before: Hit) -> Hit {
    var hit = before;
    hit = nearer(hit, sphere32Crossing(ray), OBJECT_SPHERE_32);
    hit = nearer(hit, sphere33Crossing(ray), OBJECT_SPHERE_33);
    hit = nearer(hit, sphere34Crossing(ray), OBJECT_SPHERE_34);
    hit = nearer(hit, sphere35Crossing(ray), OBJECT_SPHERE_35);
    hit = nearer(hit, sphere36Crossing(ray), OBJECT_SPHERE_36);
    hit = nearer(hit, sphere37Crossing(ray), OBJECT_SPHERE_37);
    hit = nearer(hit, sphere38Crossing(ray), OBJECT_SPHERE_38);
    hit = nearer(hit, sphere39Crossing(ray), OBJECT_SPHERE_39);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    return partBlocks0(ray) || partBlocks1(ray);
}

fn partBlocks0(ray: Ray) -> bool {
    if sphere0Crossing(ray) < NO_HIT { return true; }
    if sphere1Crossing(ray) < NO_HIT { return true; }
    if sphere2Crossing(ray) < NO_HIT { return true; }
    if sphere3Crossing(ray) < NO_HIT { return true; }
    if sphere4Crossing(ray) < NO_HIT { return true; }
    if sphere5Crossing(ray) < NO_HIT { return true; }
    if sphere6Crossing(ray) < NO_HIT { return true; }
    if sphere7Crossing(ray) < NO_HIT { return true; }
    if sphere8Crossing(ray) < NO_HIT { return true; }
    if sphere9Crossing(ray) < NO_HIT { return true; }
    if sphere10Crossing(ray) < NO_HIT { return true; }
    if sphere11Crossing(ray) < NO_HIT { return true; }
    if sphere12Crossing(ray) < NO_HIT { return true; }
    if sphere13Crossing(ray) < NO_HIT { return true; }
    if sphere14Crossing(ray) < NO_HIT { return true; }
    if sphere15Crossing(ray) < NO_HIT { return true; }
    if sphere16Crossing(ray) < NO_HIT { return true; }
    if sphere17Crossing(ray) < NO_HIT { return true; }
    if sphere18Crossing(ray) < NO_HIT { return true; }
    if sphere19Crossing(ray) < NO_HIT { return true; }
    if sphere20Crossing(ray) < NO_HIT { return true; }
    if sphere21Crossing(ray) < NO_HIT { return true; }
    if sphere22Crossing(ray) < NO_HIT { return true; }
    if sphere23Crossing(ray) < NO_HIT { return true; }
    if sphere24Crossing(ray) < NO_HIT { return true; }
    if sphere25Crossing(ray) < NO_HIT { return true; }
    if sphere26Crossing(ray) < NO_HIT { return true; }
    if sphere27Crossing(ray) < NO_HIT { return true; }
    if sphere28Crossing(ray) < NO_HIT { return true; }
    if sphere29Crossing(ray) < NO_HIT { return true; }
    if sphere30Crossing(ray) < NO_HIT { return true; }
    if sphere31Crossing(ray) < NO_HIT { return true; }
    return false;
}

fn partBlocks1(ray: Ray) -> bool {
    if sphere32Crossing(ray) < NO_HIT { return true; }
    if sphere33Crossing(ray) < NO_HIT { return true; }
    if sphere34Crossing(ray) < NO_HIT { return true; }
    if sphere35Crossing(ray) < NO_HIT { return true; }
    if sphere36Crossing(ray) < NO_HIT { return true; }
    if sphere37Crossing(ray) < NO_HIT { return true; }
    if sphere38Crossing(ray) < NO_HIT { return true; }
    if sphere39Crossing(ray) < NO_HIT { return true; }
    return false;
}

/// objects[0] "Sphere 0": Sphere(center: (0, 0, 0), radius: 0.4)
fn sphere0Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0), 0.4);
}

fn sphere0SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0), 0.4);
}

/// objects[1] "Sphere 1": Sphere(center: (1, 0, 0), radius: 0.4)
fn sphere1Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(1.0, 0.0, 0.0), 0.4);
}

fn sphere1SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(1.0, 0.0, 0.0), 0.4);
}

/// objects[2] "Sphere 2": Sphere(center: (2, 0, 0), radius: 0.4)
fn sphere2Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(2.0, 0.0, 0.0), 0.4);
}

fn sphere2SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(2.0, 0.0, 0.0), 0.4);
}

/// objects[3] "Sphere 3": Sphere(center: (3, 0, 0), radius: 0.4)
fn sphere3Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(3.0, 0.0, 0.0), 0.4);
}

fn sphere3SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(3.0, 0.0, 0.0), 0.4);
}

/// objects[4] "Sphere 4": Sphere(center: (4, 0, 0), radius: 0.4)
fn sphere4Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(4.0, 0.0, 0.0), 0.4);
}

fn sphere4SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(4.0, 0.0, 0.0), 0.4);
}

/// objects[5] "Sphere 5": Sphere(center: (5, 0, 0), radius: 0.4)
fn sphere5Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(5.0, 0.0, 0.0), 0.4);
}

fn sphere5SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(5.0, 0.0, 0.0), 0.4);
}

/// objects[6] "Sphere 6": Sphere(center: (6, 0, 0), radius: 0.4)
fn sphere6Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(6.0, 0.0, 0.0), 0.4);
}

fn sphere6SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(6.0, 0.0, 0.0), 0.4);
}

/// objects[7] "Sphere 7": Sphere(center: (7, 0, 0), radius: 0.4)
fn sphere7Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(7.0, 0.0, 0.0), 0.4);
}

fn sphere7SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(7.0, 0.0, 0.0), 0.4);
}

/// objects[8] "Sphere 8": Sphere(center: (0, 0, 1), radius: 0.4)
fn sphere8Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0, 0.0, 1.0), 0.4);
}

fn sphere8SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0, 0.0, 1.0), 0.4);
}

/// objects[9] "Sphere 9": Sphere(center: (1, 0, 1), radius: 0.4)
fn sphere9Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(1.0, 0.0, 1.0), 0.4);
}

fn sphere9SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(1.0, 0.0, 1.0), 0.4);
}

/// objects[10] "Sphere 10": Sphere(center: (2, 0, 1), radius: 0.4)
fn sphere10Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(2.0, 0.0, 1.0), 0.4);
}

fn sphere10SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(2.0, 0.0, 1.0), 0.4);
}

/// objects[11] "Sphere 11": Sphere(center: (3, 0, 1), radius: 0.4)
fn sphere11Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(3.0, 0.0, 1.0), 0.4);
}

fn sphere11SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(3.0, 0.0, 1.0), 0.4);
}

/// objects[12] "Sphere 12": Sphere(center: (4, 0, 1), radius: 0.4)
fn sphere12Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(4.0, 0.0, 1.0), 0.4);
}

fn sphere12SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(4.0, 0.0, 1.0), 0.4);
}

/// objects[13] "Sphere 13": Sphere(center: (5, 0, 1), radius: 0.4)
fn sphere13Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(5.0, 0.0, 1.0), 0.4);
}

fn sphere13SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(5.0, 0.0, 1.0), 0.4);
}

/// objects[14] "Sphere 14": Sphere(center: (6, 0, 1), radius: 0.4)
fn sphere14Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(6.0, 0.0, 1.0), 0.4);
}

fn sphere14SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(6.0, 0.0, 1.0), 0.4);
}

/// objects[15] "Sphere 15": Sphere(center: (7, 0, 1), radius: 0.4)
fn sphere15Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(7.0, 0.0, 1.0), 0.4);
}

fn sphere15SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(7.0, 0.0, 1.0), 0.4);
}

/// objects[16] "Sphere 16": Sphere(center: (0, 0, 2), radius: 0.4)
fn sphere16Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0, 0.0, 2.0), 0.4);
}

fn sphere16SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0, 0.0, 2.0), 0.4);
}

/// objects[17] "Sphere 17": Sphere(center: (1, 0, 2), radius: 0.4)
fn sphere17Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(1.0, 0.0, 2.0), 0.4);
}

fn sphere17SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(1.0, 0.0, 2.0), 0.4);
}

/// objects[18] "Sphere 18": Sphere(center: (2, 0, 2), radius: 0.4)
fn sphere18Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(2.0, 0.0, 2.0), 0.4);
}

fn sphere18SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(2.0, 0.0, 2.0), 0.4);
}

/// objects[19] "Sphere 19": Sphere(center: (3, 0, 2), radius: 0.4)
fn sphere19Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(3.0, 0.0, 2.0), 0.4);
}

fn sphere19SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(3.0, 0.0, 2.0), 0.4);
}

/// objects[20] "Sphere 20": Sphere(center: (4, 0, 2), radius: 0.4)
fn sphere20Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(4.0, 0.0, 2.0), 0.4);
}

fn sphere20SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(4.0, 0.0, 2.0), 0.4);
}

/// objects[21] "Sphere 21": Sphere(center: (5, 0, 2), radius: 0.4)
fn sphere21Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(5.0, 0.0, 2.0), 0.4);
}

fn sphere21SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(5.0, 0.0, 2.0), 0.4);
}

/// objects[22] "Sphere 22": Sphere(center: (6, 0, 2), radius: 0.4)
fn sphere22Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(6.0, 0.0, 2.0), 0.4);
}

fn sphere22SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(6.0, 0.0, 2.0), 0.4);
}

/// objects[23] "Sphere 23": Sphere(center: (7, 0, 2), radius: 0.4)
fn sphere23Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(7.0, 0.0, 2.0), 0.4);
}

fn sphere23SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(7.0, 0.0, 2.0), 0.4);
}

/// objects[24] "Sphere 24": Sphere(center: (0, 0, 3), radius: 0.4)
fn sphere24Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0, 0.0, 3.0), 0.4);
}

fn sphere24SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0, 0.0, 3.0), 0.4);
}

/// objects[25] "Sphere 25": Sphere(center: (1, 0, 3), radius: 0.4)
fn sphere25Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(1.0, 0.0, 3.0), 0.4);
}

fn sphere25SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(1.0, 0.0, 3.0), 0.4);
}

/// objects[26] "Sphere 26": Sphere(center: (2, 0, 3), radius: 0.4)
fn sphere26Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(2.0, 0.0, 3.0), 0.4);
}

fn sphere26SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(2.0, 0.0, 3.0), 0.4);
}

/// objects[27] "Sphere 27": Sphere(center: (3, 0, 3), radius: 0.4)
fn sphere27Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(3.0, 0.0, 3.0), 0.4);
}

fn sphere27SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(3.0, 0.0, 3.0), 0.4);
}

/// objects[28] "Sphere 28": Sphere(center: (4, 0, 3), radius: 0.4)
fn sphere28Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(4.0, 0.0, 3.0), 0.4);
}

fn sphere28SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(4.0, 0.0, 3.0), 0.4);
}

/// objects[29] "Sphere 29": Sphere(center: (5, 0, 3), radius: 0.4)
fn sphere29Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(5.0, 0.0, 3.0), 0.4);
}

fn sphere29SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(5.0, 0.0, 3.0), 0.4);
}

/// objects[30] "Sphere 30": Sphere(center: (6, 0, 3), radius: 0.4)
fn sphere30Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(6.0, 0.0, 3.0), 0.4);
}

fn sphere30SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(6.0, 0.0, 3.0), 0.4);
}

/// objects[31] "Sphere 31": Sphere(center: (7, 0, 3), radius: 0.4)
fn sphere31Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(7.0, 0.0, 3.0), 0.4);
}

fn sphere31SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(7.0, 0.0, 3.0), 0.4);
}

/// objects[32] "Sphere 32": Sphere(center: (0, 0, 4), radius: 0.4)
fn sphere32Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(0.0, 0.0, 4.0), 0.4);
}

fn sphere32SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(0.0, 0.0, 4.0), 0.4);
}

/// objects[33] "Sphere 33": Sphere(center: (1, 0, 4), radius: 0.4)
fn sphere33Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(1.0, 0.0, 4.0), 0.4);
}

fn sphere33SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(1.0, 0.0, 4.0), 0.4);
}

/// objects[34] "Sphere 34": Sphere(center: (2, 0, 4), radius: 0.4)
fn sphere34Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(2.0, 0.0, 4.0), 0.4);
}

fn sphere34SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(2.0, 0.0, 4.0), 0.4);
}

/// objects[35] "Sphere 35": Sphere(center: (3, 0, 4), radius: 0.4)
fn sphere35Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(3.0, 0.0, 4.0), 0.4);
}

fn sphere35SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(3.0, 0.0, 4.0), 0.4);
}

/// objects[36] "Sphere 36": Sphere(center: (4, 0, 4), radius: 0.4)
fn sphere36Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(4.0, 0.0, 4.0), 0.4);
}

fn sphere36SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(4.0, 0.0, 4.0), 0.4);
}

/// objects[37] "Sphere 37": Sphere(center: (5, 0, 4), radius: 0.4)
fn sphere37Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(5.0, 0.0, 4.0), 0.4);
}

fn sphere37SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(5.0, 0.0, 4.0), 0.4);
}

/// objects[38] "Sphere 38": Sphere(center: (6, 0, 4), radius: 0.4)
fn sphere38Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(6.0, 0.0, 4.0), 0.4);
}

fn sphere38SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(6.0, 0.0, 4.0), 0.4);
}

/// objects[39] "Sphere 39": Sphere(center: (7, 0, 4), radius: 0.4)
fn sphere39Crossing(ray: Ray) -> f32 {
    return sphere(ray, vec3f(7.0, 0.0, 4.0), 0.4);
}

fn sphere39SurfaceAt(p: vec3f) -> Surface {
    return sphereSurface(p, vec3f(7.0, 0.0, 4.0), 0.4);
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    var its_surface: Placed;
    switch object / 32u {
        case 0u: { its_surface = surfacePart0(object, p); }
        default: { its_surface = surfacePart1(object, p); }
    }
    return its_surface;
}

fn surfacePart0(object: u32, p: vec3f) -> Placed {
    var its_surface: Placed;
    switch object {
        case OBJECT_SPHERE_0: { its_surface = placed(sphere0SurfaceAt(p), p); }
        case OBJECT_SPHERE_1: { its_surface = placed(sphere1SurfaceAt(p), p); }
        case OBJECT_SPHERE_2: { its_surface = placed(sphere2SurfaceAt(p), p); }
        case OBJECT_SPHERE_3: { its_surface = placed(sphere3SurfaceAt(p), p); }
        case OBJECT_SPHERE_4: { its_surface = placed(sphere4SurfaceAt(p), p); }
        case OBJECT_SPHERE_5: { its_surface = placed(sphere5SurfaceAt(p), p); }
        case OBJECT_SPHERE_6: { its_surface = placed(sphere6SurfaceAt(p), p); }
        case OBJECT_SPHERE_7: { its_surface = placed(sphere7SurfaceAt(p), p); }
        case OBJECT_SPHERE_8: { its_surface = placed(sphere8SurfaceAt(p), p); }
        case OBJECT_SPHERE_9: { its_surface = placed(sphere9SurfaceAt(p), p); }
        case OBJECT_SPHERE_10: { its_surface = placed(sphere10SurfaceAt(p), p); }
        case OBJECT_SPHERE_11: { its_surface = placed(sphere11SurfaceAt(p), p); }
        case OBJECT_SPHERE_12: { its_surface = placed(sphere12SurfaceAt(p), p); }
        case OBJECT_SPHERE_13: { its_surface = placed(sphere13SurfaceAt(p), p); }
        case OBJECT_SPHERE_14: { its_surface = placed(sphere14SurfaceAt(p), p); }
        case OBJECT_SPHERE_15: { its_surface = placed(sphere15SurfaceAt(p), p); }
        case OBJECT_SPHERE_16: { its_surface = placed(sphere16SurfaceAt(p), p); }
        case OBJECT_SPHERE_17: { its_surface = placed(sphere17SurfaceAt(p), p); }
        case OBJECT_SPHERE_18: { its_surface = placed(sphere18SurfaceAt(p), p); }
        case OBJECT_SPHERE_19: { its_surface = placed(sphere19SurfaceAt(p), p); }
        case OBJECT_SPHERE_20: { its_surface = placed(sphere20SurfaceAt(p), p); }
        case OBJECT_SPHERE_21: { its_surface = placed(sphere21SurfaceAt(p), p); }
        case OBJECT_SPHERE_22: { its_surface = placed(sphere22SurfaceAt(p), p); }
        case OBJECT_SPHERE_23: { its_surface = placed(sphere23SurfaceAt(p), p); }
        case OBJECT_SPHERE_24: { its_surface = placed(sphere24SurfaceAt(p), p); }
        case OBJECT_SPHERE_25: { its_surface = placed(sphere25SurfaceAt(p), p); }
        case OBJECT_SPHERE_26: { its_surface = placed(sphere26SurfaceAt(p), p); }
        case OBJECT_SPHERE_27: { its_surface = placed(sphere27SurfaceAt(p), p); }
        case OBJECT_SPHERE_28: { its_surface = placed(sphere28SurfaceAt(p), p); }
        case OBJECT_SPHERE_29: { its_surface = placed(sphere29SurfaceAt(p), p); }
        case OBJECT_SPHERE_30: { its_surface = placed(sphere30SurfaceAt(p), p); }
        case OBJECT_SPHERE_31: { its_surface = placed(sphere31SurfaceAt(p), p); }
        default: { its_surface = placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
    return its_surface;
}

fn surfacePart1(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_SPHERE_32: { return placed(sphere32SurfaceAt(p), p); }
        case OBJECT_SPHERE_33: { return placed(sphere33SurfaceAt(p), p); }
        case OBJECT_SPHERE_34: { return placed(sphere34SurfaceAt(p), p); }
        case OBJECT_SPHERE_35: { return placed(sphere35SurfaceAt(p), p); }
        case OBJECT_SPHERE_36: { return placed(sphere36SurfaceAt(p), p); }
        case OBJECT_SPHERE_37: { return placed(sphere37SurfaceAt(p), p); }
        case OBJECT_SPHERE_38: { return placed(sphere38SurfaceAt(p), p); }
        case OBJECT_SPHERE_39: { return placed(sphere39SurfaceAt(p), p); }
        default: { return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p); }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_SPHERE_0,
             OBJECT_SPHERE_1,
             OBJECT_SPHERE_2,
             OBJECT_SPHERE_3,
             OBJECT_SPHERE_4,
             OBJECT_SPHERE_5,
             OBJECT_SPHERE_6,
             OBJECT_SPHERE_7,
             OBJECT_SPHERE_8,
             OBJECT_SPHERE_9,
             OBJECT_SPHERE_10,
             OBJECT_SPHERE_11,
             OBJECT_SPHERE_12,
             OBJECT_SPHERE_13,
             OBJECT_SPHERE_14,
             OBJECT_SPHERE_15,
             OBJECT_SPHERE_16,
             OBJECT_SPHERE_17,
             OBJECT_SPHERE_18,
             OBJECT_SPHERE_19,
             OBJECT_SPHERE_20,
             OBJECT_SPHERE_21,
             OBJECT_SPHERE_22,
             OBJECT_SPHERE_23,
             OBJECT_SPHERE_24,
             OBJECT_SPHERE_25,
             OBJECT_SPHERE_26,
             OBJECT_SPHERE_27,
             OBJECT_SPHERE_28,
             OBJECT_SPHERE_29,
             OBJECT_SPHERE_30,
             OBJECT_SPHERE_31,
             OBJECT_SPHERE_32,
             OBJECT_SPHERE_33,
             OBJECT_SPHERE_34,
             OBJECT_SPHERE_35,
             OBJECT_SPHERE_36,
             OBJECT_SPHERE_37,
             OBJECT_SPHERE_38,
             OBJECT_SPHERE_39: {
            return clayMaterial(at);
        }
        default: { return matte(vec3f(0.0)); }
    }
}

/// material "clay": (color: "#c96f4a")
fn clayMaterial(at: Surface) -> Material {
    return matte(vec3f(0.58407843, 0.15896083, 0.068478175));
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
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}
