/// A texture whose helper has a name that another file's may have too.
fn helperName(at: Surface) -> f32 {
    return wave(at.uv.x);
}

fn wave(x: f32) -> f32 {
    return 0.5 + 0.5 * sin(x);
}
