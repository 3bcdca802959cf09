// The entry point of a scene as a Shadertoy. naga translates it, and export/shadertoy.rs lays Shadertoy's own
// inputs and output over those that are declared here.

var<private> frame: Frame;

/// Width, height and shape of a pixel.
var<private> iResolution: vec3f;
/// Seconds.
var<private> iTime: f32;
/// How many pictures there were before.
var<private> iFrame: i32;
/// Where the pointer is while it is pressed, and where it was pressed, with signs; from the bottom left.
var<private> iMouse: vec4f;

/// `fragCoord` counts from the bottom left corner.
@fragment
fn mainImage(@builtin(position) fragCoord: vec4f) -> @location(0) vec4f {
    zero = u32(min(iFrame, 0));
    frame.resolution = iResolution.xy;
    frame.time = iTime;
    let pressed = abs(iMouse.zw);
    frame.mouse = select(vec2f(0.0), vec2f(pressed.x, iResolution.y - pressed.y), any(pressed > vec2f(0.0)));
    setScene();
    let seen = seenAt(vec2f(fragCoord.x, iResolution.y - fragCoord.y));
    return vec4f(shown(seen.radiance), 1.0);
}
