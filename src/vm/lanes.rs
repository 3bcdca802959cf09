//! One 32-bit value for each pixel of a square, and what each operation does to all of them.

use super::op::{BinaryOp, TernaryOp, UnaryOp};

/// How many pixels go through a program together: a square of [`SIDE`] by [`SIDE`].
pub const LANES: usize = SIDE * SIDE;
pub const SIDE: usize = 8;

/// One 32-bit value for each pixel. Floats are their bits; booleans are all ones or all zeros.
pub type Lanes = [u32; LANES];

#[inline(always)]
pub fn unary(f: UnaryOp, a: &Lanes) -> Lanes {
    match f {
        UnaryOp::Copy => *a,
        UnaryOp::Not => word(a, |x| !x),
        UnaryOp::Neg => word(a, |x| x ^ 0x8000_0000),
        UnaryOp::Abs => word(a, |x| x & 0x7fff_ffff),
        UnaryOp::Sign => float(a, |x| f32::from(x > 0.0) - f32::from(x < 0.0)),
        UnaryOp::Floor => float(a, f32::floor),
        UnaryOp::Ceil => float(a, f32::ceil),
        UnaryOp::Round => float(a, f32::round_ties_even),
        UnaryOp::Trunc => float(a, f32::trunc),
        UnaryOp::Fract => float(a, |x| x - x.floor()),
        UnaryOp::Sqrt => float(a, f32::sqrt),
        UnaryOp::InverseSqrt => float(a, |x| 1.0 / x.sqrt()),
        UnaryOp::Exp => float(a, f32::exp),
        UnaryOp::Exp2 => float(a, f32::exp2),
        UnaryOp::Log => float(a, f32::ln),
        UnaryOp::Log2 => float(a, f32::log2),
        UnaryOp::Sin => float(a, f32::sin),
        UnaryOp::Cos => float(a, f32::cos),
        UnaryOp::Tan => float(a, f32::tan),
        UnaryOp::Asin => float(a, f32::asin),
        UnaryOp::Acos => float(a, f32::acos),
        UnaryOp::Atan => float(a, f32::atan),
        UnaryOp::Sinh => float(a, f32::sinh),
        UnaryOp::Cosh => float(a, f32::cosh),
        UnaryOp::Tanh => float(a, f32::tanh),
        UnaryOp::Asinh => float(a, f32::asinh),
        UnaryOp::Acosh => float(a, f32::acosh),
        UnaryOp::Atanh => float(a, f32::atanh),
        UnaryOp::IntNeg => word(a, u32::wrapping_neg),
        UnaryOp::IntAbs => word(a, |x| (x as i32).unsigned_abs()),
        UnaryOp::IntSign => word(a, |x| (x as i32).signum() as u32),
        UnaryOp::CountOneBits => word(a, u32::count_ones),
        UnaryOp::CountTrailingZeros => word(a, u32::trailing_zeros),
        UnaryOp::CountLeadingZeros => word(a, u32::leading_zeros),
        UnaryOp::ReverseBits => word(a, u32::reverse_bits),
        UnaryOp::FloatToInt => word(a, |x| f32::from_bits(x) as i32 as u32),
        UnaryOp::FloatToUint => word(a, |x| f32::from_bits(x) as u32),
        UnaryOp::IntToFloat => word(a, |x| (x as i32 as f32).to_bits()),
        UnaryOp::UintToFloat => word(a, |x| (x as f32).to_bits()),
        UnaryOp::FloatToBool => word(a, |x| mask(f32::from_bits(x) != 0.0)),
        UnaryOp::BoolToFloat => word(a, |x| x & 1.0f32.to_bits()),
        UnaryOp::IntToBool => word(a, |x| mask(x != 0)),
        UnaryOp::BoolToInt => word(a, |x| x & 1),
        UnaryOp::AlongX => each(|i| difference(a, i & !1, i | 1)),
        UnaryOp::AlongY => each(|i| difference(a, i & !SIDE, i | SIDE)),
    }
}

#[inline(always)]
pub fn binary(f: BinaryOp, a: &Lanes, b: &Lanes) -> Lanes {
    match f {
        BinaryOp::Add => floats(a, b, |x, y| x + y),
        BinaryOp::Sub => floats(a, b, |x, y| x - y),
        BinaryOp::Mul => floats(a, b, |x, y| x * y),
        BinaryOp::Div => floats(a, b, |x, y| x / y),
        BinaryOp::Rem => floats(a, b, |x, y| x % y),
        BinaryOp::Min => floats(a, b, |x, y| if y < x { y } else { x }),
        BinaryOp::Max => floats(a, b, |x, y| if x < y { y } else { x }),
        BinaryOp::Pow => floats(a, b, f32::powf),
        BinaryOp::Atan2 => floats(a, b, f32::atan2),
        BinaryOp::Equal => compared(a, b, |x, y| x == y),
        BinaryOp::NotEqual => compared(a, b, |x, y| x != y),
        BinaryOp::Less => compared(a, b, |x, y| x < y),
        BinaryOp::LessEqual => compared(a, b, |x, y| x <= y),
        BinaryOp::IntAdd => words(a, b, u32::wrapping_add),
        BinaryOp::IntSub => words(a, b, u32::wrapping_sub),
        BinaryOp::IntMul => words(a, b, u32::wrapping_mul),
        // By zero WGSL gives the dividend, and no rest.
        BinaryOp::IntDiv => ints(a, b, |x, y| if y == 0 { x } else { x.wrapping_div(y) }),
        BinaryOp::IntRem => ints(a, b, |x, y| if y == 0 { 0 } else { x.wrapping_rem(y) }),
        BinaryOp::UintDiv => words(a, b, |x, y| x.checked_div(y).unwrap_or(x)),
        BinaryOp::UintRem => words(a, b, |x, y| x.checked_rem(y).unwrap_or(0)),
        BinaryOp::IntMin => ints(a, b, i32::min),
        BinaryOp::IntMax => ints(a, b, i32::max),
        BinaryOp::IntLess => words(a, b, |x, y| mask((x as i32) < y as i32)),
        BinaryOp::IntLessEqual => words(a, b, |x, y| mask(x as i32 <= y as i32)),
        BinaryOp::UintMin => words(a, b, u32::min),
        BinaryOp::UintMax => words(a, b, u32::max),
        BinaryOp::UintLess => words(a, b, |x, y| mask(x < y)),
        BinaryOp::UintLessEqual => words(a, b, |x, y| mask(x <= y)),
        BinaryOp::BitsEqual => words(a, b, |x, y| mask(x == y)),
        BinaryOp::BitsNotEqual => words(a, b, |x, y| mask(x != y)),
        BinaryOp::And => words(a, b, |x, y| x & y),
        BinaryOp::Or => words(a, b, |x, y| x | y),
        BinaryOp::Xor => words(a, b, |x, y| x ^ y),
        BinaryOp::ShiftLeft => words(a, b, u32::wrapping_shl),
        BinaryOp::ShiftRight => words(a, b, |x, y| (x as i32).wrapping_shr(y) as u32),
        BinaryOp::UintShiftRight => words(a, b, u32::wrapping_shr),
    }
}

#[inline(always)]
pub fn ternary(f: TernaryOp, a: &Lanes, b: &Lanes, c: &Lanes) -> Lanes {
    let value = |x: u32| f32::from_bits(x);
    match f {
        TernaryOp::MulAdd => each(|i| (value(a[i]) * value(b[i]) + value(c[i])).to_bits()),
        TernaryOp::MulSub => each(|i| (value(a[i]) * value(b[i]) - value(c[i])).to_bits()),
        TernaryOp::Select => each(|i| (a[i] & b[i]) | (!a[i] & c[i])),
    }
}

/// `new` where the mask is set, else `old`.
#[inline(always)]
pub fn store(mask: &Lanes, new: &Lanes, old: &mut Lanes) {
    for i in 0..LANES {
        old[i] = (mask[i] & new[i]) | (!mask[i] & old[i]);
    }
}

pub fn and(a: &Lanes, b: &Lanes) -> Lanes {
    words(a, b, |x, y| x & y)
}

pub fn and_not(a: &Lanes, b: &Lanes) -> Lanes {
    words(a, b, |x, y| x & !y)
}

pub fn or(a: &Lanes, b: &Lanes) -> Lanes {
    words(a, b, |x, y| x | y)
}

pub fn any(a: &Lanes) -> bool {
    a.iter().fold(0, |all, x| all | x) != 0
}

#[inline(always)]
fn each(f: impl Fn(usize) -> u32) -> Lanes {
    std::array::from_fn(f)
}

/// A float to a float.
#[inline(always)]
fn float(a: &Lanes, f: impl Fn(f32) -> f32) -> Lanes {
    each(|i| f(f32::from_bits(a[i])).to_bits())
}

#[inline(always)]
fn floats(a: &Lanes, b: &Lanes, f: impl Fn(f32, f32) -> f32) -> Lanes {
    each(|i| f(f32::from_bits(a[i]), f32::from_bits(b[i])).to_bits())
}

#[inline(always)]
fn compared(a: &Lanes, b: &Lanes, f: impl Fn(f32, f32) -> bool) -> Lanes {
    each(|i| mask(f(f32::from_bits(a[i]), f32::from_bits(b[i]))))
}

#[inline(always)]
fn word(a: &Lanes, f: impl Fn(u32) -> u32) -> Lanes {
    each(|i| f(a[i]))
}

#[inline(always)]
fn words(a: &Lanes, b: &Lanes, f: impl Fn(u32, u32) -> u32) -> Lanes {
    each(|i| f(a[i], b[i]))
}

#[inline(always)]
fn ints(a: &Lanes, b: &Lanes, f: impl Fn(i32, i32) -> i32) -> Lanes {
    words(a, b, |x, y| f(x as i32, y as i32) as u32)
}

#[inline(always)]
fn mask(is: bool) -> u32 {
    (is as u32).wrapping_neg()
}

fn difference(a: &Lanes, from: usize, to: usize) -> u32 {
    (f32::from_bits(a[to]) - f32::from_bits(a[from])).to_bits()
}
