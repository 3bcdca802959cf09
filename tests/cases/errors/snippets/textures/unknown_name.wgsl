/// A texture that calls what nobody has written.
fn unknownName(at: Surface) -> f32 {
    return simplexNoise(at.position);
}
