//! What each step does to all lanes.

use super::program::{LANES, Lanes, SIDE};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum One {
    Copy,
    Not,
    Neg,
    Abs,
    Sign,
    Floor,
    Ceil,
    Round,
    Trunc,
    Fract,
    Sqrt,
    InverseSqrt,
    Exp,
    Exp2,
    Log,
    Log2,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    Asinh,
    Acosh,
    Atanh,
    IntNeg,
    IntAbs,
    IntSign,
    CountOneBits,
    CountTrailingZeros,
    CountLeadingZeros,
    ReverseBits,
    FloatToInt,
    FloatToUint,
    IntToFloat,
    UintToFloat,
    FloatToBool,
    BoolToFloat,
    IntToBool,
    BoolToInt,
    /// The difference to the pixel beside, or below.
    AlongX,
    AlongY,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Two {
    Add,
    Sub,
    Mul,
    Div,
    Rem,
    Min,
    Max,
    Pow,
    Atan2,
    Equal,
    NotEqual,
    Less,
    LessEqual,
    IntAdd,
    IntSub,
    IntMul,
    IntDiv,
    IntRem,
    IntMin,
    IntMax,
    IntLess,
    IntLessEqual,
    UintDiv,
    UintRem,
    UintMin,
    UintMax,
    UintLess,
    UintLessEqual,
    BitsEqual,
    BitsNotEqual,
    And,
    Or,
    Xor,
    ShiftLeft,
    ShiftRight,
    UintShiftRight,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Three {
    /// a * b + c
    MulAdd,
    /// a * b - c
    MulSub,
    /// b where a, else c
    Select,
}

#[inline(always)]
pub fn one(f: One, a: &Lanes) -> Lanes {
    match f {
        One::Copy => *a,
        One::Not => word(a, |x| !x),
        One::Neg => word(a, |x| x ^ 0x8000_0000),
        One::Abs => word(a, |x| x & 0x7fff_ffff),
        One::Sign => float(a, |x| f32::from(x > 0.0) - f32::from(x < 0.0)),
        One::Floor => float(a, f32::floor),
        One::Ceil => float(a, f32::ceil),
        One::Round => float(a, f32::round_ties_even),
        One::Trunc => float(a, f32::trunc),
        One::Fract => float(a, |x| x - x.floor()),
        One::Sqrt => float(a, f32::sqrt),
        One::InverseSqrt => float(a, |x| 1.0 / x.sqrt()),
        One::Exp => float(a, f32::exp),
        One::Exp2 => float(a, f32::exp2),
        One::Log => float(a, f32::ln),
        One::Log2 => float(a, f32::log2),
        One::Sin => float(a, f32::sin),
        One::Cos => float(a, f32::cos),
        One::Tan => float(a, f32::tan),
        One::Asin => float(a, f32::asin),
        One::Acos => float(a, f32::acos),
        One::Atan => float(a, f32::atan),
        One::Sinh => float(a, f32::sinh),
        One::Cosh => float(a, f32::cosh),
        One::Tanh => float(a, f32::tanh),
        One::Asinh => float(a, f32::asinh),
        One::Acosh => float(a, f32::acosh),
        One::Atanh => float(a, f32::atanh),
        One::IntNeg => word(a, u32::wrapping_neg),
        One::IntAbs => word(a, |x| (x as i32).unsigned_abs()),
        One::IntSign => word(a, |x| (x as i32).signum() as u32),
        One::CountOneBits => word(a, u32::count_ones),
        One::CountTrailingZeros => word(a, u32::trailing_zeros),
        One::CountLeadingZeros => word(a, u32::leading_zeros),
        One::ReverseBits => word(a, u32::reverse_bits),
        One::FloatToInt => word(a, |x| f32::from_bits(x) as i32 as u32),
        One::FloatToUint => word(a, |x| f32::from_bits(x) as u32),
        One::IntToFloat => word(a, |x| (x as i32 as f32).to_bits()),
        One::UintToFloat => word(a, |x| (x as f32).to_bits()),
        One::FloatToBool => word(a, |x| mask(f32::from_bits(x) != 0.0)),
        One::BoolToFloat => word(a, |x| x & 1.0f32.to_bits()),
        One::IntToBool => word(a, |x| mask(x != 0)),
        One::BoolToInt => word(a, |x| x & 1),
        One::AlongX => each(|i| difference(a, i & !1, i | 1)),
        One::AlongY => each(|i| difference(a, i & !SIDE, i | SIDE)),
    }
}

#[inline(always)]
pub fn two(f: Two, a: &Lanes, b: &Lanes) -> Lanes {
    match f {
        Two::Add => floats(a, b, |x, y| x + y),
        Two::Sub => floats(a, b, |x, y| x - y),
        Two::Mul => floats(a, b, |x, y| x * y),
        Two::Div => floats(a, b, |x, y| x / y),
        Two::Rem => floats(a, b, |x, y| x % y),
        Two::Min => floats(a, b, |x, y| if y < x { y } else { x }),
        Two::Max => floats(a, b, |x, y| if x < y { y } else { x }),
        Two::Pow => floats(a, b, f32::powf),
        Two::Atan2 => floats(a, b, f32::atan2),
        Two::Equal => compared(a, b, |x, y| x == y),
        Two::NotEqual => compared(a, b, |x, y| x != y),
        Two::Less => compared(a, b, |x, y| x < y),
        Two::LessEqual => compared(a, b, |x, y| x <= y),
        Two::IntAdd => words(a, b, u32::wrapping_add),
        Two::IntSub => words(a, b, u32::wrapping_sub),
        Two::IntMul => words(a, b, u32::wrapping_mul),
        // By zero WGSL gives the dividend, and no rest.
        Two::IntDiv => ints(a, b, |x, y| if y == 0 { x } else { x.wrapping_div(y) }),
        Two::IntRem => ints(a, b, |x, y| if y == 0 { 0 } else { x.wrapping_rem(y) }),
        Two::UintDiv => words(a, b, |x, y| x.checked_div(y).unwrap_or(x)),
        Two::UintRem => words(a, b, |x, y| x.checked_rem(y).unwrap_or(0)),
        Two::IntMin => ints(a, b, i32::min),
        Two::IntMax => ints(a, b, i32::max),
        Two::IntLess => words(a, b, |x, y| mask((x as i32) < y as i32)),
        Two::IntLessEqual => words(a, b, |x, y| mask(x as i32 <= y as i32)),
        Two::UintMin => words(a, b, u32::min),
        Two::UintMax => words(a, b, u32::max),
        Two::UintLess => words(a, b, |x, y| mask(x < y)),
        Two::UintLessEqual => words(a, b, |x, y| mask(x <= y)),
        Two::BitsEqual => words(a, b, |x, y| mask(x == y)),
        Two::BitsNotEqual => words(a, b, |x, y| mask(x != y)),
        Two::And => words(a, b, |x, y| x & y),
        Two::Or => words(a, b, |x, y| x | y),
        Two::Xor => words(a, b, |x, y| x ^ y),
        Two::ShiftLeft => words(a, b, u32::wrapping_shl),
        Two::ShiftRight => words(a, b, |x, y| (x as i32).wrapping_shr(y) as u32),
        Two::UintShiftRight => words(a, b, u32::wrapping_shr),
    }
}

#[inline(always)]
pub fn three(f: Three, a: &Lanes, b: &Lanes, c: &Lanes) -> Lanes {
    let value = |x: u32| f32::from_bits(x);
    match f {
        Three::MulAdd => each(|i| (value(a[i]) * value(b[i]) + value(c[i])).to_bits()),
        Three::MulSub => each(|i| (value(a[i]) * value(b[i]) - value(c[i])).to_bits()),
        Three::Select => each(|i| (a[i] & b[i]) | (!a[i] & c[i])),
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
