// From linear light to what a screen shows: exposure, tone map, transfer curve. Stands on tone.wgsl.

struct Display {
    /// Factor of the light; 2^stops.
    gain: f32,
    /// 0 clamp, 1 Reinhard, 2 Aces, 3 Agx.
    tone_map: u32,
    /// 0 linear, 1 sRGB, 2 a power.
    transfer: u32,
    gamma: f32,
    /// Top left corner of the picture on the target, pixels.
    corner: vec2f,
    /// Target pixels to a pixel of the picture.
    zoom: f32,
}

@group(0) @binding(0) var<uniform> display: Display;
@group(0) @binding(1) var picture: texture_2d<f32>;

@vertex
fn coverTarget(@builtin(vertex_index) corner: u32) -> @builtin(position) vec4f {
    return vec4f(f32(corner & 1u) * 4.0 - 1.0, f32(corner >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

/// Light, as a screen shows it.
@fragment
fn showLight(@builtin(position) pixel: vec4f) -> @location(0) vec4f {
    return vec4f(encoded(toneMapped(max(pictureAt(pixel) * display.gain, vec3f(0.0)))), 1.0);
}

/// Values that are shown as they are.
@fragment
fn showValue(@builtin(position) pixel: vec4f) -> @location(0) vec4f {
    return vec4f(pictureAt(pixel), 1.0);
}

fn pictureAt(pixel: vec4f) -> vec3f {
    let last = textureDimensions(picture) - vec2u(1u);
    let at = min(vec2u(max((pixel.xy - display.corner) / display.zoom, vec2f(0.0))), last);
    return textureLoad(picture, at, 0).rgb;
}

fn toneMapped(light: vec3f) -> vec3f {
    switch display.tone_map {
        case 1u: { return tonedReinhard(light); }
        case 2u: { return tonedAces(light); }
        case 3u: { return tonedAgx(light); }
        default: { return min(light, vec3f(1.0)); }
    }
}

fn encoded(light: vec3f) -> vec3f {
    switch display.transfer {
        case 1u: { return encodedSrgb(light); }
        case 2u: { return pow(light, vec3f(1.0 / display.gamma)); }
        default: { return light; }
    }
}
