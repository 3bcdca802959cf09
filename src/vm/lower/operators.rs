//! Operators and conversions.

use naga::{BinaryOperator, RelationalFunction, ScalarKind, TypeInner, UnaryOperator};

use super::{Lowering, Result, unsupported};
use crate::op::{BinaryOp, TernaryOp, UnaryOp};
use crate::program::Reg;

impl Lowering<'_> {
    pub fn unary(&mut self, op: UnaryOperator, a: &[Reg], ty: &TypeInner) -> Result<Vec<Reg>> {
        let f = match (op, kind(ty)?) {
            (UnaryOperator::Negate, ScalarKind::Float) => UnaryOp::Neg,
            (UnaryOperator::Negate, _) => UnaryOp::IntNeg,
            (UnaryOperator::LogicalNot | UnaryOperator::BitwiseNot, _) => UnaryOp::Not,
        };
        Ok(a.iter().map(|a| self.emit_unary(f, *a)).collect())
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
            results.push(self.emit_binary(f, x, y));
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
        let first = self.emit_binary(BinaryOp::Mul, a[0], b[0]);
        a.iter().zip(b).skip(1).fold(first, |sum, (a, b)| self.emit_ternary(TernaryOp::MulAdd, *a, *b, sum))
    }

    pub fn relational(&mut self, fun: RelationalFunction, a: &[Reg], ty: &TypeInner) -> Result<Vec<Reg>> {
        let f = match fun {
            RelationalFunction::All => BinaryOp::And,
            RelationalFunction::Any => BinaryOp::Or,
            RelationalFunction::IsNan | RelationalFunction::IsInf => return unsupported((fun, ty)),
        };
        let all = a[1..].iter().fold(a[0], |all, a| self.emit_binary(f, all, *a));
        Ok(vec![all])
    }

    /// The same numbers in another kind.
    pub fn converted(&mut self, a: &[Reg], ty: &TypeInner, to: ScalarKind) -> Result<Vec<Reg>> {
        use ScalarKind::{Bool, Float, Sint, Uint};
        let f = match (kind(ty)?, to) {
            (Float, Sint) => UnaryOp::FloatToInt,
            (Float, Uint) => UnaryOp::FloatToUint,
            (Float, Bool) => UnaryOp::FloatToBool,
            (Sint, Float) => UnaryOp::IntToFloat,
            (Uint, Float) => UnaryOp::UintToFloat,
            (Sint | Uint, Bool) => UnaryOp::IntToBool,
            (Bool, Float) => UnaryOp::BoolToFloat,
            (Bool, Sint | Uint) => UnaryOp::BoolToInt,
            (Float, Float) | (Sint | Uint, Sint | Uint) | (Bool, Bool) => return Ok(a.to_vec()),
            other => return unsupported(other),
        };
        Ok(a.iter().map(|a| self.emit_unary(f, *a)).collect())
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
fn function(op: BinaryOperator, kind: ScalarKind) -> Result<(BinaryOp, bool)> {
    use BinaryOperator as Binary;
    let of = |float, int, uint| match kind {
        ScalarKind::Float => float,
        ScalarKind::Sint => int,
        _ => uint,
    };
    let less = of(BinaryOp::Less, BinaryOp::IntLess, BinaryOp::UintLess);
    let less_equal = of(BinaryOp::LessEqual, BinaryOp::IntLessEqual, BinaryOp::UintLessEqual);
    Ok(match op {
        Binary::Add => (of(BinaryOp::Add, BinaryOp::IntAdd, BinaryOp::IntAdd), false),
        Binary::Subtract => (of(BinaryOp::Sub, BinaryOp::IntSub, BinaryOp::IntSub), false),
        Binary::Multiply => (of(BinaryOp::Mul, BinaryOp::IntMul, BinaryOp::IntMul), false),
        Binary::Divide => (of(BinaryOp::Div, BinaryOp::IntDiv, BinaryOp::UintDiv), false),
        Binary::Modulo => (of(BinaryOp::Rem, BinaryOp::IntRem, BinaryOp::UintRem), false),
        Binary::Equal => (of(BinaryOp::Equal, BinaryOp::BitsEqual, BinaryOp::BitsEqual), false),
        Binary::NotEqual => (of(BinaryOp::NotEqual, BinaryOp::BitsNotEqual, BinaryOp::BitsNotEqual), false),
        Binary::Less => (less, false),
        Binary::LessEqual => (less_equal, false),
        Binary::Greater => (less, true),
        Binary::GreaterEqual => (less_equal, true),
        Binary::And | Binary::LogicalAnd => (BinaryOp::And, false),
        Binary::InclusiveOr | Binary::LogicalOr => (BinaryOp::Or, false),
        Binary::ExclusiveOr => (BinaryOp::Xor, false),
        Binary::ShiftLeft => (BinaryOp::ShiftLeft, false),
        Binary::ShiftRight => {
            (of(BinaryOp::ShiftRight, BinaryOp::ShiftRight, BinaryOp::UintShiftRight), false)
        }
    })
}
