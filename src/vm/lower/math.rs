//! The functions of WGSL, made of fewer.

use naga::{MathFunction, ScalarKind, TypeInner};

use super::operators::kind;
use super::{Lowering, Result, unsupported};
use crate::op::{BinaryOp, TernaryOp, UnaryOp};
use crate::program::Reg;

impl Lowering<'_> {
    /// `ty` is the first argument's.
    pub fn math(&mut self, f: MathFunction, arguments: &[Vec<Reg>], ty: &TypeInner) -> Result<Vec<Reg>> {
        let kind = kind(ty)?;
        if let Some(f) = unary_op(f, kind) {
            return Ok(arguments[0].iter().map(|a| self.emit_unary(f, *a)).collect());
        }
        if let Some(f) = binary_op(f, kind) {
            let (a, b) = (&arguments[0], &arguments[1]);
            return Ok(a.iter().zip(b).map(|(a, b)| self.emit_binary(f, *a, *b)).collect());
        }
        let a = &arguments[0];
        match f {
            MathFunction::Dot if kind == ScalarKind::Float => Ok(vec![self.dot(a, &arguments[1])]),
            MathFunction::Dot => {
                let products: Vec<Reg> = a
                    .iter()
                    .zip(&arguments[1])
                    .map(|(a, b)| self.emit_binary(BinaryOp::IntMul, *a, *b))
                    .collect();
                let sum = products[1..]
                    .iter()
                    .fold(products[0], |sum, x| self.emit_binary(BinaryOp::IntAdd, sum, *x));
                Ok(vec![sum])
            }
            MathFunction::Length => Ok(vec![self.length(a)]),
            MathFunction::Distance => {
                let apart = self.difference(a, &arguments[1]);
                Ok(vec![self.length(&apart)])
            }
            MathFunction::Normalize => {
                let length = self.length(a);
                Ok(a.iter().map(|a| self.emit_binary(BinaryOp::Div, *a, length)).collect())
            }
            MathFunction::Cross => {
                let b = &arguments[1];
                let part = |lowering: &mut Self, i: usize| {
                    let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                    let other = lowering.emit_binary(BinaryOp::Mul, a[k], b[j]);
                    lowering.emit_ternary(TernaryOp::MulSub, a[j], b[k], other)
                };
                Ok((0..3).map(|i| part(self, i)).collect())
            }
            MathFunction::Determinant if a.len() == 4 => {
                let other = self.emit_binary(BinaryOp::Mul, a[2], a[1]);
                Ok(vec![self.emit_ternary(TernaryOp::MulSub, a[0], a[3], other)])
            }
            MathFunction::Reflect => {
                let n = &arguments[1];
                let cosine = self.dot(a, n);
                let twice = self.emit_binary(BinaryOp::Add, cosine, cosine);
                let back = |lowering: &mut Self, n| lowering.emit_binary(BinaryOp::Mul, twice, n);
                let back: Vec<Reg> = n.iter().map(|n| back(self, *n)).collect();
                Ok(self.difference(a, &back))
            }
            MathFunction::FaceForward => {
                let (zero, cosine) = (self.float(0.0)?, self.dot(&arguments[1], &arguments[2]));
                let is_facing = self.emit_binary(BinaryOp::Less, cosine, zero);
                let turned = |lowering: &mut Self, a| {
                    let back = lowering.emit_unary(UnaryOp::Neg, a);
                    lowering.emit_ternary(TernaryOp::Select, is_facing, a, back)
                };
                Ok(a.iter().map(|a| turned(self, *a)).collect())
            }
            MathFunction::Refract => self.refract(a, &arguments[1], arguments[2][0]),
            MathFunction::Transpose => {
                let TypeInner::Matrix { columns, rows, .. } = ty else { return unsupported(ty) };
                let (columns, rows) = (*columns as usize, *rows as usize);
                let places = (0..rows).flat_map(|row| (0..columns).map(move |column| column * rows + row));
                Ok(places.map(|place| a[place]).collect())
            }
            _ => (0..a.len()).map(|i| self.of_numbers(f, kind, arguments, i)).collect(),
        }
    }

    /// A function of several numbers that takes vectors one by one.
    fn of_numbers(
        &mut self,
        f: MathFunction,
        kind: ScalarKind,
        arguments: &[Vec<Reg>],
        i: usize,
    ) -> Result<Reg> {
        let x: Vec<Reg> = arguments.iter().map(|all| all[i.min(all.len() - 1)]).collect();
        Ok(match f {
            MathFunction::Clamp => self.clamp(kind, x[0], x[1], x[2]),
            MathFunction::Saturate => {
                let (zero, one) = (self.float(0.0)?, self.float(1.0)?);
                self.clamp(kind, x[0], zero, one)
            }
            MathFunction::Fma => self.emit_ternary(TernaryOp::MulAdd, x[0], x[1], x[2]),
            MathFunction::Mix => {
                let one = self.float(1.0)?;
                let rest = self.emit_binary(BinaryOp::Sub, one, x[2]);
                let share = self.emit_binary(BinaryOp::Mul, x[1], x[2]);
                self.emit_ternary(TernaryOp::MulAdd, x[0], rest, share)
            }
            MathFunction::Step => {
                let is_past = self.emit_binary(BinaryOp::LessEqual, x[0], x[1]);
                self.emit_unary(UnaryOp::BoolToFloat, is_past)
            }
            MathFunction::SmoothStep => {
                let (zero, one) = (self.float(0.0)?, self.float(1.0)?);
                let (two, three) = (self.float(2.0)?, self.float(3.0)?);
                let way = self.emit_binary(BinaryOp::Sub, x[2], x[0]);
                let whole = self.emit_binary(BinaryOp::Sub, x[1], x[0]);
                let share = self.emit_binary(BinaryOp::Div, way, whole);
                let t = self.clamp(ScalarKind::Float, share, zero, one);
                let twice = self.emit_binary(BinaryOp::Mul, two, t);
                let rest = self.emit_binary(BinaryOp::Sub, three, twice);
                let square = self.emit_binary(BinaryOp::Mul, t, t);
                self.emit_binary(BinaryOp::Mul, square, rest)
            }
            MathFunction::Radians => {
                let unit = self.float(1f32.to_radians())?;
                self.emit_binary(BinaryOp::Mul, x[0], unit)
            }
            MathFunction::Degrees => {
                let unit = self.float(1f32.to_degrees())?;
                self.emit_binary(BinaryOp::Mul, x[0], unit)
            }
            other => return unsupported(other),
        })
    }

    /// `ratio * a - (ratio * cosine + sqrt(k)) * n`, nothing where k is negative.
    fn refract(&mut self, a: &[Reg], n: &[Reg], ratio: Reg) -> Result<Vec<Reg>> {
        let (zero, one) = (self.float(0.0)?, self.float(1.0)?);
        let cosine = self.dot(n, a);
        let square = self.emit_binary(BinaryOp::Mul, cosine, cosine);
        let sine = self.emit_binary(BinaryOp::Sub, one, square);
        let ratio2 = self.emit_binary(BinaryOp::Mul, ratio, ratio);
        let bent = self.emit_binary(BinaryOp::Mul, ratio2, sine);
        let k = self.emit_binary(BinaryOp::Sub, one, bent);
        let root = self.emit_unary(UnaryOp::Sqrt, k);
        let back = self.emit_ternary(TernaryOp::MulAdd, ratio, cosine, root);
        let is_none = self.emit_binary(BinaryOp::Less, k, zero);
        let part = |lowering: &mut Self, a, n| {
            let away = lowering.emit_binary(BinaryOp::Mul, back, n);
            let through = lowering.emit_ternary(TernaryOp::MulSub, ratio, a, away);
            lowering.emit_ternary(TernaryOp::Select, is_none, zero, through)
        };
        Ok(a.iter().zip(n).map(|(a, n)| part(self, *a, *n)).collect())
    }

    fn clamp(&mut self, kind: ScalarKind, x: Reg, low: Reg, high: Reg) -> Reg {
        let (min, max) = (binary_op(MathFunction::Min, kind), binary_op(MathFunction::Max, kind));
        let raised = self.emit_binary(max.expect("each kind has it"), x, low);
        self.emit_binary(min.expect("each kind has it"), raised, high)
    }

    fn length(&mut self, a: &[Reg]) -> Reg {
        let square = self.dot(a, a);
        self.emit_unary(UnaryOp::Sqrt, square)
    }

    fn difference(&mut self, a: &[Reg], b: &[Reg]) -> Vec<Reg> {
        a.iter().zip(b).map(|(a, b)| self.emit_binary(BinaryOp::Sub, *a, *b)).collect()
    }
}

fn unary_op(f: MathFunction, kind: ScalarKind) -> Option<UnaryOp> {
    use MathFunction as Math;
    Some(match (f, kind) {
        (Math::Abs, ScalarKind::Float) => UnaryOp::Abs,
        (Math::Abs, ScalarKind::Sint) => UnaryOp::IntAbs,
        (Math::Abs, ScalarKind::Uint) => UnaryOp::Copy,
        (Math::Sign, ScalarKind::Float) => UnaryOp::Sign,
        (Math::Sign, _) => UnaryOp::IntSign,
        (Math::Floor, _) => UnaryOp::Floor,
        (Math::Ceil, _) => UnaryOp::Ceil,
        (Math::Round, _) => UnaryOp::Round,
        (Math::Trunc, _) => UnaryOp::Trunc,
        (Math::Fract, _) => UnaryOp::Fract,
        (Math::Sqrt, _) => UnaryOp::Sqrt,
        (Math::InverseSqrt, _) => UnaryOp::InverseSqrt,
        (Math::Exp, _) => UnaryOp::Exp,
        (Math::Exp2, _) => UnaryOp::Exp2,
        (Math::Log, _) => UnaryOp::Log,
        (Math::Log2, _) => UnaryOp::Log2,
        (Math::Sin, _) => UnaryOp::Sin,
        (Math::Cos, _) => UnaryOp::Cos,
        (Math::Tan, _) => UnaryOp::Tan,
        (Math::Asin, _) => UnaryOp::Asin,
        (Math::Acos, _) => UnaryOp::Acos,
        (Math::Atan, _) => UnaryOp::Atan,
        (Math::Sinh, _) => UnaryOp::Sinh,
        (Math::Cosh, _) => UnaryOp::Cosh,
        (Math::Tanh, _) => UnaryOp::Tanh,
        (Math::Asinh, _) => UnaryOp::Asinh,
        (Math::Acosh, _) => UnaryOp::Acosh,
        (Math::Atanh, _) => UnaryOp::Atanh,
        (Math::CountOneBits, _) => UnaryOp::CountOneBits,
        (Math::CountTrailingZeros, _) => UnaryOp::CountTrailingZeros,
        (Math::CountLeadingZeros, _) => UnaryOp::CountLeadingZeros,
        (Math::ReverseBits, _) => UnaryOp::ReverseBits,
        _ => return None,
    })
}

fn binary_op(f: MathFunction, kind: ScalarKind) -> Option<BinaryOp> {
    use MathFunction as Math;
    Some(match (f, kind) {
        (Math::Min, ScalarKind::Float) => BinaryOp::Min,
        (Math::Min, ScalarKind::Sint) => BinaryOp::IntMin,
        (Math::Min, _) => BinaryOp::UintMin,
        (Math::Max, ScalarKind::Float) => BinaryOp::Max,
        (Math::Max, ScalarKind::Sint) => BinaryOp::IntMax,
        (Math::Max, _) => BinaryOp::UintMax,
        (Math::Pow, _) => BinaryOp::Pow,
        (Math::Atan2, _) => BinaryOp::Atan2,
        _ => return None,
    })
}
