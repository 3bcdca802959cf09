// Bumps: a height over the surface tilts its normal.

/// The world normal of `object` at `placed`, tilted by the slope of its height.
fn bumpedNormal(object: u32, placed: Placed) -> vec3f {
    let n = placed.normal;
    let tangents = frameAround(n);
    // Wide enough for a slope to show over the rounding of the heights, and for an edge to be one.
    let step = max(placed.at.footprint / placed.scale, 2e-3);
    var heights = vec3f(0.0);
    for (var i = 0u; i < 3u; i++) {
        let offset = select(vec3f(0.0), tangents[i % 2u], i < 2u);
        var near = surfaceAt(object, placed.at.world + step * offset).at;
        near.footprint = step * placed.scale;
        heights[i] = heightAt(object, near);
    }
    let slope = (heights.xy - heights.z) / step;
    return normalize(n - slope.x * tangents[0] - slope.y * tangents[1]);
}
