// Tone maps, which bring light of any strength to what a screen has, and the transfer curve of screens.

/// Reinhard et al., Photographic Tone Reproduction for Digital Images, 2002.
fn tonedReinhard(light: vec3f) -> vec3f {
    return light / (1.0 + light);
}

/// Narkowicz, ACES Filmic Tone Mapping Curve, 2016.
fn tonedAces(x: vec3f) -> vec3f {
    return clamp((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), vec3f(0.0), vec3f(1.0));
}

/// Sobotka's AgX with Wrensch's polynomial for its curve (Minimal AgX Implementation, 2023).
fn tonedAgx(light: vec3f) -> vec3f {
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

/// The transfer curve of sRGB (IEC 61966-2-1).
fn encodedSrgb(light: vec3f) -> vec3f {
    let low = light * 12.92;
    let high = 1.055 * pow(light, vec3f(1.0 / 2.4)) - 0.055;
    return select(high, low, light <= vec3f(0.0031308));
}
