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
