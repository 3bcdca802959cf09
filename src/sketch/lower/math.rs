//! The functions of WGSL, made of fewer.

use naga::{MathFunction, ScalarKind, TypeInner};

use super::operators::kind;
use super::{Lowering, Result, unsupported};
use crate::sketch::lanes::{One, Three, Two};
use crate::sketch::program::Reg;

impl Lowering<'_> {
    /// `ty` is the first argument's.
    pub fn math(&mut self, f: MathFunction, arguments: &[Vec<Reg>], ty: &TypeInner) -> Result<Vec<Reg>> {
        let kind = kind(ty)?;
        if let Some(f) = one(f, kind) {
            return Ok(arguments[0].iter().map(|a| self.one(f, *a)).collect());
        }
        if let Some(f) = two(f, kind) {
            let (a, b) = (&arguments[0], &arguments[1]);
            return Ok(a.iter().zip(b).map(|(a, b)| self.two(f, *a, *b)).collect());
        }
        let a = &arguments[0];
        match f {
            MathFunction::Dot if kind == ScalarKind::Float => Ok(vec![self.dot(a, &arguments[1])]),
            MathFunction::Dot => {
                let products: Vec<Reg> =
                    a.iter().zip(&arguments[1]).map(|(a, b)| self.two(Two::IntMul, *a, *b)).collect();
                let sum = products[1..].iter().fold(products[0], |sum, x| self.two(Two::IntAdd, sum, *x));
                Ok(vec![sum])
            }
            MathFunction::Length => Ok(vec![self.length(a)]),
            MathFunction::Distance => {
                let apart = self.difference(a, &arguments[1]);
                Ok(vec![self.length(&apart)])
            }
            MathFunction::Normalize => {
                let length = self.length(a);
                Ok(a.iter().map(|a| self.two(Two::Div, *a, length)).collect())
            }
            MathFunction::Cross => {
                let b = &arguments[1];
                let part = |lowering: &mut Self, i: usize| {
                    let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                    let other = lowering.two(Two::Mul, a[k], b[j]);
                    lowering.three(Three::MulSub, a[j], b[k], other)
                };
                Ok((0..3).map(|i| part(self, i)).collect())
            }
            MathFunction::Reflect => {
                let n = &arguments[1];
                let cosine = self.dot(a, n);
                let twice = self.two(Two::Add, cosine, cosine);
                let back = |lowering: &mut Self, n| lowering.two(Two::Mul, twice, n);
                let back: Vec<Reg> = n.iter().map(|n| back(self, *n)).collect();
                Ok(self.difference(a, &back))
            }
            MathFunction::FaceForward => {
                let (zero, cosine) = (self.float(0.0)?, self.dot(&arguments[1], &arguments[2]));
                let is_facing = self.two(Two::Less, cosine, zero);
                let turned = |lowering: &mut Self, a| {
                    let back = lowering.one(One::Neg, a);
                    lowering.three(Three::Select, is_facing, a, back)
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
            MathFunction::Fma => self.three(Three::MulAdd, x[0], x[1], x[2]),
            MathFunction::Mix => {
                let one = self.float(1.0)?;
                let rest = self.two(Two::Sub, one, x[2]);
                let share = self.two(Two::Mul, x[1], x[2]);
                self.three(Three::MulAdd, x[0], rest, share)
            }
            MathFunction::Step => {
                let is_past = self.two(Two::LessEqual, x[0], x[1]);
                self.one(One::BoolToFloat, is_past)
            }
            MathFunction::SmoothStep => {
                let (zero, one) = (self.float(0.0)?, self.float(1.0)?);
                let (two, three) = (self.float(2.0)?, self.float(3.0)?);
                let way = self.two(Two::Sub, x[2], x[0]);
                let whole = self.two(Two::Sub, x[1], x[0]);
                let share = self.two(Two::Div, way, whole);
                let t = self.clamp(ScalarKind::Float, share, zero, one);
                let twice = self.two(Two::Mul, two, t);
                let rest = self.two(Two::Sub, three, twice);
                let square = self.two(Two::Mul, t, t);
                self.two(Two::Mul, square, rest)
            }
            MathFunction::Radians => {
                let unit = self.float(1f32.to_radians())?;
                self.two(Two::Mul, x[0], unit)
            }
            MathFunction::Degrees => {
                let unit = self.float(1f32.to_degrees())?;
                self.two(Two::Mul, x[0], unit)
            }
            other => return unsupported(other),
        })
    }

    /// `ratio * a - (ratio * cosine + sqrt(k)) * n`, nothing where k is negative.
    fn refract(&mut self, a: &[Reg], n: &[Reg], ratio: Reg) -> Result<Vec<Reg>> {
        let (zero, one) = (self.float(0.0)?, self.float(1.0)?);
        let cosine = self.dot(n, a);
        let square = self.two(Two::Mul, cosine, cosine);
        let sine = self.two(Two::Sub, one, square);
        let ratio2 = self.two(Two::Mul, ratio, ratio);
        let bent = self.two(Two::Mul, ratio2, sine);
        let k = self.two(Two::Sub, one, bent);
        let root = self.one(One::Sqrt, k);
        let back = self.three(Three::MulAdd, ratio, cosine, root);
        let is_none = self.two(Two::Less, k, zero);
        let part = |lowering: &mut Self, a, n| {
            let away = lowering.two(Two::Mul, back, n);
            let through = lowering.three(Three::MulSub, ratio, a, away);
            lowering.three(Three::Select, is_none, zero, through)
        };
        Ok(a.iter().zip(n).map(|(a, n)| part(self, *a, *n)).collect())
    }

    fn clamp(&mut self, kind: ScalarKind, x: Reg, low: Reg, high: Reg) -> Reg {
        let (min, max) = (two(MathFunction::Min, kind), two(MathFunction::Max, kind));
        let raised = self.two(max.expect("each kind has it"), x, low);
        self.two(min.expect("each kind has it"), raised, high)
    }

    fn length(&mut self, a: &[Reg]) -> Reg {
        let square = self.dot(a, a);
        self.one(One::Sqrt, square)
    }

    fn difference(&mut self, a: &[Reg], b: &[Reg]) -> Vec<Reg> {
        a.iter().zip(b).map(|(a, b)| self.two(Two::Sub, *a, *b)).collect()
    }
}

fn one(f: MathFunction, kind: ScalarKind) -> Option<One> {
    use MathFunction as Math;
    Some(match (f, kind) {
        (Math::Abs, ScalarKind::Float) => One::Abs,
        (Math::Abs, ScalarKind::Sint) => One::IntAbs,
        (Math::Abs, ScalarKind::Uint) => One::Copy,
        (Math::Sign, ScalarKind::Float) => One::Sign,
        (Math::Sign, _) => One::IntSign,
        (Math::Floor, _) => One::Floor,
        (Math::Ceil, _) => One::Ceil,
        (Math::Round, _) => One::Round,
        (Math::Trunc, _) => One::Trunc,
        (Math::Fract, _) => One::Fract,
        (Math::Sqrt, _) => One::Sqrt,
        (Math::InverseSqrt, _) => One::InverseSqrt,
        (Math::Exp, _) => One::Exp,
        (Math::Exp2, _) => One::Exp2,
        (Math::Log, _) => One::Log,
        (Math::Log2, _) => One::Log2,
        (Math::Sin, _) => One::Sin,
        (Math::Cos, _) => One::Cos,
        (Math::Tan, _) => One::Tan,
        (Math::Asin, _) => One::Asin,
        (Math::Acos, _) => One::Acos,
        (Math::Atan, _) => One::Atan,
        (Math::Sinh, _) => One::Sinh,
        (Math::Cosh, _) => One::Cosh,
        (Math::Tanh, _) => One::Tanh,
        (Math::Asinh, _) => One::Asinh,
        (Math::Acosh, _) => One::Acosh,
        (Math::Atanh, _) => One::Atanh,
        (Math::CountOneBits, _) => One::CountOneBits,
        (Math::CountTrailingZeros, _) => One::CountTrailingZeros,
        (Math::CountLeadingZeros, _) => One::CountLeadingZeros,
        (Math::ReverseBits, _) => One::ReverseBits,
        _ => return None,
    })
}

fn two(f: MathFunction, kind: ScalarKind) -> Option<Two> {
    use MathFunction as Math;
    Some(match (f, kind) {
        (Math::Min, ScalarKind::Float) => Two::Min,
        (Math::Min, ScalarKind::Sint) => Two::IntMin,
        (Math::Min, _) => Two::UintMin,
        (Math::Max, ScalarKind::Float) => Two::Max,
        (Math::Max, ScalarKind::Sint) => Two::IntMax,
        (Math::Max, _) => Two::UintMax,
        (Math::Pow, _) => Two::Pow,
        (Math::Atan2, _) => Two::Atan2,
        _ => return None,
    })
}
