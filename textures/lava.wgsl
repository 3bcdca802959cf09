/// Cooling lava: a dark crust broken by glowing cracks; good as emission.
///
/// scale = 1.2, 0.01 to 100: plates of crust per scene unit
/// cracks = 0.05, 0.005 to 0.5: width of the cracks, beside a plate
/// glow = 3, 1 to 10: how far the glow reaches, in widths of a crack
/// roughness = 0.4, 0 to 1: how ragged the cracks are
/// crust = "#1b1614": color of the crust
/// ember = "#c2310c": color of the glow around a crack
/// hot = "#ffd27a": color within it
fn lava(
    at: Surface, scale: f32, cracks: f32, glow: f32, roughness: f32,
    crust: vec3f, ember: vec3f, hot: vec3f,
) -> vec3f {
    let noise = vectorOctaves(at.position * scale, 4u, vec3f(roughness), at.footprint * scale);
    let field = noise.field;
    let lost = noise.lost.x;
    // Cracks run where a noise passes zero. What the footprint hides of it is chance, and the mean of
    // this bell over a normal chance is a wider and lower bell.
    let narrow = cracks * cracks * vec2f(1.0, glow * glow);
    let wide = max(narrow + lost, vec2f(1e-12));
    let height = sqrt(narrow / wide);
    let cold = (1.0 - height * exp(-0.5 * field.x * field.x / wide))
        * (1.0 - height * exp(-0.5 * field.y * field.y / wide));
    // Some cracks have gone out.
    let soft = 0.6 + sqrt(5.0 * lost);
    let heat = (1.0 - cold) * smoothstep(-0.2 - soft, -0.2 + soft, field.z);
    // A sum, not a mix in a mix: the two heats are not independent, and only sums can be averaged apart.
    return crust * (1.0 - heat.y) + ember * (heat.y - heat.x) + hot * heat.x;
}
