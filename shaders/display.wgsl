// From linear light to what a screen shows: exposure, tone map, transfer curve.

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
        case 1u: { return light / (1.0 + light); }
        case 2u: { return aces(light); }
        case 3u: { return agx(light); }
        default: { return min(light, vec3f(1.0)); }
    }
}

/// Narkowicz, ACES Filmic Tone Mapping Curve, 2016.
fn aces(x: vec3f) -> vec3f {
    return clamp((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), vec3f(0.0), vec3f(1.0));
}

/// Sobotka's AgX with Wrensch's polynomial for its curve (Minimal AgX Implementation, 2023).
fn agx(light: vec3f) -> vec3f {
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

fn encoded(light: vec3f) -> vec3f {
    switch display.transfer {
        case 1u: {
            let low = light * 12.92;
            let high = 1.055 * pow(light, vec3f(1.0 / 2.4)) - 0.055;
            return select(high, low, light <= vec3f(0.0031308));
        }
        case 2u: { return pow(light, vec3f(1.0 / display.gamma)); }
        default: { return light; }
    }
}
