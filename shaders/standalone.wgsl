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
