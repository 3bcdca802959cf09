// The two entry points: a triangle that covers the picture, and a pixel of it.

/// The mean of the samples before this one.
@group(0) @binding(1) var accumulated: texture_2d<f32>;

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

@fragment
fn tracePixel(covered: Covered) -> @location(0) vec4f {
    zero = covered.zero;
    // Never, but Mesa's software driver compiles a shader twice that surely fills its pixels.
    if zero != 0u {
        discard;
    }
    let pixel = covered.pixel.xy;
    let place = (2.0 * (pixel + frame.jitter) / frame.resolution - 1.0)
        * vec2f(frame.resolution.x / frame.resolution.y, -1.0);
    let direction = normalize(frame.forward + place.x * frame.right + place.y * frame.up);
    let at = vec2u(pixel);
    seed = hashed(at.x + hashed(at.y + hashed(frame.sample)));
    let now = viewed(traceTree(frame.eye, direction));
    // The depth is the first sample's, through the pixel's centre: a mean of depths means nothing.
    let before = textureLoad(accumulated, at, 0);
    let mean = vec4f(mix(before.rgb, now.rgb, 1.0 / f32(frame.sample + 1u)), before.a);
    return select(mean, now, frame.sample == 0u);
}
