// A flat texture laid on from three sides.

/// The point as it lies on the plane across axis `side`: x, y or z.
fn sideOf(at: Surface, side: u32) -> Surface {
    var flat_ = at;
    let p = at.position;
    flat_.uv = select(select(p.xy, p.xz, side == 1u), p.zy, side == 0u);
    flat_.whole = vec4f(0.0);
    flat_.density = 1.0;
    return flat_;
}

/// The share of one side in the whole; the shares of the three sum up to 1.
fn sideShare(at: Surface, side: u32, sharpness: f32) -> f32 {
    let weights = pow(max(abs(at.normal), vec3f(1e-6)), vec3f(sharpness));
    return weights[side] / (weights.x + weights.y + weights.z);
}
