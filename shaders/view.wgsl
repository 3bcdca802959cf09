// What the picture shows: the light, or one of the values behind it. Numbered as View in frame/view.rs.

const VIEW_COLOR: u32 = 0u;
const VIEW_NORMAL: u32 = 1u;
const VIEW_DEPTH: u32 = 2u;
const VIEW_POSITION: u32 = 3u;
const VIEW_UV: u32 = 4u;
const VIEW_OBJECT: u32 = 5u;
const VIEW_MATERIAL: u32 = 6u;
const VIEW_BOUNCES: u32 = 7u;
const VIEW_SHADOW: u32 = 8u;
const VIEW_NAN: u32 = 9u;
const VIEW_COST: u32 = 10u;
const VIEW_FACING: u32 = 11u;
const VIEW_VALUE: u32 = 12u;
const VIEW_PLACE: u32 = 13u;
const VIEW_OUTWARD: u32 = 14u;

/// Which of them this pixel shows.
var<private> pixel_view: u32;

/// The pixels of the column at `x` show one of the two that there may be.
fn chooseView(x: f32) {
    pixel_view = select(frame.view, frame.beside, x > frame.divider) + zero;
}

/// What VIEW_NAN marks broken light with, and the faces' colors of VIEW_FACING.
const BROKEN: vec3f = vec3f(1.0, 0.0, 1.0);
const FRONT: vec3f = vec3f(0.25, 0.55, 0.9);
const BACK: vec3f = vec3f(0.95, 0.35, 0.1);
/// VIEW_COST is at the end of its colors after so many doublings of 1.
const MAX_DOUBLINGS: f32 = 16.0;

/// Whether a channel is infinite or no number. Its bits tell: a driver may take it that no comparison meets
/// either.
fn isBroken(color: vec3f) -> bool {
    let exponent = vec3u(0x7f800000u);
    return any((bitcast<vec3u>(color) & exponent) == exponent);
}

/// What the views of a surface show of the first one that a pixel meets; `n` faces the viewer along `v`.
fn surfaceView(hit: Hit, met: Placed, n: vec3f, v: vec3f, albedo: vec3f, visibility: f32) -> vec3f {
    switch pixel_view {
        case VIEW_NORMAL: { return 0.5 + 0.5 * n; }
        case VIEW_POSITION: { return fract(met.at.world); }
        case VIEW_UV: { return vec3f(fract(met.at.uv), 0.0); }
        case VIEW_MATERIAL: { return albedo; }
        case VIEW_SHADOW: { return vec3f(visibility); }
        case VIEW_FACING: {
            let side = select(FRONT, BACK, dot(met.geometric_normal, v) < 0.0);
            return side * (0.3 + 0.7 * dot(n, v));
        }
        case VIEW_VALUE: { return vec3f(measuredAt(hit, met.at, dot(n, v))); }
        case VIEW_PLACE: { return vec3f(met.at.uv, 0.0); }
        case VIEW_OUTWARD: { return met.normal; }
        default: { return vec3f(0.0); }
    }
}

/// The picture's value of the chosen view, and the depth.
fn viewed(seen: Seen) -> vec4f {
    let met = seen.object != NO_OBJECT;
    // Neighbours count too, and so it stands before the ways part.
    let slope = fwidth(seen.value.x);
    switch pixel_view {
        case VIEW_COLOR: { return vec4f(seen.radiance, seen.depth); }
        case VIEW_DEPTH: {
            return vec4f(vec3f(select(0.0, 1.0, met) / (1.0 + 0.1 * max(seen.depth, 0.0))), seen.depth);
        }
        case VIEW_OBJECT: { return vec4f(select(vec3f(0.0), falseColor(seen.object), met), seen.depth); }
        case VIEW_BOUNCES: {
            return vec4f(vec3f(f32(seen.bounces) / f32(max(frame.max_bounces, 1u))), seen.depth);
        }
        case VIEW_NAN: {
            let light = max(luminance(seen.radiance), 0.0);
            let dim = vec3f(0.4 * sqrt(light / (1.0 + light)));
            return vec4f(select(dim, BROKEN, isBroken(seen.radiance)), seen.depth);
        }
        case VIEW_COST: {
            return vec4f(heatColor(min(log2(f32(max(work, 1u))) / MAX_DOUBLINGS, 1.0)), seen.depth);
        }
        case VIEW_VALUE: {
            let color = signedColor(seen.value.x / frame.reach, slope / frame.reach);
            let number = select(color, BROKEN, isBroken(seen.value));
            return vec4f(select(vec3f(0.0), number, met), seen.depth);
        }
        case VIEW_PLACE: { return vec4f(seen.value.xy, f32(seen.object), seen.depth); }
        default: { return vec4f(seen.value, seen.depth); }
    }
}
