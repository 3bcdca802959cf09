// Whole numbers as WGSL has them, where GLSL leaves the result open. export/integers.rs calls these in
// place of operators and conversions.

/// Rounded towards zero; `a` by 0 is `a`.
fn quotientI32(a: i32, b: i32) -> i32 {
    if b == 0 {
        return a;
    }
    let size = i32(u32(abs(a)) / u32(abs(b)));
    return select(size, -size, (a < 0) != (b < 0));
}

fn quotientU32(a: u32, b: u32) -> u32 {
    if b == 0u {
        return a;
    }
    return a / b;
}

/// With the sign of `a`; 0 where `b` is.
fn remainderI32(a: i32, b: i32) -> i32 {
    if b == 0 {
        return 0;
    }
    let size = i32(u32(abs(a)) % u32(abs(b)));
    return select(size, -size, a < 0);
}

fn remainderU32(a: u32, b: u32) -> u32 {
    if b == 0u {
        return 0u;
    }
    return a % b;
}

/// By the last five bits of `b`.
fn shiftLeftI32(a: i32, b: u32) -> i32 {
    return a << (b & 31u);
}

fn shiftLeftU32(a: u32, b: u32) -> u32 {
    return a << (b & 31u);
}

fn shiftRightI32(a: i32, b: u32) -> i32 {
    return a >> (b & 31u);
}

fn shiftRightU32(a: u32, b: u32) -> u32 {
    return a >> (b & 31u);
}

/// The nearest that there is, where there is none.
fn wholeI32(x: f32) -> i32 {
    return i32(clamp(x, -2147483648.0, 2147483520.0));
}

fn wholeU32(x: f32) -> u32 {
    return u32(clamp(x, 0.0, 4294967040.0));
}
