/// Random shades on a lattice, each flowing into the next: blotches with something square about them.
///
/// scale = 2, 0.01 to 100: shades per scene unit
/// softness = 0.7, 0 to 1: width of the passage between two shades; 0 leaves plain cubes
fn valueNoise(at: Surface, scale: f32, softness: f32) -> f32 {
    // Off the lattice's own planes, where floors and walls would lie between two cubes.
    let p = at.position * scale + OCTAVE_SHIFT;
    let width = at.footprint * scale;
    let c = cellCorners(floor(p));
    // A pixel does not reach across the surface. Widths add as their squares do, and the curve of
    // cornerMix makes a passage look 1.5 times as narrow as a box.
    let across = width * width * (1.0 - at.normal * at.normal);
    let passage = clamp(sqrt(softness * softness + 2.3 * across), vec3f(1e-6), vec3f(1.0));
    let share = clamp((p - floor(p) - 0.5) / passage + 0.5, vec3f(0.0), vec3f(1.0));
    // Beyond, what is left of the noise in the mean over a box, as measured.
    let seen = 1.0 / (1.0 + width * width * (0.25 + 0.08 * width));
    return 0.5 + 0.43 * seen * cornerMix(tenBits(c.near, 0u), tenBits(c.far, 0u), share);
}
