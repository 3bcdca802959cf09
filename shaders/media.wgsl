// The media that a ray is in: glass in water, an air bubble in glass.

/// No medium but the air around the scene.
const AIR: vec4f = vec4f(1.0);

/// The media after a ray inside of `media` has gone through a surface of index `ior`. They are indices of
/// refraction, the innermost first. Those that a ray entered longest ago are forgotten beyond four.
fn mediaBehind(media: vec4f, ior: f32, leaves: bool) -> vec4f {
    if !leaves {
        return vec4f(ior, media.xyz);
    }
    // A ray leaves the innermost medium of that index. Where it entered none, as from a camera in glass or by
    // a part of another index, it leaves the innermost of all.
    let is_it = media == vec4f(ior);
    if !is_it.x && is_it.y {
        return vec4f(media.x, media.zw, 1.0);
    }
    if !is_it.x && is_it.z {
        return vec4f(media.xy, media.w, 1.0);
    }
    if !is_it.x && is_it.w {
        return vec4f(media.xyz, 1.0);
    }
    return vec4f(media.yzw, 1.0);
}

/// The index of refraction before the surface over the one behind it.
fn indexRatio(media: vec4f, ior: f32, leaves: bool) -> f32 {
    let is_known = !leaves || any(media == vec4f(ior));
    return select(ior, media.x, is_known) / mediaBehind(media, ior, leaves).x;
}
