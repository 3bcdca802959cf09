/// Fine straight scratches in many directions: 1 in the deepest, 0 where the metal is whole.
///
/// scale = 4, 0.01 to 1000: fineness; at 1, scratches of one direction lie a scene unit apart
/// directions = 12, 1 to 32: how many directions they take
/// length = 12, 1 to 50: length of the longest, beside their distance
/// width = 0.025, 0.001 to 0.3: width of a scratch, beside their distance
fn scratches(at: Surface, scale: f32, directions: u32, length_: f32, width: f32) -> f32 {
    let pixel = max(at.density * at.footprint * scale, 1e-6);
    let far = smoothstep(0.4, 1.2, pixel);
    var whole = 1.0;
    var axis = vec2f(0.8, 0.6);
    for (var i = 0u; i < clamp(directions, 1u, 32u); i++) {
        // The golden angle: however many directions, they are spread evenly.
        axis = vec2f(dot(axis, vec2f(-0.737369, -0.675490)), dot(axis, vec2f(0.675490, -0.737369)));
        let turned = vec2f(dot(at.uv, axis) / length_, dot(at.uv, vec2f(-axis.y, axis.x)));
        var q = turned * scale + f32(i) * vec2f(0.37, 0.29);
        // Neighboring rows start apart by the golden ratio: no column of gaps shows.
        q.x += 0.618034 * floor(q.y);
        let cell = floor(q);
        let word = pcg(cellCorners(vec3f(cell, f32(i))).near.xxxx + vec4u(0u, 1u, 2u, 3u));
        let chance = tenBits(word, 0u);
        let place = tenBits(word, 10u).xy;
        let reach = 0.32 + 0.18 * chance.x;
        let along = (q.x - cell.x - 0.5 - (0.5 - reach) * place.x) / reach;
        let across = abs(q.y - cell.y - 0.5 - 0.2 * place.y - 0.25 * chance.y * along);
        let seen = clamp(0.5 * (width + pixel) - across, 0.0, min(width, pixel)) / pixel;
        // A scratch runs out shallow at both ends.
        let depth = (0.55 + 0.45 * chance.z) * max(1.0 - along * along, 0.0);
        whole *= 1.0 - mix(seen * depth, 0.235 * width, far);
    }
    return 1.0 - whole;
}
