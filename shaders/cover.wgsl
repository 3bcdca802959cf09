// A triangle that covers the picture.

struct Covered {
    @builtin(position) pixel: vec4f,
    @location(0) @interpolate(flat) zero: u32,
}

@vertex
fn coverPicture(@builtin(vertex_index) corner: u32) -> Covered {
    let place = vec4f(f32(corner & 1u) * 4.0 - 1.0, f32(corner >> 1u) * 4.0 - 1.0, 0.0, 1.0);
    // A triangle has no corner above 2.
    return Covered(place, corner >> 2u);
}
