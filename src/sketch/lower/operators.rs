//! Operators and conversions.

use naga::{BinaryOperator, RelationalFunction, ScalarKind, TypeInner, UnaryOperator};

use super::{Lowering, Result, unsupported};
use crate::sketch::lanes::{One, Three, Two};
use crate::sketch::program::Reg;

impl Lowering<'_> {
    pub fn unary(&mut self, op: UnaryOperator, a: &[Reg], ty: &TypeInner) -> Result<Vec<Reg>> {
        let f = match (op, kind(ty)?) {
            (UnaryOperator::Negate, ScalarKind::Float) => One::Neg,
            (UnaryOperator::Negate, _) => One::IntNeg,
            (UnaryOperator::LogicalNot | UnaryOperator::BitwiseNot, _) => One::Not,
        };
        Ok(a.iter().map(|a| self.one(f, *a)).collect())
    }

    pub fn binary(
        &mut self,
        op: BinaryOperator,
        a: &[Reg],
        b: &[Reg],
        types: &[TypeInner; 2],
    ) -> Result<Vec<Reg>> {
        if op == BinaryOperator::Multiply {
            match types {
                [TypeInner::Matrix { rows, .. }, TypeInner::Vector { .. } | TypeInner::Matrix { .. }] => {
                    return Ok(self.matrix_times(a, *rows as usize, b));
                }
                [TypeInner::Vector { size, .. }, TypeInner::Matrix { .. }] => {
                    let columns = b.chunks(*size as usize);
                    return Ok(columns.map(|column| self.dot(a, column)).collect());
                }
                _ => {}
            }
        }
        let (f, turned) = function(op, kind(&types[0])?)?;
        let size = a.len().max(b.len());
        let of = |all: &[Reg], i: usize| all[i.min(all.len() - 1)];
        let mut results = vec![];
        for i in 0..size {
            let (x, y) = if turned { (of(b, i), of(a, i)) } else { (of(a, i), of(b, i)) };
            results.push(self.two(f, x, y));
        }
        Ok(results)
    }

    /// Columns of a matrix, each by a number of `b`, added up; for each column of `b`.
    fn matrix_times(&mut self, a: &[Reg], rows: usize, b: &[Reg]) -> Vec<Reg> {
        let columns = a.len() / rows;
        let mut results = vec![];
        for part in b.chunks(columns) {
            for row in 0..rows {
                let along: Vec<Reg> = (0..columns).map(|column| a[column * rows + row]).collect();
                results.push(self.dot(&along, part));
            }
        }
        results
    }

    pub fn dot(&mut self, a: &[Reg], b: &[Reg]) -> Reg {
        let first = self.two(Two::Mul, a[0], b[0]);
        a.iter().zip(b).skip(1).fold(first, |sum, (a, b)| self.three(Three::MulAdd, *a, *b, sum))
    }

    pub fn relational(&mut self, fun: RelationalFunction, a: &[Reg], ty: &TypeInner) -> Result<Vec<Reg>> {
        let f = match fun {
            RelationalFunction::All => Two::And,
            RelationalFunction::Any => Two::Or,
            RelationalFunction::IsNan | RelationalFunction::IsInf => return unsupported((fun, ty)),
        };
        let all = a[1..].iter().fold(a[0], |all, a| self.two(f, all, *a));
        Ok(vec![all])
    }

    /// The same numbers in another kind.
    pub fn converted(&mut self, a: &[Reg], ty: &TypeInner, to: ScalarKind) -> Result<Vec<Reg>> {
        use ScalarKind::{Bool, Float, Sint, Uint};
        let f = match (kind(ty)?, to) {
            (Float, Sint) => One::FloatToInt,
            (Float, Uint) => One::FloatToUint,
            (Float, Bool) => One::FloatToBool,
            (Sint, Float) => One::IntToFloat,
            (Uint, Float) => One::UintToFloat,
            (Sint | Uint, Bool) => One::IntToBool,
            (Bool, Float) => One::BoolToFloat,
            (Bool, Sint | Uint) => One::BoolToInt,
            (Float, Float) | (Sint | Uint, Sint | Uint) | (Bool, Bool) => return Ok(a.to_vec()),
            other => return unsupported(other),
        };
        Ok(a.iter().map(|a| self.one(f, *a)).collect())
    }
}

/// What kind of numbers a value is made of.
pub fn kind(ty: &TypeInner) -> Result<ScalarKind> {
    match ty {
        TypeInner::Scalar(scalar) | TypeInner::Vector { scalar, .. } | TypeInner::Matrix { scalar, .. } => {
            Ok(scalar.kind)
        }
        other => unsupported(other),
    }
}

/// The step for an operator, and whether its sides change places.
fn function(op: BinaryOperator, kind: ScalarKind) -> Result<(Two, bool)> {
    use BinaryOperator as Binary;
    let of = |float, int, uint| match kind {
        ScalarKind::Float => float,
        ScalarKind::Sint => int,
        _ => uint,
    };
    let less = of(Two::Less, Two::IntLess, Two::UintLess);
    let less_equal = of(Two::LessEqual, Two::IntLessEqual, Two::UintLessEqual);
    Ok(match op {
        Binary::Add => (of(Two::Add, Two::IntAdd, Two::IntAdd), false),
        Binary::Subtract => (of(Two::Sub, Two::IntSub, Two::IntSub), false),
        Binary::Multiply => (of(Two::Mul, Two::IntMul, Two::IntMul), false),
        Binary::Divide => (of(Two::Div, Two::IntDiv, Two::UintDiv), false),
        Binary::Modulo => (of(Two::Rem, Two::IntRem, Two::UintRem), false),
        Binary::Equal => (of(Two::Equal, Two::BitsEqual, Two::BitsEqual), false),
        Binary::NotEqual => (of(Two::NotEqual, Two::BitsNotEqual, Two::BitsNotEqual), false),
        Binary::Less => (less, false),
        Binary::LessEqual => (less_equal, false),
        Binary::Greater => (less, true),
        Binary::GreaterEqual => (less_equal, true),
        Binary::And | Binary::LogicalAnd => (Two::And, false),
        Binary::InclusiveOr | Binary::LogicalOr => (Two::Or, false),
        Binary::ExclusiveOr => (Two::Xor, false),
        Binary::ShiftLeft => (Two::ShiftLeft, false),
        Binary::ShiftRight => (of(Two::ShiftRight, Two::ShiftRight, Two::UintShiftRight), false),
    })
}
