// tests/cases/export/stands_alone.ron: a scene as a shader of its own
// Written by raytoy 0.1.0: raytoy generate tests/cases/export/stands_alone.ron --standalone
//
// To draw it with any WebGPU program, one sample a pixel:
//   vertex entry     coverPicture, without buffers: 3 vertices, a triangle that covers the target
//   fragment entry   drawPicture, to a target such as bgra8unorm; not to one that ends in -srgb, since the
//                    colors have the scene's transfer curve already
//   uniform buffer   @group(0) @binding(0), 112 bytes, for the fragment entry
//
//   byte  type   field           what goes there, little-endian
//      0  vec3f  eye             0, 2, 6: the camera's place
//     12  f32    time            seconds since the scene began
//     16  vec3f  right           0.3639702, 0, 0: the camera's right, as long as tan(fov / 2)
//     28  f32    pixel_spread    0.72794044: divided by the target's height in pixels; 0 samples patterns at points
//     32  vec3f  up              0, 0.359018, -0.059836328: the camera's up, as long as that
//     44  u32    max_bounces     5: reflections and refractions in a row
//     48  vec3f  forward         0, -0.16439898, -0.9863939: the way the camera looks, of length 1
//     60  u32    shadow_samples  16: rays to each light that has a size; 0 for no shadows
//     64  vec2f  resolution      width and height of the target, pixels
//     72  vec2f  mouse           where the pointer was last pressed, pixels from the top left
//     80  vec2f  jitter          0, 0; for many samples another offset each from the pixel's middle, -1 to 1
//     88  u32    sample          0; for many samples n
//     92  u32    view            0: only raytoy itself uses it
//     96  u32    casters         0: only raytoy itself uses it
//    100  u32    beside          0: only raytoy itself uses it
//    104  f32    divider         0: only raytoy itself uses it
//    108  f32    reach           0: only raytoy itself uses it
//
// Another camera: forward = normalize(target - eye), right = normalize(cross(forward, upwards)),
// up = cross(right, forward); then right and up times 0.36397022.
//
// To draw many samples a pixel, n = 0, 1, 2 and so on:
//   1. drawLight instead of drawPicture, to a texture of floats such as rgba16float, with sample = n, another
//      jitter, and blending: source * c + target * (1 - c), where the blend constant c is 1 / (n + 1).
//   2. coverPicture and showSamples to the screen, with that texture at @group(0) @binding(1).
//
//   objects   floor, ball
//   shapes    Plane, Sphere
//   textures  Checker, Gradient

const OBJECT_FLOOR: u32 = 0u;
const OBJECT_BALL: u32 = 1u;
const LIGHTS: u32 = 1u;
/// Whether any ray goes through a surface.
const TRANSMITS: bool = false;

/// The nearest object that `ray` meets.
fn rayTraceScene(ray: Ray) -> Hit {
    var hit = noHit(ray);
    // objects[0] "floor": Plane()
    hit = nearer(hit, plane(ray, vec3f(0.0, 1.0, 0.0), 0.0), OBJECT_FLOOR);
    // objects[1] "ball": Sphere(center: (0, 1, 0))
    hit = nearer(hit, sphere(ray, vec3f(0.0, 1.0, 0.0), 1.0), OBJECT_BALL);
    return hit;
}

/// Whether anything that casts a shadow lies on `ray`.
fn sceneBlocks(ray: Ray) -> bool {
    if plane(ray, vec3f(0.0, 1.0, 0.0), 0.0) < NO_HIT { return true; }
    if sphere(ray, vec3f(0.0, 1.0, 0.0), 1.0) < NO_HIT { return true; }
    return false;
}

/// The surface of `object` at the world point `p`.
fn surfaceAt(object: u32, p: vec3f) -> Placed {
    switch object {
        case OBJECT_FLOOR: {
            return placed(planeSurface(p, vec3f(0.0, 1.0, 0.0), 0.0), p);
        }
        case OBJECT_BALL: {
            return placed(sphereSurface(p, vec3f(0.0, 1.0, 0.0), 1.0), p);
        }
        default: {
            return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p);
        }
    }
}

/// The material of `object` at its surface point `at`.
fn materialAt(object: u32, at: Surface) -> Material {
    switch object {
        case OBJECT_FLOOR: { return floorMaterial(at); }
        case OBJECT_BALL: { return ballMaterial(at); }
        default: { return matte(vec3f(0.0)); }
    }
}

fn floorMaterial(at: Surface) -> Material {
    return matte(checker(at, 1.0, vec3f(0.2), vec3f(0.6)));
}

fn ballMaterial(at: Surface) -> Material {
    var material = matte(vec3f(1.0, 0.12477182, 0.06301002));
    material.reflectivity = 0.2;
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
        vec3f(0.10946172, 0.24620135, 0.58407843),
        vec3f(0.73791045, 0.8148466, 0.91309863),
    );
}

fn ambientLight() -> vec3f {
    return vec3f(0.1);
}

/// The light `index` as the world point `p` sees it.
fn lightAt(index: u32, p: vec3f) -> Light {
    switch index {
        // lights[0]: Point(position: (4, 6, 5), radius: 0.5)
        case 0u: { return pointLight(p, vec3f(4.0, 6.0, 5.0), 0.5, vec3f(1.0)); }
        default: { return pointLight(p, p, 0.0, vec3f(0.0)); }
    }
}

/// Light as a screen shows it, by the scene's exposure, tone map and transfer curve.
fn shown(light: vec3f) -> vec3f {
    let exposed = max(1.4142135 * light, vec3f(0.0));
    return encodedSrgb(tonedAces(exposed));
}

/// A plane without end: the points p with dot(normal, p) = offset.
///
/// normal = (0, 1, 0), nonzero: the way the plane faces; any length
/// offset = 0: distance from the origin, where the normal has length 1
fn plane(ray: Ray, normal: vec3f, offset: f32) -> f32 {
    let approach = dot(normal, ray.direction);
    if abs(approach) < 1e-20 {
        return NO_HIT;
    }
    return onRay(ray, (offset - dot(normal, ray.origin)) / approach);
}

fn planeSurface(p: vec3f, normal: vec3f, offset: f32) -> Surface {
    let size = length(normal);
    let n = normal / size;
    // A pattern in space would flicker where the plane runs along one of its borders, as y = 0
    // often does, if rounding left the point on either side.
    let snapped = p - (dot(n, p) - offset / size) * n;
    return surface(snapped, n, snapped * flatTangents(n));
}

fn planeContains(p: vec3f, normal: vec3f, offset: f32) -> bool {
    return dot(normal, p) < offset;
}

/// A ball.
/// moves with center
///
/// center = (0, 0, 0): the middle of the ball
/// radius = 1, 0.00001 to 100000: from the middle to the surface
fn sphere(ray: Ray, center: vec3f, radius: f32) -> f32 {
    let middle = nearestApproach(ray, center);
    let nearest = ray.origin - center + middle * ray.direction;
    let inside = radius * radius - dot(nearest, nearest);
    if inside < 0.0 {
        return NO_HIT;
    }
    // Seen from the nearest approach the chord is symmetric, so nothing cancels
    // (Haines et al., Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems ch. 7).
    let reach = sqrt(inside / dot(ray.direction, ray.direction));
    return firstOnRay(ray, middle - reach, middle + reach);
}

fn sphereSurface(p: vec3f, center: vec3f, radius: f32) -> Surface {
    let normal = normalize(p - center);
    // WGSL leaves atan2 open where its second argument is 0: the poles and the meridian above z.
    let longitude = atan2(normal.z, select(normal.x, 1e-20, abs(normal.x) < 1e-20));
    // Unlike asin, this keeps its digits near the poles.
    let latitude = atan2(normal.y, max(length(normal.xz), 1e-20));
    var at = surface(center + radius * normal, normal, radius * vec2f(longitude, latitude));
    // Seen from outside, longitude grows to the left.
    at.whole = 1.5707963 * radius * vec4f(2.0, -1.0, -4.0, 2.0);
    return at;
}

/// A checkerboard of two colors that blurs to their mean in the distance instead of flickering.
///
/// scale = 1, 0.01 to 100: squares per scene unit
/// even = "#ece6d8": color where floor(scale u) + floor(scale v) is even
/// odd = "#39424e": color of the other squares
fn checker(at: Surface, scale: f32, even: vec3f, odd: vec3f) -> vec3f {
    // The sign of a checkerboard is the product of two stripes' signs, and so is its integral.
    let half_scale = 0.5 * scale;
    let side = 2.0 * dutyShare(at.uv * half_scale, vec2f(at.footprint * half_scale), 0.5) - 1.0;
    let share = 0.5 + 0.5 * side.x * side.y;
    return even * share + odd * (1.0 - share);
}

/// A clear sky: the horizon's color at and below eye level, the zenith's straight above.
///
/// zenith = "#5d88c9": color straight up
/// horizon = "#e6eef6": color at and below the horizon
fn gradient(at: Surface, zenith: vec3f, horizon: vec3f) -> vec3f {
    // As a background, the position is the direction of the ray.
    let height = clamp(at.position.y, 0.0, 1.0);
    return horizon * (1.0 - height) + zenith * height;
}

// What textures share: integer hashes, noise over them, and the box filter of a periodic pattern.
// No hash goes through sin: its digits are the driver's own, and so would the picture be.

/// Keeps the zeros of one octave off the zeros of the next, and floors and walls off the lattice's
/// own planes: the rotation of the quaternion (6, 1, 2, 3), whose entries are short decimals.
const OCTAVE_TURN = mat3x3f(0.48, 0.8, -0.36, -0.64, 0.6, 0.48, 0.6, 0.0, 0.8);
const OCTAVE_SHIFT = vec3f(7.31, -3.57, 5.83);

/// Random bits for the corners of a lattice cell, x before y; `far` lies one up in z.
struct Corners { near: vec4u, far: vec4u }

/// One step of PCG-RXS-M-XS (Jarzynski and Olano, Hash Functions for GPU Rendering, 2020).
fn pcg(v: vec4u) -> vec4u {
    let state = v * 747796405u + 2891336453u;
    let word = ((state >> ((state >> vec4u(28u)) + 4u)) ^ state) * 277803737u;
    return (word >> vec4u(22u)) ^ word;
}

/// `cell` holds whole numbers of either sign; the bitcast keeps the negative ones apart.
fn cellCorners(cell: vec3f) -> Corners {
    let base = bitcast<vec3u>(vec3i(cell));
    let x = vec2u(base.x, base.x + 1u) * 0x9e3779b1u;
    let y = vec2u(base.y, base.y + 1u) * 0x85ebca77u;
    let z = vec2u(base.z, base.z + 1u) * 0xc2b2ae3du;
    let column = x.xyxy ^ y.xxyy;
    return Corners(pcg(column ^ z.xxxx), pcg(column ^ z.yyyy));
}

/// Ten bits of each word as numbers in -1 to 1: one hash is worth three of them.
fn tenBits(word: vec4u, shift: u32) -> vec4f {
    return vec4f((word >> vec4u(shift)) & vec4u(1023u)) / 511.5 - 1.0;
}

fn cornerMix(near: vec4f, far: vec4f, f: vec3f) -> f32 {
    // Perlin, Improving Noise, 2002: no jump in the second derivative, so none in a bump.
    let share = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    let row = mix(near, far, share.z);
    let pair = mix(row.xy, row.zw, share.y);
    return mix(pair.x, pair.y, share.x);
}

/// Gradient noise in 0 to 1, mean 0.5, about one feature per unit.
fn perlinNoise(p: vec3f) -> f32 {
    let f = p - floor(p);
    let g = f - 1.0;
    let c = cellCorners(floor(p));
    let x = vec4f(f.x, g.x, f.x, g.x);
    let y = vec4f(f.y, f.y, g.y, g.y);
    let near = tenBits(c.near, 0u) * x + tenBits(c.near, 10u) * y + tenBits(c.near, 20u) * f.z;
    let far = tenBits(c.far, 0u) * x + tenBits(c.far, 10u) * y + tenBits(c.far, 20u) * g.z;
    // Gradient noise seldom leaves the middle of its range: spread it, without ever clipping.
    let spread = 3.0 * cornerMix(near, far, f);
    return 0.5 + 0.5 * spread * inverseSqrt(1.0 + spread * spread);
}

/// Three independent smooth noises in -1 to 1, mean 0: a displacement.
fn vectorNoise(p: vec3f) -> vec3f {
    let f = p - floor(p);
    let c = cellCorners(floor(p));
    return vec3f(
        cornerMix(tenBits(c.near, 0u), tenBits(c.far, 0u), f),
        cornerMix(tenBits(c.near, 10u), tenBits(c.far, 10u), f),
        cornerMix(tenBits(c.near, 20u), tenBits(c.far, 20u), f),
    );
}

/// `b` where `which` is true, else `a`: select, which GLSL ES 3.00 has only for numbers with a fraction.
fn chosenBits(a: vec4u, b: vec4u, which: vec4<bool>) -> vec4u {
    return a ^ ((a ^ b) & (vec4u(0u) - vec4u(which)));
}

/// How much of the interval of `width` around x has fract(x) < duty, in closed form.
fn dutyShare(x: vec2f, width: vec2f, duty: f32) -> vec2f {
    let f = x - floor(x);
    let a = f - 0.5 * width;
    let b = f + 0.5 * width;
    let w = max(width, vec2f(1e-20));
    let ends = min(b - floor(b), vec2f(duty)) - min(a - floor(a), vec2f(duty));
    let wide = ((floor(b) - floor(a)) * duty + ends) / w;
    // The integrals' difference loses its digits as the width shrinks; the way to an edge does not.
    let inside = f < vec2f(duty);
    let edge = select(max(duty - f, f - 1.0), min(f, duty - f), inside);
    let narrow = clamp(0.5 + edge / w, vec2f(0.0), vec2f(1.0));
    let soft = select(wide, narrow, width < vec2f(min(duty, 1.0 - duty)));
    return select(soft, vec2f(inside), width == vec2f(0.0));
}

// The entry points of a scene on its own. Its head says what a host has to give them.

@group(0) @binding(0) var<uniform> frame: Frame;

/// The mean of all samples, from drawLight.
@group(0) @binding(1) var samples: texture_2d<f32>;

/// One sample, as a screen shows it.
@fragment
fn drawPicture(covered: Covered) -> @location(0) vec4f {
    zero = covered.zero;
    return vec4f(shown(seenAt(covered.pixel.xy).radiance), 1.0);
}

/// One sample, as linear light.
@fragment
fn drawLight(covered: Covered) -> @location(0) vec4f {
    zero = covered.zero;
    return vec4f(seenAt(covered.pixel.xy).radiance, 1.0);
}

/// All samples, as a screen shows them.
@fragment
fn showSamples(covered: Covered) -> @location(0) vec4f {
    return vec4f(shown(textureLoad(samples, vec2u(covered.pixel.xy), 0).rgb), 1.0);
}

// A triangle that covers the picture.

struct Covered {
    @builtin(position) pixel: vec4f,
    @location(0) @interpolate(flat) zero: u32,
}

@vertex
fn coverPicture(@builtin(vertex_index) corner: u32) -> Covered {
    let place = vec4f(f32(corner & 1u) * 4.0 - 1.0, f32(corner >> 1u) * 4.0 - 1.0, 0.0, 1.0);
    // A triangle has no corner above 2.
    return Covered(place, corner >> 2u);
}

// In place of view.wgsl where a scene stands on its own: its picture shows the light and nothing else.

fn surfaceView(hit: Hit, met: Placed, n: vec3f, v: vec3f, albedo: vec3f, visibility: f32) -> vec3f {
    return vec3f(0.0);
}

// Tone maps, which bring light of any strength to what a screen has, and the transfer curve of screens.

/// Reinhard et al., Photographic Tone Reproduction for Digital Images, 2002.
fn tonedReinhard(light: vec3f) -> vec3f {
    return light / (1.0 + light);
}

/// Narkowicz, ACES Filmic Tone Mapping Curve, 2016.
fn tonedAces(x: vec3f) -> vec3f {
    return clamp((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), vec3f(0.0), vec3f(1.0));
}

/// Sobotka's AgX with Wrensch's polynomial for its curve (Minimal AgX Implementation, 2023).
fn tonedAgx(light: vec3f) -> vec3f {
    let inset = mat3x3f(
        0.842479062253094, 0.0423282422610123, 0.0423756549057051,
        0.0784335999999992, 0.878468636469772, 0.0784336,
        0.0792237451477643, 0.0791661274605434, 0.879142973793104,
    );
    let outset = mat3x3f(
        1.19687900512017, -0.0528968517574562, -0.0529716355144438,
        -0.0980208811401368, 1.15190312990417, -0.0980434501171241,
        -0.0990297440797205, -0.0989611768448433, 1.15107367264116,
    );
    let x = (clamp(log2(max(inset * light, vec3f(1e-10))), vec3f(-12.47393), vec3f(4.026069))
        + 12.47393) / 16.5;
    let curve = ((((15.5 * x - 40.14) * x + 31.96) * x - 6.868) * x + 0.4298) * x * x + 0.1191 * x - 0.00232;
    return pow(clamp(outset * curve, vec3f(0.0), vec3f(1.0)), vec3f(2.2));
}

/// The transfer curve of sRGB (IEC 61966-2-1).
fn encodedSrgb(light: vec3f) -> vec3f {
    let low = light * 12.92;
    let high = 1.055 * pow(light, vec3f(1.0 / 2.4)) - 0.055;
    return select(high, low, light <= vec3f(0.0031308));
}

// A pixel: its ray, and what that sees.

/// What a pixel sees: its light, and what its first ray met.
struct Seen {
    radiance: vec3f,
    /// Along the first ray, scene units; negative where it leaves the scene.
    depth: f32,
    /// What a debug view shows of the first surface.
    value: vec3f,
    object: u32,
    /// Depth of the deepest ray.
    bounces: u32,
}

/// What this sample sees of the pixel with its middle at `pixel`, which counts from the top left corner.
fn seenAt(pixel: vec2f) -> Seen {
    let place = (2.0 * (pixel + frame.jitter) / frame.resolution - 1.0)
        * vec2f(frame.resolution.x / frame.resolution.y, -1.0);
    let direction = normalize(frame.forward + place.x * frame.right + place.y * frame.up);
    let at = vec2u(pixel);
    seed = hashed(at.x + hashed(at.y + hashed(frame.sample)));
    return traceTree(frame.eye, direction);
}

// The tree of rays that a pixel sends, walked in a loop.

/// Follows a ray of length 1 from `origin` and all that it splits into.
fn traceTree(origin: vec3f, direction: vec3f) -> Seen {
    var seen = Seen(vec3f(0.0), -1.0, vec3f(0.0), NO_OBJECT, 0u);
    var waiting: array<Branch, MAX_WAITING>;
    var waits = 0u;
    var branch = Branch(origin, 1.0, direction, 0.0, AIR, 0u);
    for (var rays = 0u; rays < MAX_RAYS; rays++) {
        let ray = Ray(branch.origin, 0.0, branch.direction, NO_HIT);
        let hit = rayTraceScene(ray);
        let depth = branch.depth;
        seen.bounces = max(seen.bounces, depth);
        var follows = false;
        if hit.object == NO_OBJECT {
            seen.radiance += branch.weight * background(branch.direction);
        } else {
            let v = -branch.direction;
            let width = branch.width + frame.pixel_spread * hit.t;
            let seen_there = looked(ray, hit, width);
            let p = seen_there.point;
            let met = seen_there.met;
            let material = seen_there.material;
            let inside = dot(met.facet, v) < 0.0;
            let facing = select(met.facet, -met.facet, inside);
            var n = normalAt(hit.object, met);
            n = select(n, -n, inside);
            // A bump may tilt the normal away from the viewer, who then sees the slope edge on.
            n = normalize(n + max(0.001 - dot(n, v), 0.0) * v);
            // Back along the ray, too: where walls meet, rounding may put the point behind the other one.
            let outside = spawnPoint(p, facing + v - dot(facing, v) * facing, hit.t);
            // Light falls on the smooth surface, or it would end in steps along the triangles.
            let rise = select(met.rise, 0.0, inside) * met.facet;
            let shaded = shade(p + rise, outside + rise, n, v, material);
            if depth == 0u {
                seen.depth = hit.t;
                seen.object = hit.object;
                seen.value = surfaceView(hit, met, n, v, material.color, shaded.visibility);
            }

            let mirror = mirrored(material, clamp(dot(n, v), 0.0, 1.0));
            let stays = branch.weight * (1.0 - mirror);
            seen.radiance += stays * (1.0 - material.transmission) * shaded.light;
            let deeper = depth < frame.max_bounces + zero;
            let reflection = branch.weight * mirror;
            let refraction = stays * material.transmission;
            let reflects = deeper && reflection >= MIN_WEIGHT;
            let refracts = TRANSMITS && deeper && refraction >= MIN_WEIGHT;
            let into = branch.direction;
            let media = branch.media;
            if reflects {
                var away = reflect(into, n);
                // Where light sees another surface than rays meet, a mirror may point into it.
                away = normalize(away + max(0.001 - dot(away, facing), 0.0) * facing);
                branch = Branch(outside, reflection, away, width, media, depth + 1u);
            }
            if refracts {
                let through = refracted(into, n, indexRatio(media, material.ior, inside));
                let is_mirrored = dot(through, facing) > 0.0;
                let start = spawnPoint(p, select(-facing, facing, is_mirrored), hit.t);
                let behind = select(mediaBehind(media, material.ior, inside), media, is_mirrored);
                let beyond = Branch(start, refraction, through, width, behind, depth + 1u);
                var heavier = beyond;
                if !reflects || reflection > refraction {
                    heavier = branch;
                    branch = beyond;
                }
                if reflects {
                    waiting[waits] = heavier;
                    waits++;
                }
            }
            follows = reflects || refracts;
        }
        if !follows {
            if !TRANSMITS || waits == 0u {
                break;
            }
            waits--;
            branch = waiting[waits];
        }
    }
    return seen;
}

// The branches of the tree of rays, and how many there may be.

/// The most rays that a pixel may send. Weights alone bound the tree; this bounds it for the driver too.
const MAX_RAYS: u32 = 1024u;

/// The lighter of two branches goes on, with half the weight at most, and the heavier waits: since
/// weights end at MIN_WEIGHT, no more than log2(512) ever do.
const MAX_WAITING: u32 = 9u;

/// A ray still to be followed.
struct Branch {
    origin: vec3f,
    /// Share of the picture that it carries.
    weight: f32,
    /// Length 1.
    direction: vec3f,
    /// Width of the pixel where the ray starts.
    width: f32,
    /// What it travels in: see `mediaBehind`.
    media: vec4f,
    depth: u32,
}

// The media that a ray is in: glass in water, an air bubble in glass.

/// No medium but the air around the scene.
const AIR: vec4f = vec4f(1.0);

/// The media after a ray inside of `media` has gone through a surface of index `ior`. They are indices of
/// refraction, the innermost first. Those that a ray entered longest ago are forgotten beyond four.
fn mediaBehind(media: vec4f, ior: f32, leaves: bool) -> vec4f {
    if !leaves {
        return vec4f(ior, media.xyz);
    }
    // A ray leaves the innermost medium of that index. Where it entered none, as from a camera in glass or by
    // a part of another index, it leaves the innermost of all.
    let is_it = media == vec4f(ior);
    if !is_it.x && is_it.y {
        return vec4f(media.x, media.zw, 1.0);
    }
    if !is_it.x && is_it.z {
        return vec4f(media.xy, media.w, 1.0);
    }
    if !is_it.x && is_it.w {
        return vec4f(media.xyz, 1.0);
    }
    return vec4f(media.yzw, 1.0);
}

/// The index of refraction before the surface over the one behind it.
fn indexRatio(media: vec4f, ior: f32, leaves: bool) -> f32 {
    let is_known = !leaves || any(media == vec4f(ior));
    return select(ior, media.x, is_known) / mediaBehind(media, ior, leaves).x;
}

// What a pixel sees of a surface: the material, as a mean over the pixel's footprint.

/// The most looks that a pixel takes at one surface.
const MOST_LOOKS: u32 = 9u;

/// A surface and its material as a pixel sees them.
struct Looked {
    /// In world space.
    point: vec3f,
    met: Placed,
    material: Material,
}

/// What `ray` meets at `hit`, where it is `width` wide. Seen at a slant the footprint is long: several looks
/// along it, each about square, do not blur across it.
fn looked(ray: Ray, hit: Hit, width: f32) -> Looked {
    var seen: Looked;
    seen.point = rayPoint(ray, hit.t);
    var corrected = false;
    var footprint = 0.0;
    var step = vec3f(0.0);
    var looks = 1u;
    var look = 0u;
    while look < looks {
        // 0, 1, -1, 2, -2, …
        let place = f32((look + 1u) / 2u) * select(-1.0, 1.0, (look & 1u) == 1u);
        let there = surfaceAt(hit.object, seen.point + place * step);
        if !corrected {
            corrected = true;
            let slip = slipAlong(ray, hit.t, there);
            if length(slip) > MOST_SLIP * length(seen.point) {
                seen.point += slip;
                continue;
            }
        }
        if look == 0u {
            seen.met = there;
            let cosine = max(abs(dot(there.normal, ray.direction)), 0.02);
            let along = ray.direction - dot(ray.direction, there.normal) * there.normal;
            let wanted = 2u * u32(0.5 / cosine) + 1u;
            let varies = width > 0.0 && isTextured(hit.object);
            looks = select(1u, min(wanted, MOST_LOOKS), varies) + zero;
            step = along / max(length(along), 1e-6) * width / (cosine * f32(looks));
            footprint = max(width, width / (cosine * f32(looks))) * there.scale;
            seen.met.at.footprint = width * there.scale / cosine;
        }
        var at = there.at;
        at.footprint = footprint;
        seen.material = summed(seen.material, materialAt(hit.object, at));
        look++;
    }
    seen.material = meanOf(seen.material, 1.0 / f32(looks));
    return seen;
}

// Where a ray meets a surface, from near and far.

/// How far beside the surface a point may lie, as a share of its way from the world's origin.
const MOST_SLIP: f32 = 1e-6;

/// The bits of a number that its first twelve digits are in.
const HIGH_HALF: u32 = 0xfffff000u;

/// The ray's point at `t`.
fn rayPoint(ray: Ray, t: f32) -> vec3f {
    return rayPointFrom(ray, t, vec3f(0.0));
}

/// The same as seen from `center`. Far from the ray's origin the product needs more digits than a number has.
/// So the factors are cut in halves, whose products are exact (after Dekker, A Floating-Point Technique,
/// 1971). With fma it would be one line, but Mesa's software driver rounds twice there too.
fn rayPointFrom(ray: Ray, t: f32, center: vec3f) -> vec3f {
    let t_high = bitcast<f32>(bitcast<u32>(t) & HIGH_HALF);
    let t_low = t - t_high;
    let high = bitcast<vec3f>(bitcast<vec3u>(ray.direction) & vec3u(HIGH_HALF));
    let low = ray.direction - high;
    let way = t_high * high;
    // What is left of two large numbers is exact, so the two that leave less come first.
    let there = ray.origin + way;
    let apart = ray.origin - center;
    let point = select(there - center, apart + way, abs(apart) < abs(there));
    return point + t_low * high + t_high * low + t_low * low;
}

/// The way along `ray` from its point at `t` to the surface `there`, which was asked for at that point: a
/// step of Newton's method. From far away t itself has too few digits for it.
fn slipAlong(ray: Ray, t: f32, there: Placed) -> vec3f {
    let approach = dot(there.facet, ray.direction);
    let slip = there.gap / select(approach, 1e-20, abs(approach) < 1e-20);
    // More than its rounding it cannot be; what is more comes of a surface seen edge on.
    let most = 4e-6 * t;
    return clamp(slip, -most, most) * ray.direction;
}

// Light at a surface: Blinn-Phong from each light that the surface sees.

/// A branch of the ray tree that would add less than this share of the picture is cut.
const MIN_WEIGHT: f32 = 1.0 / 512.0;

/// Offset of new rays from the surface, as a share of the numbers that were added up to find it.
const SPAWN_ERROR: f32 = 1e-5;

/// Different in each pixel and each sample of it.
var<private> seed: u32;

/// What a surface sends towards a viewer, mirrors and glass aside.
struct Shade {
    light: vec3f,
    /// Unblocked share of the lights that the surface faces, 0 to 1.
    visibility: f32,
}

/// An integer hash (PCG; Jarzynski and Olano, Hash Functions for GPU Rendering, 2020).
fn hashed(x: u32) -> u32 {
    let state = x * 747796405u + 2891336453u;
    let word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

/// A point off the surface on the side that `normal` shows, so that a ray from it does not meet it again.
fn spawnPoint(p: vec3f, normal: vec3f, t: f32) -> vec3f {
    let size = max(max(abs(p.x), abs(p.y)), max(abs(p.z), t));
    return p + SPAWN_ERROR * size * normal;
}

/// The light that `material` at world point `p` sends along `v`. `n` faces the viewer.
fn shade(p: vec3f, origin: vec3f, n: vec3f, v: vec3f, material: Material) -> Shade {
    var sum = material.emission + ambientLight() * material.color;
    var visible = 0.0;
    var facing = 0.0;
    for (var i = 0u; i < LIGHTS; i++) {
        let light = lightAt(i, p);
        let l = normalize(light.to);
        let cosine = dot(n, l);
        if cosine > 0.0 && max(max(light.arriving.x, light.arriving.y), light.arriving.z) > 0.0 {
            let share = visibleShare(light, origin);
            let h = normalize(l + v);
            let highlight = material.specular * pow(max(dot(n, h), 0.0), material.shininess);
            sum += share * light.arriving * (material.color * cosine + highlight);
            visible += share;
            facing += 1.0;
        }
    }
    return Shade(sum, visible / max(facing, 1.0));
}

// Lights as one point of the scene sees them.

/// A light's centre from a point, and the area around it.
struct Light {
    /// From the point to the light's centre; length 1 where the light is infinitely far.
    to: vec3f,
    /// The t along `to` at which the light stands.
    reach: f32,
    /// What arrives where nothing is in the way: color · intensity · falloff.
    arriving: vec3f,
    /// Radius of a round light, which shows its disk; negative for a parallelogram.
    radius: f32,
    /// Half the sides of a parallelogram.
    u: vec3f,
    v: vec3f,
}

/// A ball of light, or a point where radius is 0.
fn pointLight(p: vec3f, position: vec3f, radius: f32, color: vec3f) -> Light {
    return Light(position - p, 1.0, color, radius, vec3f(0.0), vec3f(0.0));
}

/// Light that travels along `direction`, from a disk of the sky whose half angle has `spread` as its tangent.
fn directionalLight(direction: vec3f, spread: f32, color: vec3f) -> Light {
    return Light(-direction, NO_HIT, color, spread, vec3f(0.0), vec3f(0.0));
}

/// A point light that shines into a cone, full inside the cosine `inner`, dark outside `outer`.
fn spotLight(
    p: vec3f,
    position: vec3f,
    radius: f32,
    axis: vec3f,
    inner: f32,
    outer: f32,
    color: vec3f,
) -> Light {
    var light = pointLight(p, position, radius, color);
    let x = clamp((dot(-normalize(light.to), axis) - outer) / max(inner - outer, 1e-6), 0.0, 1.0);
    light.arriving *= x * x * (3.0 - 2.0 * x);
    return light;
}

/// A shining parallelogram.
fn rectLight(p: vec3f, corner: vec3f, u: vec3f, v: vec3f, color: vec3f) -> Light {
    return Light(corner + 0.5 * (u + v) - p, 1.0, color, -1.0, 0.5 * u, 0.5 * v);
}

/// The same light, weaker by the square of its distance.
fn inverseSquare(light: Light) -> Light {
    var weaker = light;
    weaker.arriving /= max(dot(light.to, light.to), 1e-12);
    return weaker;
}

/// The share of `light` that reaches `origin`.
fn visibleShare(light: Light, origin: vec3f) -> f32 {
    let rays = frame.shadow_samples + zero;
    let n = select(rays, min(rays, 1u), light.radius == 0.0);
    if n == 0u {
        return 1.0;
    }
    let round = light.radius >= 0.0;
    let facing = frameAround(normalize(light.to));
    let u = select(light.u, light.radius * facing[0], round);
    let v = select(light.v, light.radius * facing[1], round);
    // Another turn of the points in each pixel. Its angles are not quite even, which nobody sees.
    let turn = vec2f(f32(seed & 0xffffu), f32(seed >> 16u)) / 65536.0;
    var spoke = normalize(turn - 0.5 + 1e-6);
    // Each ray asks them all, or stops at one; to count that would cost too much.
    work += n * frame.casters;
    var open = 0.0;
    for (var i = 0u; i < n; i++) {
        // A sunflower's seeds on the disk (Vogel, 1979), the R2 sequence on the parallelogram
        // (Roberts, The Unreasonable Effectiveness of Quasirandom Sequences, 2018).
        spoke = -0.73736888 * spoke + 0.67549029 * vec2f(-spoke.y, spoke.x);
        let disk = sqrt((f32(i) + turn.x) / f32(n)) * spoke;
        let square = 2.0 * fract(turn + f32(i) * vec2f(0.7548776662, 0.5698402910)) - 1.0;
        let on = select(square, disk, round);
        let ray = Ray(origin, 0.0, light.to + on.x * u + on.y * v, light.reach);
        open += select(1.0, 0.0, sceneBlocks(ray));
    }
    return open / f32(n);
}

// What a surface does with light.

/// The value of `fresnel` that leaves reflectivity alone.
const NO_FRESNEL: f32 = -1.0;

struct Material {
    /// Diffuse color, linear RGB.
    color: vec3f,
    specular: f32,
    /// Light of its own, linear RGB.
    emission: vec3f,
    /// Blinn-Phong exponent.
    shininess: f32,
    /// Share of light that is mirrored, head on.
    reflectivity: f32,
    /// Exponent by which the mirrored share grows towards grazing angles, or NO_FRESNEL.
    fresnel: f32,
    /// Share of what is not mirrored that passes through.
    transmission: f32,
    /// Index of refraction inside.
    ior: f32,
}

/// Matte: what a material is where the author says nothing else.
fn matte(color: vec3f) -> Material {
    return Material(color, 0.0, vec3f(0.0), 50.0, 0.0, NO_FRESNEL, 0.0, 1.5);
}

/// The sum of what may vary over a surface; the rest is that of `b`.
fn summed(a: Material, b: Material) -> Material {
    return Material(
        a.color + b.color,
        a.specular + b.specular,
        a.emission + b.emission,
        a.shininess + b.shininess,
        a.reflectivity + b.reflectivity,
        b.fresnel,
        a.transmission + b.transmission,
        b.ior,
    );
}

/// A sum of materials as their mean, where `share` is one over their number.
fn meanOf(sum: Material, share: f32) -> Material {
    return Material(
        share * sum.color,
        share * sum.specular,
        share * sum.emission,
        share * sum.shininess,
        share * sum.reflectivity,
        sum.fresnel,
        share * sum.transmission,
        sum.ior,
    );
}

/// The mirrored share of light that arrives at `cosine` from the normal.
fn mirrored(material: Material, cosine: f32) -> f32 {
    let r = material.reflectivity;
    if material.fresnel < 0.0 {
        return r;
    }
    return r + (1.0 - r) * pow(max(1.0 - cosine, 0.0), material.fresnel);
}

/// The direction in which a ray goes on through the surface by Snell's law; the mirrored one under
/// total internal reflection. `normal` faces the ray, `ratio` is the index before over the one behind.
fn refracted(direction: vec3f, normal: vec3f, ratio: f32) -> vec3f {
    let cosine = -dot(direction, normal);
    let k = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
    if k < 0.0 {
        return reflect(direction, normal);
    }
    return ratio * direction + (ratio * cosine - sqrt(k)) * normal;
}

/// Brightness of a linear color (Rec. 709).
fn luminance(color: vec3f) -> f32 {
    return dot(color, vec3f(0.2126, 0.7152, 0.0722));
}

// Moved objects: the ray goes into the object's space, its surface comes back.

/// The affine map from the world into an object's space, by rows.
struct Space {
    x: vec4f,
    y: vec4f,
    z: vec4f,
}

/// A point of an object: its own view of it, and the world's.
struct Placed {
    at: Surface,
    /// Outward, length 1, in world space: what light sees, and what tells inside from outside.
    normal: vec3f,
    facet: vec3f,
    /// Object units to a unit of the world, about.
    scale: f32,
    /// From the point that was asked for to the surface, along `facet`.
    gap: f32,
    /// From there to the smooth surface that light sees.
    rise: f32,
}

fn pointInto(space: Space, p: vec3f) -> vec3f {
    let q = vec4f(p, 1.0);
    return vec3f(dot(space.x, q), dot(space.y, q), dot(space.z, q));
}

/// The same ray in an object's space. Its t is the world's, so its direction changes length.
fn rayInto(space: Space, ray: Ray) -> Ray {
    let d = vec4f(ray.direction, 0.0);
    let direction = vec3f(dot(space.x, d), dot(space.y, d), dot(space.z, d));
    return Ray(pointInto(space, ray.origin), ray.t_min, direction, ray.t_max);
}

/// A surface at `p` of an object that stands in the world as its shape describes it.
fn placed(at: Surface, p: vec3f) -> Placed {
    return Placed(at, at.normal, at.facet, 1.0, dot(at.position - p, at.facet), at.rise);
}

/// A surface of a moved object. A normal goes back by the transpose of the map that points come by.
fn placedFrom(space: Space, at: Surface, world: vec3f) -> Placed {
    let to_world = mat3x3f(space.x.xyz, space.y.xyz, space.z.xyz);
    let volume = abs(dot(space.x.xyz, cross(space.y.xyz, space.z.xyz)));
    var seen = at;
    seen.world = world;
    let normal = normalize(to_world * at.normal);
    let facet = to_world * at.facet;
    let unit = 1.0 / length(facet);
    let gap = dot(at.position - pointInto(space, world), at.facet) * unit;
    return Placed(seen, normal, facet * unit, pow(volume, 1.0 / 3.0), gap, at.rise * unit);
}

/// The point of the unit sphere in `direction`, which is where a background is asked for its color.
fn skyPoint(direction: vec3f) -> Surface {
    let uv = vec2f(atan2(direction.z, direction.x), asin(clamp(direction.y, -1.0, 1.0)));
    var at = surface(direction, direction, uv);
    at.whole = 1.5707963 * vec4f(-2.0, -1.0, 4.0, 2.0);
    return at;
}

/// The t at which a ray's line enters the box between two corners, and leaves it: in the wrong order if it
/// misses.
fn spanInBounds(ray: Ray, low: vec3f, high: vec3f) -> vec2f {
    let tiny = vec3f(1e-20);
    let d = select(ray.direction, tiny, abs(ray.direction) < tiny);
    let a = (low - ray.origin) / d;
    let b = (high - ray.origin) / d;
    let near = min(a, b);
    let far = max(a, b);
    return vec2f(max(max(near.x, near.y), near.z), min(min(far.x, far.y), far.z));
}

/// Whether a ray comes through the box between two corners.
fn meetsBounds(ray: Ray, low: vec3f, high: vec3f) -> bool {
    let span = spanInBounds(ray, low, high);
    // Two units in the last place close the gaps that rounding leaves (Ize, Robust BVH Ray Traversal, 2013).
    return max(span.x, ray.t_min) <= min(1.0000004 * span.y, ray.t_max);
}

// Where a ray meets the scene first.

/// Where a ray meets the scene, and which object.
struct Hit {
    t: f32,
    object: u32,
    /// What the rounding of the ray's origin may do to a t.
    slack: f32,
}

/// No object: the ray leaves the scene.
const NO_OBJECT: u32 = 0xffffffffu;

/// Crossings closer than this share of what they are made of are at one place: rounding must not choose.
const SAME_PLACE: f32 = 4e-6;

/// What the rounding of the origin of `ray` may do to a t.
fn slackOf(ray: Ray) -> f32 {
    let origin = abs(ray.origin);
    let direction = abs(ray.direction);
    let size = max(max(origin.x, origin.y), origin.z);
    return SAME_PLACE * size / max(max(direction.x, direction.y), direction.z);
}

fn noHit(ray: Ray) -> Hit {
    return Hit(ray.t_max, NO_OBJECT, slackOf(ray));
}

/// The nearer of `hit` and a crossing of `object` at `t`. Where two surfaces coincide, the first object of
/// the scene has it, or they would be speckled.
fn nearer(hit: Hit, t: f32, object: u32) -> Hit {
    work++;
    if t < hit.t * (1.0 - SAME_PLACE) - hit.slack {
        return Hit(t, object, hit.slack);
    }
    return hit;
}

// Rays, surfaces, and the few steps that every shape takes with them.

/// What a shape returns for a ray that it does not meet; every real t is smaller.
const NO_HIT: f32 = 1e30;

/// The points origin + t·direction with t_min < t < t_max.
/// direction need not have length 1: t counts in it.
struct Ray {
    origin: vec3f,
    t_min: f32,
    direction: vec3f,
    t_max: f32,
}

/// A point of a surface, as a texture sees it.
struct Surface {
    /// In the object's space, scene units.
    position: vec3f,
    /// Outward, length 1, in the object's space: of the smooth surface, where a model stands for one.
    normal: vec3f,
    /// The same of the surface itself, by which inside is told from outside.
    facet: vec3f,
    /// On the surface, scene units where the surface can be unrolled.
    uv: vec2f,
    /// The same point in world space.
    world: vec3f,
    /// Width of a pixel at the point, in the object's units; 0 when unknown.
    footprint: f32,
    /// The uv of a whole surface, where that has an end: the corner at which a picture that covers it has
    /// its lower left one, and from there the way to the upper right one, in which u is negative where it
    /// grows to the left. Else all is 0.
    whole: vec4f,
    /// How high above the point, along facet, the smooth surface lies that a model stands for.
    rise: f32,
}

/// What the pixel's rays have cost so far: tests of shapes, boxes and triangles of models, steps of marches.
var<private> work: u32;

/// The surface at `position`, before anything is known of the world and the pixel.
fn surface(position: vec3f, normal: vec3f, uv: vec2f) -> Surface {
    return Surface(position, normal, normal, uv, position, 0.0, vec4f(0.0), 0.0);
}

/// `t` where it lies on the ray, else NO_HIT.
fn onRay(ray: Ray, t: f32) -> f32 {
    return select(NO_HIT, t, t > ray.t_min && t < ray.t_max);
}

/// The first of two ordered crossings that lies on the ray: `near` from outside, `far` from inside.
fn firstOnRay(ray: Ray, near: f32, far: f32) -> f32 {
    return onRay(ray, select(far, near, near > ray.t_min));
}

/// The t of the ray's point nearest to `center`. Solve for t from there: a root near zero keeps its digits.
fn nearestApproach(ray: Ray, center: vec3f) -> f32 {
    // The reciprocal is one for all shapes that a ray is asked about.
    return dot(center - ray.origin, ray.direction) * (1.0 / dot(ray.direction, ray.direction));
}

/// A right-handed frame whose columns are two tangents and `axis`, which has length 1
/// (Duff et al., Building an Orthonormal Basis, Revisited, 2017).
fn frameAround(axis: vec3f) -> mat3x3f {
    let s = select(-1.0, 1.0, axis.z >= 0.0);
    let a = -1.0 / (s + axis.z);
    let b = axis.x * axis.y * a;
    return mat3x3f(
        vec3f(1.0 + s * axis.x * axis.x * a, s * b, -s * axis.x),
        vec3f(b, s + axis.y * axis.y * a, -axis.y),
        axis,
    );
}

/// The directions of u and v on a flat surface. Along y: x and z. Along x: z and y. Along z: x and y.
/// Tilted: these, laid into the surface.
fn flatTangents(n: vec3f) -> mat2x3f {
    let a = abs(n);
    let level = a.y >= max(a.x, a.z);
    let first = select(vec3f(1.0, 0.0, 0.0), vec3f(0.0, 0.0, 1.0), !level && a.x > a.z);
    let second = select(vec3f(0.0, 1.0, 0.0), vec3f(0.0, 0.0, 1.0), level);
    let u = normalize(first - dot(first, n) * n);
    let v = cross(n, u);
    return mat2x3f(u, select(v, -v, dot(v, second) < 0.0));
}

// What changes from one picture to the next: the camera, the clock, the mouse. In raytoy, gpu/uniforms.rs
// fills it.

struct Frame {
    /// The camera's place, world space.
    eye: vec3f,
    /// Seconds since the scene began.
    time: f32,
    /// The camera's axes in world space; right and up are as long as tan(fov / 2).
    right: vec3f,
    /// Width that a pixel gains with each unit of distance; 0 when textures are not to be filtered.
    pixel_spread: f32,
    up: vec3f,
    max_bounces: u32,
    forward: vec3f,
    /// Shadow rays for a light with a size; 0 when nothing casts a shadow.
    shadow_samples: u32,
    /// Width and height of the picture, pixels.
    resolution: vec2f,
    /// Where the pointer was last pressed, pixels from the top left.
    mouse: vec2f,
    /// Where in its pixel this sample lies, from the centre, pixels.
    jitter: vec2f,
    /// How many samples the picture holds already.
    sample: u32,
    /// Which of raytoy's debug views to draw; 0 is the picture.
    view: u32,
    /// Bodies that cast shadows.
    casters: u32,
    /// The debug view right of the divider.
    beside: u32,
    /// Where that begins, pixels from the left.
    divider: f32,
    /// The number at which the colors of a view of numbers end.
    reach: f32,
}

/// Nothing, but no driver knows it. Mesa's software driver compiles a shader again for each draw if plain
/// uniforms steer its branches and loops; one that has this added is not plain.
var<private> zero: u32;
