/// Stripes that hide those which ship with raytoy.
fn stripes(at: Surface) -> f32 {
    return fract(at.uv.x);
}
