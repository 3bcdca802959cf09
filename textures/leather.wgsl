/// The grain of leather: rounded pebbles between creases; good as a bump.
///
/// scale = 8, 0.01 to 1000: pebbles per scene unit
/// crease = 0.4, 0.05 to 1: width of the creases, beside a pebble
/// depth = 0.7, 0 to 1: how deep the creases are, beside the height of a pebble
/// unevenness = 0.3, 0 to 1: how much the pebbles differ in height
fn leather(at: Surface, scale: f32, crease: f32, depth: f32, unevenness: f32) -> f32 {
    // Straight creases would be those of dried mud.
    let p = at.position * scale + 0.16 * vectorNoise(1.9 * scale * at.position + OCTAVE_SHIFT);
    let width = min(at.footprint * scale, 1e6);
    // The nearest and second nearest of one random point per cell (Worley, A Cellular Texture Basis
    // Function, 1996).
    var near = 9.0;
    var next = 9.0;
    var chance = 0.0;
    for (var i = 0u; i < 27u; i++) {
        let cell = floor(p) + vec3f(f32(i % 3u), f32(i / 3u % 3u), f32(i / 9u)) - 1.0;
        let word = vec4u(cellCorners(cell).near.x) >> vec4u(0u, 10u, 20u, 7u);
        let random = tenBits(word, 0u);
        let away = cell + 0.5 + 0.45 * random.xyz - p;
        let d = dot(away, away);
        chance = select(chance, random.w, d < near);
        next = min(next, max(near, d));
        near = min(near, d);
    }
    // The pixel sees creases wider and shallower by as much; what is left of them then keeps their mean.
    let narrow = max(crease, 0.05);
    let wide = sqrt(narrow * narrow + 0.9 * width * width);
    let bottom = max(1.0 - (sqrt(next) - sqrt(near)) / wide, 0.0);
    let far = smoothstep(0.4, 1.8, width);
    let dip = leatherMean(narrow)
        + (bottom * bottom - leatherMean(wide)) * (1.0 - far) * narrow / wide;
    return (1.0 - depth * dip) * (1.0 - unevenness * (0.5 + 0.5 * chance * (1.0 - far)));
}

/// The mean depth of creases over a cut through the cells, fitted to within 0.01.
fn leatherMean(crease: f32) -> f32 {
    return crease / (crease + 0.66 / (1.0 + 0.5 * crease));
}
