/// Land over a rectangle: as high as any pattern says, down to a flat base.
///
/// height = 0.5, 0 to 1: any pattern, asked at the point below; 1 is as high as `size` is
/// size = (4, 0.6, 4), 0.00001 to 100000: width, greatest height and depth
/// slope = 3, 0.01 to 1000: the steepest rise of the land; smaller is faster, too small misses peaks
fn heightfieldDistance(p: vec3f, height: f32, size: vec3f, slope: f32) -> f32 {
    let outside = abs(p.xz) - 0.5 * size.xz;
    let walls = max(max(outside.x, outside.y), -p.y);
    // A cone as steep as the land, upside down on each point of it, holds nothing but air.
    let air = (p.y - clamp(height, 0.0, 1.0) * size.y) * inverseSqrt(1.0 + slope * slope);
    return max(air, walls);
}

fn heightfieldBounds(height: f32, size: vec3f, slope: f32) -> Bounds {
    let half_size = 0.5 * size.xz;
    return Bounds(vec3f(-half_size.x, 0.0, -half_size.y), vec3f(half_size.x, size.y, half_size.y));
}

fn heightfieldTexturePoint(p: vec3f) -> vec3f {
    return vec3f(p.x, 0.0, p.z);
}
