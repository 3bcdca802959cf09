// The entry point of raytoy: a sample of a pixel, added to those before it.

@group(0) @binding(0) var<uniform> frame: Frame;

/// The mean of the samples before this one.
@group(0) @binding(1) var accumulated: texture_2d<f32>;

/// Where that lies in the picture, pixels from its top left: a large picture is drawn in parts.
@group(0) @binding(4) var<uniform> corner: vec2f;

@fragment
fn tracePixel(covered: Covered) -> @location(0) vec4f {
    zero = covered.zero;
    // Never, but Mesa's software driver compiles a shader twice that surely fills its pixels.
    if zero != 0u {
        discard;
    }
    let pixel = covered.pixel.xy + corner;
    chooseView(pixel.x);
    let now = viewed(seenAt(pixel));
    // The depth is the first sample's, through the pixel's centre: a mean of depths means nothing.
    let before = textureLoad(accumulated, vec2u(covered.pixel.xy), 0);
    let mean = vec4f(mix(before.rgb, now.rgb, 1.0 / f32(frame.sample + 1u)), before.a);
    return select(mean, now, frame.sample == 0u);
}
