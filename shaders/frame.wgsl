// What changes from one picture to the next: the camera, the clock, the mouse. In raytoy, frame/uniforms.rs
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
