/// A cube with square tunnels through its faces, and through each of its smaller cubes again.
/// moves with center
///
/// center = (0, 0, 0): the middle
/// size = 2, 0.00001 to 100000: length of an edge
/// levels = 3, 0 to 6: how many sizes of tunnels there are
fn mengerSpongeDistance(p: vec3f, center: vec3f, size: f32, levels: u32) -> f32 {
    let half_size = 0.5 * size;
    let q = (p - center) / half_size;
    let outside = abs(q) - 1.0;
    var distance = length(max(outside, vec3f(0.0))) + min(max(outside.x, max(outside.y, outside.z)), 0.0);
    var cells = 1.0;
    for (var i = 0u; i < min(levels, 8u); i++) {
        // The place in a cell of this level, from its middle; a third of it is tunnel.
        let cell = (0.5 * q + 0.5) * cells;
        let place = abs(cell - floor(cell) - 0.5) * 2.0;
        let wall = place - 1.0 / 3.0;
        let tunnel = min(max(wall.x, wall.y), min(max(wall.y, wall.z), max(wall.z, wall.x)));
        distance = max(distance, -tunnel / cells);
        cells *= 3.0;
    }
    return distance * half_size;
}

fn mengerSpongeBounds(center: vec3f, size: f32, levels: u32) -> Bounds {
    return Bounds(center - 0.5 * size, center + 0.5 * size);
}
