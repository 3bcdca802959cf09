/// Bends straight lines into even waves.
///
/// amplitude = 0.15, 0 to 4: how far a wave sways to each side, in scene units
/// wavelength = 1.5, 0.01 to 100: from crest to crest, in scene units
fn wobble(at: Surface, amplitude: f32, wavelength: f32) -> Surface {
    let pace = 1.0 / max(wavelength, 1e-3);
    // Waves that a pixel cannot show leave only a blur.
    let seen = 1.0 - smoothstep(0.25, 1.0, at.footprint * pace);
    let reach = amplitude * seen;
    let blur = amplitude * (1.0 - seen);
    let turns = at.position * pace;
    let flat_turns = at.uv * pace;
    // sin and cos are only sure between -pi and pi.
    let angle = (turns - round(turns)) * 6.2831853;
    let flat = (flat_turns - round(flat_turns)) * 6.2831853;
    let wave = sin(angle);
    var moved = at;
    moved.position += reach * (wave.yzx + wave.zxy);
    moved.uv += reach * sin(flat.yx);

    // Each axis shears the others, but for what goes along the normal. Of the stretch, the root mean
    // square over all directions; of the blur, the box as wide as a sine's variance.
    let steep = 6.2831853 * pace * reach;
    let a = cos(angle) * cos(angle);
    let b = cos(flat) * cos(flat);
    let bent = max(dot(a, vec3f(1.0) - at.normal * at.normal), 0.5 * (b.x + b.y));
    let width = at.footprint * at.footprint * (1.0 + steep * steep * bent);
    moved.footprint = sqrt(width + 6.0 * blur * blur);
    return moved;
}
