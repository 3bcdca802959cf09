// What the picture shows: the light, or one of the values behind it. Numbered as View in gpu/uniforms.rs.

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

const VIEW_COLOR: u32 = 0u;
const VIEW_NORMAL: u32 = 1u;
const VIEW_DEPTH: u32 = 2u;
const VIEW_POSITION: u32 = 3u;
const VIEW_UV: u32 = 4u;
const VIEW_OBJECT: u32 = 5u;
const VIEW_MATERIAL: u32 = 6u;
const VIEW_BOUNCES: u32 = 7u;
const VIEW_SHADOW: u32 = 8u;

/// A color for each number, far from its neighbours' in hue (steps of the golden angle).
fn falseColor(index: u32) -> vec3f {
    let hue = fract(f32(index) * 0.61803399 + 0.05) * 6.0;
    let wheel = clamp(abs(vec3f(hue) - vec3f(3.0, 2.0, 4.0)) * vec3f(1.0, -1.0, -1.0)
        + vec3f(-1.0, 2.0, 2.0), vec3f(0.0), vec3f(1.0));
    return mix(vec3f(0.35), wheel, 0.75);
}

/// What the views of a surface show of the first one that a pixel meets; `n` faces the viewer.
fn surfaceView(at: Surface, n: vec3f, albedo: vec3f, visibility: f32) -> vec3f {
    switch frame.view + zero {
        case VIEW_NORMAL: { return 0.5 + 0.5 * n; }
        case VIEW_POSITION: { return fract(at.world); }
        case VIEW_UV: { return vec3f(fract(at.uv), 0.0); }
        case VIEW_MATERIAL: { return albedo; }
        case VIEW_SHADOW: { return vec3f(visibility); }
        default: { return vec3f(0.0); }
    }
}

/// The picture's value of the chosen view: a color, and with VIEW_OBJECT the object's index, else the depth.
fn viewed(seen: Seen) -> vec4f {
    let met = seen.object != NO_OBJECT;
    switch frame.view + zero {
        case VIEW_COLOR: { return vec4f(seen.radiance, seen.depth); }
        case VIEW_DEPTH: {
            return vec4f(vec3f(select(0.0, 1.0, met) / (1.0 + 0.1 * max(seen.depth, 0.0))), seen.depth);
        }
        case VIEW_OBJECT: {
            return select(vec4f(vec3f(0.0), -1.0), vec4f(falseColor(seen.object), f32(seen.object)), met);
        }
        case VIEW_BOUNCES: {
            return vec4f(vec3f(f32(seen.bounces) / f32(max(frame.max_bounces, 1u))), seen.depth);
        }
        default: { return vec4f(seen.value, seen.depth); }
    }
}
