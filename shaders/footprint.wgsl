// A footprint cut into square parts, for patterns that can be filtered only where it is small.

/// How many rows of parts, so that `fineness` of them go on one unit; four at most.
fn footprintParts(width: f32, fineness: f32) -> u32 {
    return u32(clamp(ceil(fineness * width), 1.0, 4.0));
}

/// The middle of part `i` of `n` rows of `n`, from that of the footprint.
fn footprintPart(i: u32, n: u32, width: f32) -> vec2f {
    return width * ((vec2f(vec2u(i % n, i / n)) + 0.5) / f32(n) - 0.5);
}
