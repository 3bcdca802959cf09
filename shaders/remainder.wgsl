/// What is left of `a` by whole steps of `n`, 0 to n - 1 for negative `a`, too. `%` of negative numbers is
/// undefined in GLSL.
fn floorRemainder(a: i32, n: u32) -> u32 {
    let rest = u32(max(a, -1 - a)) % n;
    return select(rest, n - 1u - rest, a < 0);
}
