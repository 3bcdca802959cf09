/// Solid wood: yearly rings around a pith, drawn out into fine fibers along it.
///
/// scale = 5, 0.1 to 100: rings per scene unit
/// axis = (1, 0.12, 0.06), nonzero: direction the trunk grew in; y shows its rings from above
/// wobble = 0.5, 0 to 4: how far the rings stray from circles, in rings
/// grain = 0.4, 0 to 1: strength of the fibers
/// light = "#c79a63": early wood, grown in spring
/// dark = "#7d4a24": late wood, the thin line that ends a ring
fn wood(
    at: Surface, scale: f32, axis: vec3f, wobble: f32, grain: f32, light: vec3f, dark: vec3f,
) -> vec3f {
    let p = at.position * frameAround(normalize(axis)) * scale;
    let width = at.footprint * scale;
    // A trunk changes slowly along its length: noise drawn out that way bends whole rings.
    let stray = fractalNoise(p * vec3f(0.2, 0.2, 0.03), 3u, 2.0, 0.4, 0.2 * width) - 0.5;
    let ring = length(p.xy) + 4.0 * wobble * stray;
    let year = ring - floor(ring);
    let late = year * year * (1.0 - smoothstep(0.86, 1.0, year));
    let share = mix(0.3, late, 1.0 - smoothstep(0.3, 1.0, width));
    let fiber = fractalNoise(p * vec3f(7.0, 7.0, 0.3), 3u, 2.0, 0.7, 7.0 * width) - 0.5;
    let color = light * (1.0 - share) + dark * share;
    // No fiber outshines white, unless the wood does.
    return min(color * (1.0 + grain * fiber), max(color, vec3f(1.0)));
}
