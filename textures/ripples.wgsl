/// Circular waves that spread from several points of a pond and cross each other.
///
/// scale = 2, 0.01 to 100: crests per scene unit
/// sources = 4, 1 to 16: how many points the waves spread from
/// spread = 2.5, 0 to 50: these points lie so far from the y axis at most, along x and along z
/// seed = 3, 0 to 1000: another number puts them elsewhere
fn ripples(at: Surface, scale: f32, sources: u32, spread: f32, seed: u32) -> f32 {
    // Sum of the waves, and of their heights.
    var sum = vec2f(0.0);
    for (var i = 0u; i < clamp(sources, 1u, 16u); i++) {
        let word = pcg(vec4u(16u * seed + i));
        let spot = spread * vec3f(tenBits(word, 0u).x, 0.0, tenBits(word, 10u).x);
        let away = length(at.position - spot);
        let crest = away * scale;
        // Near a source its own rings stand out; far away all count the same.
        let height = 1.0 / (0.2 + away);
        sum += height * vec2f(cos((crest - round(crest)) * 6.2831853), 1.0);
    }
    // A box as wide as the waves are long leaves nothing of a sine.
    let x = 3.14159265 * clamp(at.footprint * scale, 1e-3, 1.0);
    return 0.5 + 0.5 * sin(x) / x * sum.x / sum.y;
}
