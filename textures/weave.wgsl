/// A plain weave: flat strands go over and under each other by turns, rounded and shaded.
///
/// scale = 3, 0.01 to 100: strands per scene unit
/// width = 0.86, 0.05 to 1: width of a strand, as a share of the way to the next
/// shading = 0.7, 0 to 1: how dark a strand gets along its sides and where it dives
/// warp = "#a9713c": color of the strands along v
/// weft = "#dcbb84": color of the strands along u
/// ground = "#2c2018": color seen through the holes
fn weave(
    at: Surface, scale: f32, width: f32, shading: f32, warp: vec3f, weft: vec3f, ground: vec3f,
) -> vec3f {
    let visible = width - 0.5 * width * width;
    // The half cosine of a strand's height has a mean only where the strand lies on top.
    let crest = width * sin(1.5707963 * width) / 1.5707963;
    let strand = visible - shading * (visible * 5.0 / 12.0 - 0.125 * crest);
    let mean = (warp + weft) * strand + ground * (1.0 - width) * (1.0 - width);
    let footprint = at.density * at.footprint * scale;
    if footprint >= 2.4 {
        return mean;
    }
    let n = footprintParts(footprint, 4.0);
    let part = footprint / f32(n);
    var sum = vec3f(0.0);
    for (var i = 0u; i < n * n; i++) {
        let q = at.uv * scale + footprintPart(i, n, footprint);
        let lit = weaveStrands(q, part, width, shading);
        sum += warp * lit.x + weft * lit.y + ground * lit.z;
    }
    return mix(sum / f32(n * n), mean, smoothstep(1.2, 2.4, footprint));
}

/// What warp, weft and holes add at a point: their shares times their shades.
fn weaveStrands(p: vec2f, part: f32, width: f32, shading: f32) -> vec3f {
    // Even and odd strands apart: the products of their sums and differences tell the four
    // kinds of crossings, and filter exactly.
    let shift = 0.5 * (1.0 - width);
    let even = dutyShare((p - shift) * 0.5, vec2f(0.5 * part), 0.5 * width);
    let odd = dutyShare((p - 1.0 - shift) * 0.5, vec2f(0.5 * part), 0.5 * width);
    let both = even + odd;
    let turn = even - odd;
    let crossing = both.x * both.y;
    let ahead = turn.x * turn.y;
    let shares = both * (1.0 - both.yx) + 0.5 * vec2f(crossing - ahead, crossing + ahead);

    let cell = floor(p);
    let f = p - cell - 0.5;
    let over = select(1.0, -1.0, ((i32(cell.x) + i32(cell.y)) & 1) == 1);
    let height = cos(3.14159265 * f.yx) * vec2f(-over, over);
    let across = min(abs(f) * 2.0 / width, vec2f(1.0));
    let shade = 1.0 - shading * (across * across + 0.5 - 0.5 * height) * 0.5;
    return vec3f(shares * shade, (1.0 - both.x) * (1.0 - both.y));
}
