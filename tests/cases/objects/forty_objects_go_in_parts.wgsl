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
    // objects[0] "Sphere 0": Sphere(center: (0, 0, 0), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(0.0), 0.4), OBJECT_SPHERE_0);
    // objects[1] "Sphere 1": Sphere(center: (1, 0, 0), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(1.0, 0.0, 0.0), 0.4), OBJECT_SPHERE_1);
    // objects[2] "Sphere 2": Sphere(center: (2, 0, 0), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(2.0, 0.0, 0.0), 0.4), OBJECT_SPHERE_2);
    // objects[3] "Sphere 3": Sphere(center: (3, 0, 0), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(3.0, 0.0, 0.0), 0.4), OBJECT_SPHERE_3);
    // objects[4] "Sphere 4": Sphere(center: (4, 0, 0), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(4.0, 0.0, 0.0), 0.4), OBJECT_SPHERE_4);
    // objects[5] "Sphere 5": Sphere(center: (5, 0, 0), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(5.0, 0.0, 0.0), 0.4), OBJECT_SPHERE_5);
    // objects[6] "Sphere 6": Sphere(center: (6, 0, 0), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(6.0, 0.0, 0.0), 0.4), OBJECT_SPHERE_6);
    // objects[7] "Sphere 7": Sphere(center: (7, 0, 0), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(7.0, 0.0, 0.0), 0.4), OBJECT_SPHERE_7);
    // objects[8] "Sphere 8": Sphere(center: (0, 0, 1), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(0.0, 0.0, 1.0), 0.4), OBJECT_SPHERE_8);
    // objects[9] "Sphere 9": Sphere(center: (1, 0, 1), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(1.0, 0.0, 1.0), 0.4), OBJECT_SPHERE_9);
    // objects[10] "Sphere 10": Sphere(center: (2, 0, 1), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(2.0, 0.0, 1.0), 0.4), OBJECT_SPHERE_10);
    // objects[11] "Sphere 11": Sphere(center: (3, 0, 1), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(3.0, 0.0, 1.0), 0.4), OBJECT_SPHERE_11);
    // objects[12] "Sphere 12": Sphere(center: (4, 0, 1), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(4.0, 0.0, 1.0), 0.4), OBJECT_SPHERE_12);
    // objects[13] "Sphere 13": Sphere(center: (5, 0, 1), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(5.0, 0.0, 1.0), 0.4), OBJECT_SPHERE_13);
    // objects[14] "Sphere 14": Sphere(center: (6, 0, 1), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(6.0, 0.0, 1.0), 0.4), OBJECT_SPHERE_14);
    // objects[15] "Sphere 15": Sphere(center: (7, 0, 1), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(7.0, 0.0, 1.0), 0.4), OBJECT_SPHERE_15);
    // objects[16] "Sphere 16": Sphere(center: (0, 0, 2), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(0.0, 0.0, 2.0), 0.4), OBJECT_SPHERE_16);
    // objects[17] "Sphere 17": Sphere(center: (1, 0, 2), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(1.0, 0.0, 2.0), 0.4), OBJECT_SPHERE_17);
    // objects[18] "Sphere 18": Sphere(center: (2, 0, 2), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(2.0, 0.0, 2.0), 0.4), OBJECT_SPHERE_18);
    // objects[19] "Sphere 19": Sphere(center: (3, 0, 2), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(3.0, 0.0, 2.0), 0.4), OBJECT_SPHERE_19);
    // objects[20] "Sphere 20": Sphere(center: (4, 0, 2), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(4.0, 0.0, 2.0), 0.4), OBJECT_SPHERE_20);
    // objects[21] "Sphere 21": Sphere(center: (5, 0, 2), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(5.0, 0.0, 2.0), 0.4), OBJECT_SPHERE_21);
    // objects[22] "Sphere 22": Sphere(center: (6, 0, 2), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(6.0, 0.0, 2.0), 0.4), OBJECT_SPHERE_22);
    // objects[23] "Sphere 23": Sphere(center: (7, 0, 2), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(7.0, 0.0, 2.0), 0.4), OBJECT_SPHERE_23);
    // objects[24] "Sphere 24": Sphere(center: (0, 0, 3), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(0.0, 0.0, 3.0), 0.4), OBJECT_SPHERE_24);
    // objects[25] "Sphere 25": Sphere(center: (1, 0, 3), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(1.0, 0.0, 3.0), 0.4), OBJECT_SPHERE_25);
    // objects[26] "Sphere 26": Sphere(center: (2, 0, 3), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(2.0, 0.0, 3.0), 0.4), OBJECT_SPHERE_26);
    // objects[27] "Sphere 27": Sphere(center: (3, 0, 3), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(3.0, 0.0, 3.0), 0.4), OBJECT_SPHERE_27);
    // objects[28] "Sphere 28": Sphere(center: (4, 0, 3), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(4.0, 0.0, 3.0), 0.4), OBJECT_SPHERE_28);
    // objects[29] "Sphere 29": Sphere(center: (5, 0, 3), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(5.0, 0.0, 3.0), 0.4), OBJECT_SPHERE_29);
    // objects[30] "Sphere 30": Sphere(center: (6, 0, 3), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(6.0, 0.0, 3.0), 0.4), OBJECT_SPHERE_30);
    // objects[31] "Sphere 31": Sphere(center: (7, 0, 3), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(7.0, 0.0, 3.0), 0.4), OBJECT_SPHERE_31);
    return hit;
}

fn rayTracePart1(ray: Ray, before: Hit) -> Hit {
    var hit = before;
    // objects[32] "Sphere 32": Sphere(center: (0, 0, 4), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(0.0, 0.0, 4.0), 0.4), OBJECT_SPHERE_32);
    // objects[33] "Sphere 33": Sphere(center: (1, 0, 4), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(1.0, 0.0, 4.0), 0.4), OBJECT_SPHERE_33);
    // objects[34] "Sphere 34": Sphere(center: (2, 0, 4), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(2.0, 0.0, 4.0), 0.4), OBJECT_SPHERE_34);
    // objects[35] "Sphere 35": Sphere(center: (3, 0, 4), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(3.0, 0.0, 4.0), 0.4), OBJECT_SPHERE_35);
    // objects[36] "Sphere 36": Sphere(center: (4, 0, 4), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(4.0, 0.0, 4.0), 0.4), OBJECT_SPHERE_36);
    // objects[37] "Sphere 37": Sphere(center: (5, 0, 4), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(5.0, 0.0, 4.0), 0.4), OBJECT_SPHERE_37);
    // objects[38] "Sphere 38": Sphere(center: (6, 0, 4), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(6.0, 0.0, 4.0), 0.4), OBJECT_SPHERE_38);
    // objects[39] "Sphere 39": Sphere(center: (7, 0, 4), radius: 0.4)
    hit = nearer(hit, sphere(ray, vec3f(7.0, 0.0, 4.0), 0.4), OBJECT_SPHERE_39);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    return partBlocks0(ray) || partBlocks1(ray);
}

fn partBlocks0(ray: Ray) -> bool {
    if sphere(ray, vec3f(0.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(1.0, 0.0, 0.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(2.0, 0.0, 0.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(3.0, 0.0, 0.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(4.0, 0.0, 0.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(5.0, 0.0, 0.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(6.0, 0.0, 0.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(7.0, 0.0, 0.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(0.0, 0.0, 1.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(1.0, 0.0, 1.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(2.0, 0.0, 1.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(3.0, 0.0, 1.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(4.0, 0.0, 1.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(5.0, 0.0, 1.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(6.0, 0.0, 1.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(7.0, 0.0, 1.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(0.0, 0.0, 2.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(1.0, 0.0, 2.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(2.0, 0.0, 2.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(3.0, 0.0, 2.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(4.0, 0.0, 2.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(5.0, 0.0, 2.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(6.0, 0.0, 2.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(7.0, 0.0, 2.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(0.0, 0.0, 3.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(1.0, 0.0, 3.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(2.0, 0.0, 3.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(3.0, 0.0, 3.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(4.0, 0.0, 3.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(5.0, 0.0, 3.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(6.0, 0.0, 3.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(7.0, 0.0, 3.0), 0.4) < NO_HIT { return true; }
    return false;
}

fn partBlocks1(ray: Ray) -> bool {
    if sphere(ray, vec3f(0.0, 0.0, 4.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(1.0, 0.0, 4.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(2.0, 0.0, 4.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(3.0, 0.0, 4.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(4.0, 0.0, 4.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(5.0, 0.0, 4.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(6.0, 0.0, 4.0), 0.4) < NO_HIT { return true; }
    if sphere(ray, vec3f(7.0, 0.0, 4.0), 0.4) < NO_HIT { return true; }
    return false;
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
        case OBJECT_SPHERE_0: {
            its_surface = placed(sphereSurface(p, vec3f(0.0), 0.4), p);
        }
        case OBJECT_SPHERE_1: {
            its_surface = placed(sphereSurface(p, vec3f(1.0, 0.0, 0.0), 0.4), p);
        }
        case OBJECT_SPHERE_2: {
            its_surface = placed(sphereSurface(p, vec3f(2.0, 0.0, 0.0), 0.4), p);
        }
        case OBJECT_SPHERE_3: {
            its_surface = placed(sphereSurface(p, vec3f(3.0, 0.0, 0.0), 0.4), p);
        }
        case OBJECT_SPHERE_4: {
            its_surface = placed(sphereSurface(p, vec3f(4.0, 0.0, 0.0), 0.4), p);
        }
        case OBJECT_SPHERE_5: {
            its_surface = placed(sphereSurface(p, vec3f(5.0, 0.0, 0.0), 0.4), p);
        }
        case OBJECT_SPHERE_6: {
            its_surface = placed(sphereSurface(p, vec3f(6.0, 0.0, 0.0), 0.4), p);
        }
        case OBJECT_SPHERE_7: {
            its_surface = placed(sphereSurface(p, vec3f(7.0, 0.0, 0.0), 0.4), p);
        }
        case OBJECT_SPHERE_8: {
            its_surface = placed(sphereSurface(p, vec3f(0.0, 0.0, 1.0), 0.4), p);
        }
        case OBJECT_SPHERE_9: {
            its_surface = placed(sphereSurface(p, vec3f(1.0, 0.0, 1.0), 0.4), p);
        }
        case OBJECT_SPHERE_10: {
            its_surface = placed(sphereSurface(p, vec3f(2.0, 0.0, 1.0), 0.4), p);
        }
        case OBJECT_SPHERE_11: {
            its_surface = placed(sphereSurface(p, vec3f(3.0, 0.0, 1.0), 0.4), p);
        }
        case OBJECT_SPHERE_12: {
            its_surface = placed(sphereSurface(p, vec3f(4.0, 0.0, 1.0), 0.4), p);
        }
        case OBJECT_SPHERE_13: {
            its_surface = placed(sphereSurface(p, vec3f(5.0, 0.0, 1.0), 0.4), p);
        }
        case OBJECT_SPHERE_14: {
            its_surface = placed(sphereSurface(p, vec3f(6.0, 0.0, 1.0), 0.4), p);
        }
        case OBJECT_SPHERE_15: {
            its_surface = placed(sphereSurface(p, vec3f(7.0, 0.0, 1.0), 0.4), p);
        }
        case OBJECT_SPHERE_16: {
            its_surface = placed(sphereSurface(p, vec3f(0.0, 0.0, 2.0), 0.4), p);
        }
        case OBJECT_SPHERE_17: {
            its_surface = placed(sphereSurface(p, vec3f(1.0, 0.0, 2.0), 0.4), p);
        }
        case OBJECT_SPHERE_18: {
            its_surface = placed(sphereSurface(p, vec3f(2.0, 0.0, 2.0), 0.4), p);
        }
        case OBJECT_SPHERE_19: {
            its_surface = placed(sphereSurface(p, vec3f(3.0, 0.0, 2.0), 0.4), p);
        }
        case OBJECT_SPHERE_20: {
            its_surface = placed(sphereSurface(p, vec3f(4.0, 0.0, 2.0), 0.4), p);
        }
        case OBJECT_SPHERE_21: {
            its_surface = placed(sphereSurface(p, vec3f(5.0, 0.0, 2.0), 0.4), p);
        }
        case OBJECT_SPHERE_22: {
            its_surface = placed(sphereSurface(p, vec3f(6.0, 0.0, 2.0), 0.4), p);
        }
        case OBJECT_SPHERE_23: {
            its_surface = placed(sphereSurface(p, vec3f(7.0, 0.0, 2.0), 0.4), p);
        }
        case OBJECT_SPHERE_24: {
            its_surface = placed(sphereSurface(p, vec3f(0.0, 0.0, 3.0), 0.4), p);
        }
        case OBJECT_SPHERE_25: {
            its_surface = placed(sphereSurface(p, vec3f(1.0, 0.0, 3.0), 0.4), p);
        }
        case OBJECT_SPHERE_26: {
            its_surface = placed(sphereSurface(p, vec3f(2.0, 0.0, 3.0), 0.4), p);
        }
        case OBJECT_SPHERE_27: {
            its_surface = placed(sphereSurface(p, vec3f(3.0, 0.0, 3.0), 0.4), p);
        }
        case OBJECT_SPHERE_28: {
            its_surface = placed(sphereSurface(p, vec3f(4.0, 0.0, 3.0), 0.4), p);
        }
        case OBJECT_SPHERE_29: {
            its_surface = placed(sphereSurface(p, vec3f(5.0, 0.0, 3.0), 0.4), p);
        }
        case OBJECT_SPHERE_30: {
            its_surface = placed(sphereSurface(p, vec3f(6.0, 0.0, 3.0), 0.4), p);
        }
        case OBJECT_SPHERE_31: {
            its_surface = placed(sphereSurface(p, vec3f(7.0, 0.0, 3.0), 0.4), p);
        }
        default: {
            its_surface = placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p);
        }
    }
    return its_surface;
}

fn surfacePart1(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_SPHERE_32: {
            return placed(sphereSurface(p, vec3f(0.0, 0.0, 4.0), 0.4), p);
        }
        case OBJECT_SPHERE_33: {
            return placed(sphereSurface(p, vec3f(1.0, 0.0, 4.0), 0.4), p);
        }
        case OBJECT_SPHERE_34: {
            return placed(sphereSurface(p, vec3f(2.0, 0.0, 4.0), 0.4), p);
        }
        case OBJECT_SPHERE_35: {
            return placed(sphereSurface(p, vec3f(3.0, 0.0, 4.0), 0.4), p);
        }
        case OBJECT_SPHERE_36: {
            return placed(sphereSurface(p, vec3f(4.0, 0.0, 4.0), 0.4), p);
        }
        case OBJECT_SPHERE_37: {
            return placed(sphereSurface(p, vec3f(5.0, 0.0, 4.0), 0.4), p);
        }
        case OBJECT_SPHERE_38: {
            return placed(sphereSurface(p, vec3f(6.0, 0.0, 4.0), 0.4), p);
        }
        case OBJECT_SPHERE_39: {
            return placed(sphereSurface(p, vec3f(7.0, 0.0, 4.0), 0.4), p);
        }
        default: {
            return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p);
        }
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
             OBJECT_SPHERE_39: { return clayMaterial(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

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
