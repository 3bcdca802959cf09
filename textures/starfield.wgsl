/// Stars of every brightness, scattered over a night sky.
///
/// scale = 12, 0.01 to 1000: fineness; at 1, bright stars lie some two scene units apart
/// size = 0.1, 0.01 to 0.2: radius of the largest stars, beside the distance of two
/// brightness = 3, 0 to 20: light of the brightest star at its heart; no pixel passes 1
/// sky = "#05070f": color between the stars
/// warm = "#ffd9a8": color of cool, reddish stars
/// cool = "#c4d7ff": color of hot, bluish ones
fn starfield(
    at: Surface, scale: f32, size: f32, brightness: f32, sky: vec3f, warm: vec3f, cool: vec3f,
) -> vec3f {
    var q = at.position * scale;
    var width = at.footprint * scale;
    var normal = at.normal;
    var light = sky;
    let radius = max(size * size, 1e-6);
    for (var i = 0u; i < 3u; i++) {
        q = OCTAVE_TURN * q + OCTAVE_SHIFT;
        normal = OCTAVE_TURN * normal;
        let cell = floor(q);
        let word = pcg(cellCorners(cell).near.xxxx + vec4u(0u, 1u, 2u, 3u));
        let away = q - cell - 0.5 - 0.25 * tenBits(word, 0u).xyz;
        let kind = 0.5 + 0.5 * tenBits(word, 10u).xy;
        // A star is a ball of light that the surface cuts. Over the pixel its disc grows wider and fainter,
        // its light staying the same; how far the ball lies from the surface does not change.
        let depth = dot(away, normal);
        let wide = radius + width * width / 6.0;
        let seen = exp(-depth * depth / radius - (dot(away, away) - depth * depth) / wide) * radius / wide;
        // A ball of this profile holds π^1.5 size³ of light.
        let mean = 5.568 * radius * sqrt(radius);
        let power = kind.x * kind.x * kind.x;
        let far = smoothstep(0.3, 1.0, width);
        light += brightness * mix(warm, cool, mix(kind.y, 0.5, far)) * mix(seen * power, mean * 0.25, far);
        q *= 2.0;
        width *= 2.0;
    }
    return min(light, vec3f(1.0));
}
