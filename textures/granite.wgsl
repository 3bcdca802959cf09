/// Granite: interlocked grains of three minerals, two pale and one dark and finer.
///
/// scale = 12, 0.01 to 1000: large grains per scene unit
/// roughness = 0.5, 0 to 1: how ragged the grains are
/// dark = 0.48, 0 to 1: how much mica there is
/// feldspar = "#c3b3a2": color of the palest grains
/// quartz = "#8b8580": color of the grey grains
/// mica = "#333130": color of the dark specks
fn granite(
    at: Surface, scale: f32, roughness: f32, dark: f32, feldspar: vec3f, quartz: vec3f, mica: vec3f,
) -> vec3f {
    let gain = vec3f(roughness, roughness, 0.9);
    let noise = vectorOctaves(at.position * scale, 3u, gain, at.footprint * scale);
    let strength = vec3f(1.0, 1.0, 0.3);
    let field = strength * noise.field + vec3f(0.1, 0.0, 2.0 * dark - 1.4);
    let lost = dot(strength * strength, noise.lost);
    // The largest of the three fields has the point. What the footprint hides of them is chance, and a
    // softmax as warm as that chance is wide gives each mineral its share of the pixel.
    let heat = 0.4 * sqrt(lost) + 1e-4;
    let weight = exp((field - max(max(field.x, field.y), field.z)) / heat);
    let tone = 1.0 + 0.12 * field.y;
    let color = feldspar * weight.x * tone + quartz * weight.y + mica * weight.z;
    return min(color / (weight.x + weight.y + weight.z), vec3f(1.0));
}
