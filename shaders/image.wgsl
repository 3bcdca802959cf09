// Images from files.

@group(1) @binding(0) var image_sampler: sampler;

/// A point that belongs to no whole, so that an image lies on the uv plane.
fn unfitted(at: Surface) -> Surface {
    var plane = at;
    plane.whole = vec4f(at.whole.xy, 0.0, 0.0);
    return plane;
}

/// A point of a whole, be it that of uv from 0 to 1.
fn wholly(at: Surface) -> Surface {
    var whole = at;
    whole.whole = select(vec4f(0.0, 0.0, 1.0, 1.0), at.whole, at.whole.w != 0.0);
    return whole;
}

/// An image as a point sees it: red, green and blue times alpha, and alpha. It is `width` wide, or 1; without
/// a width it covers the whole that the point belongs to. `spread` is 1 where it goes on beyond its edges.
fn imageTexel(image: texture_2d<f32>, at: Surface, width: f32, repeat: bool, spread: f32) -> vec4f {
    let size = vec2f(textureDimensions(image));
    let has_whole = at.whole.w != 0.0;
    let wide = select(width, 1.0, width == 0.0);
    let plain = vec2f(select(1.0, -1.0, at.whole.z < 0.0), size.x / size.y) / wide;
    let pictures_per_unit = select(plain, 1.0 / at.whole.zw, has_whole & (width == 0.0));
    let corner = select(vec2f(0.0), at.whole.xy, has_whole);
    var place = (at.uv - corner) * pictures_per_unit * vec2f(1.0, -1.0);
    let texels_per_unit = size * abs(pictures_per_unit);
    let footprint = at.density * at.footprint;
    let half_texel = 0.5 / size;
    // A ball and the sky end at their poles.
    let ends = has_whole & (at.whole.x != 0.0);
    let bottom = -at.whole.w * pictures_per_unit.y;
    place.y = select(place.y, clamp(place.y, bottom + half_texel.y, -half_texel.y), ends);
    let kept = clamp(place + vec2f(0.0, 1.0), half_texel, 1.0 - half_texel);
    let level = log2(max(footprint * sqrt(texels_per_unit.x * texels_per_unit.y), 1.0));
    let seen = textureSampleLevel(image, image_sampler, select(kept, place - floor(place), repeat), level);
    // The share of a pixel that lies within the edges.
    let room = (0.5 - abs(place + vec2f(-0.5, 0.5))) / abs(pictures_per_unit);
    let share = saturate(room / max(footprint, 1e-9) + 0.5);
    return seen * select(share.x * share.y, 1.0, repeat | (spread > 0.0));
}

fn imageColor(image: texture_2d<f32>, at: Surface, width: f32, repeat: bool) -> vec3f {
    return imageTexel(image, at, width, repeat, 1.0).rgb;
}

/// The same over a color, which is seen where the image is clear and beyond its edges.
fn imageColorOver(image: texture_2d<f32>, at: Surface, width: f32, repeat: bool, under: vec3f) -> vec3f {
    let seen = imageTexel(image, at, width, repeat, 0.0);
    return seen.rgb + (1.0 - seen.a) * under;
}

/// An image of numbers, whose first digits are red and the others green.
fn imageNumber(image: texture_2d<f32>, at: Surface, width: f32, repeat: bool) -> f32 {
    let seen = imageTexel(image, at, width, repeat, 1.0);
    return seen.r + seen.g;
}

fn imageNumberOver(image: texture_2d<f32>, at: Surface, width: f32, repeat: bool, under: f32) -> f32 {
    let seen = imageTexel(image, at, width, repeat, 0.0);
    return seen.r + seen.g + (1.0 - seen.a) * under;
}
