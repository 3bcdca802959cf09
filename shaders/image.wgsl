// Images from files.

@group(1) @binding(0) var imageSampler: sampler;

/// The color of `image` at a point of the uv plane, where it is `width` wide and stands on the origin.
fn imageColor(image: texture_2d<f32>, at: Surface, width: f32, repeat: bool) -> vec3f {
    let size = vec2f(textureDimensions(image));
    let texels_per_unit = size.x / width;
    let place = vec2f(at.uv.x, -at.uv.y) * texels_per_unit / size;
    let half_texel = 0.5 / size;
    let kept = clamp(place + vec2f(0.0, 1.0), half_texel, 1.0 - half_texel);
    let level = log2(max(at.footprint * texels_per_unit, 1.0));
    return textureSampleLevel(image, imageSampler, select(kept, place - floor(place), repeat), level).rgb;
}
