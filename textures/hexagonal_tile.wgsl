/// Repeats a hexagonal piece of a texture like honeycomb, across the y axis and in uv.
///
/// size = 1.5, 0.01 to 100: width of a cell from side to side, in scene units
/// turn_deg = 120, -360 to 360: turn from each cell to the next along x, 0 for equal copies
fn hexagonalTile(at: Surface, size: f32, turn_deg: f32) -> Surface {
    let width = max(size, 1e-3);
    let flat = at.position.xz;
    // Asked just under the surface, a face that lies between two cells is not torn between them.
    let middle = hexagonalTileMiddle(flat - 1e-3 * width * at.normal.xz, width);
    let turn = hexagonalTileTurn(middle / width, turn_deg);
    let position = turn * hexagonalTileInside(flat - middle, width, at.footprint);
    let normal = turn * at.normal.xz;
    let uv_middle = hexagonalTileMiddle(at.uv, width);
    let uv = hexagonalTileInside(at.uv - uv_middle, width, at.density * at.footprint);
    var moved = at;
    moved.position = vec3f(position.x, at.position.y, position.y);
    moved.normal = vec3f(normal.x, at.normal.y, normal.y);
    moved.uv = hexagonalTileTurn(uv_middle / width, turn_deg) * uv;
    return moved;
}

/// The middle of the cell around `p`: the nearer of two rectangular lattices' nearest points.
fn hexagonalTileMiddle(p: vec2f, width: f32) -> vec2f {
    let lattice = width * vec2f(1.0, 1.7320508);
    let even = lattice * round(p / lattice);
    let odd = lattice * (floor(p / lattice) + 0.5);
    return select(odd, even, dot(p - even, p - even) < dot(p - odd, p - odd));
}

/// Keeps the pixel around `local` inside the cell: beyond the seam lies what is not shown. One as wide
/// as a cell sees its middle, and does not flicker.
fn hexagonalTileInside(local: vec2f, width: f32, footprint: f32) -> vec2f {
    let reach = max(abs(local.x), dot(abs(local), vec2f(0.5, 0.8660254)));
    return local * min(1.0, 0.5 * max(width - footprint, 0.0) / max(reach, 1e-6));
}

/// The cells are numbered so that, modulo 3, no two neighbors have the same number.
fn hexagonalTileTurn(middle: vec2f, turn_deg: f32) -> mat2x2f {
    let turns = round(middle.x - 1.7320508 * middle.y) * turn_deg / 360.0;
    // sin and cos are only sure between -pi and pi.
    let angle = (turns - round(turns)) * 6.2831853;
    let c = cos(angle);
    let s = sin(angle);
    return mat2x2f(c, s, -s, c);
}
