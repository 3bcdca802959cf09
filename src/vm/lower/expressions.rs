//! Expressions, by what they are made of.

use naga::{
    DerivativeAxis, DerivativeControl, Expression, Handle, ImageQuery, Literal, SampleLevel, TypeInner,
};

use super::places::count_of;
use super::{Body, Lowering, Result, unsupported};
use crate::op::{BinaryOp, TernaryOp, UnaryOp};
use crate::program::{Op, Reg};

impl<'m> Lowering<'m> {
    /// The registers of a value.
    pub fn value(&mut self, body: &mut Body<'m>, expression: Handle<Expression>) -> Result<Vec<Reg>> {
        if let Some(registers) = &body.values[expression.index()] {
            return Ok(registers.clone());
        }
        self.evaluate(body, expression)?;
        match &body.values[expression.index()] {
            Some(registers) => Ok(registers.clone()),
            None => unsupported(&body.function.expressions[expression]),
        }
    }

    pub fn scalar(&mut self, body: &mut Body<'m>, expression: Handle<Expression>) -> Result<Reg> {
        Ok(self.value(body, expression)?[0])
    }

    /// Computes a value where it stands. Pointers have none.
    pub fn evaluate(&mut self, body: &mut Body<'m>, expression: Handle<Expression>) -> Result<()> {
        if matches!(
            body.inner(self.module, expression),
            TypeInner::Pointer { .. }
                | TypeInner::ValuePointer { .. }
                | TypeInner::Image { .. }
                | TypeInner::Sampler { .. }
        ) {
            return Ok(());
        }
        let registers = self.computed(body, expression)?;
        body.values[expression.index()] = Some(registers);
        Ok(())
    }

    fn computed(&mut self, body: &mut Body<'m>, handle: Handle<Expression>) -> Result<Vec<Reg>> {
        let inner = |body: &Body<'m>, h| body.inner(self.module, h).clone();
        match &body.function.expressions[handle] {
            Expression::Literal(literal) => Ok(vec![self.literal(*literal)?]),
            Expression::Constant(constant) => self.constant_value(self.module.constants[*constant].init),
            Expression::ZeroValue(ty) => {
                let size = self.size(&self.module.types[*ty].inner)?;
                Ok(vec![self.constant(0)?; size as usize])
            }
            Expression::Compose { components, .. } => {
                let mut all = vec![];
                for component in components {
                    all.extend(self.value(body, *component)?);
                }
                Ok(all)
            }
            Expression::Splat { size, value } => Ok(vec![self.scalar(body, *value)?; *size as usize]),
            Expression::Swizzle { size, vector, pattern } => {
                let from = self.value(body, *vector)?;
                Ok(pattern[..*size as usize].iter().map(|c| from[*c as usize]).collect())
            }
            Expression::AccessIndex { base, index } => {
                let whole = self.value(body, *base)?;
                self.part(body.inner(self.module, *base), *index, &whole)
            }
            Expression::Access { base, index } => {
                let whole = self.value(body, *base)?;
                let count = count_of(&inner(body, *base))?;
                let index = self.scalar(body, *index)?;
                self.chosen(&whole, count, index)
            }
            Expression::FunctionArgument(index) => Ok(body.arguments[*index as usize].clone()),
            Expression::Load { pointer } => {
                let size = self.size(body.inner(self.module, handle))?;
                let place = self.place(body, *pointer)?;
                self.load(&place, size)
            }
            Expression::Unary { op, expr } => {
                let (a, ty) = (self.value(body, *expr)?, inner(body, *expr));
                self.unary(*op, &a, &ty)
            }
            Expression::Binary { op, left, right } => {
                let (a, b) = (self.value(body, *left)?, self.value(body, *right)?);
                let types = [inner(body, *left), inner(body, *right)];
                self.binary(*op, &a, &b, &types)
            }
            Expression::Select { condition, accept, reject } => {
                let [condition, a, b] = [*condition, *accept, *reject].map(|h| self.value(body, h));
                let (condition, a, b) = (condition?, a?, b?);
                let is = |i: usize| condition[i.min(condition.len() - 1)];
                Ok((0..a.len()).map(|i| self.emit_ternary(TernaryOp::Select, is(i), a[i], b[i])).collect())
            }
            Expression::Derivative { axis, ctrl: DerivativeControl::None, expr } => {
                let values = self.value(body, *expr)?;
                Ok(values.into_iter().map(|a| self.derivative(*axis, a)).collect())
            }
            Expression::Relational { fun, argument } => {
                let (a, ty) = (self.value(body, *argument)?, inner(body, *argument));
                self.relational(*fun, &a, &ty)
            }
            Expression::Math { fun, arg, arg1, arg2, arg3: None } => {
                let mut arguments = vec![];
                for argument in [Some(*arg), *arg1, *arg2].into_iter().flatten() {
                    arguments.push(self.value(body, argument)?);
                }
                let ty = inner(body, *arg);
                self.math(*fun, &arguments, &ty)
            }
            Expression::As { expr, kind, convert } => {
                let (a, ty) = (self.value(body, *expr)?, inner(body, *expr));
                match convert {
                    None => Ok(a),
                    Some(_) => self.converted(&a, &ty, *kind),
                }
            }
            Expression::ImageLoad { image, coordinate, array_index: None, sample: None, .. } => {
                let (image, at) = (self.image(body, *image)?, self.value(body, *coordinate)?);
                let to = self.registers(4);
                self.program.ops.push(Op::Texel { to, image, x: at[0], y: at[1] });
                Ok((to..to + 4).collect())
            }
            Expression::ImageSample { image, coordinate, level, gather: None, .. } => {
                let (image, at) = (self.image(body, *image)?, self.value(body, *coordinate)?);
                let level = match level {
                    SampleLevel::Exact(level) => self.scalar(body, *level)?,
                    SampleLevel::Zero => self.float(0.0)?,
                    other => return unsupported(other),
                };
                let to = self.registers(4);
                self.program.ops.push(Op::Sample { to, image, u: at[0], v: at[1], level });
                Ok((to..to + 4).collect())
            }
            Expression::ImageQuery { image, query: ImageQuery::Size { level: None } } => {
                let image = self.image(body, *image)?;
                let to = self.registers(2);
                self.program.ops.push(Op::Size { to, image });
                Ok((to..to + 2).collect())
            }
            other => unsupported(other),
        }
    }

    /// The binding of an image in group 1.
    pub fn image(&self, body: &Body<'m>, image: Handle<Expression>) -> Result<u32> {
        let handle = match &body.function.expressions[image] {
            Expression::GlobalVariable(handle) => *handle,
            Expression::FunctionArgument(index) if !body.images.is_empty() => {
                return body.images[*index as usize].map_or_else(|| unsupported("no image"), Ok);
            }
            other => return unsupported(other),
        };
        let variable = &self.module.global_variables[handle];
        match &variable.binding {
            // The samples before: there are none, as in an image that no scene has.
            Some(binding) if binding.group == 0 => Ok(0),
            Some(binding) => Ok(binding.binding),
            None => unsupported(variable),
        }
    }

    /// One of `count` parts of a whole.
    fn chosen(&mut self, whole: &[Reg], count: u32, index: Reg) -> Result<Vec<Reg>> {
        let size = whole.len() / count as usize;
        // The parts need not lie in a row.
        let first = self.registers(whole.len() as u32);
        (first..).zip(whole).for_each(|(to, a)| self.copy(to, *a));
        let part = self.registers(size as u32);
        for i in 0..size as u32 {
            let op = Op::Gather { to: part + i, first: first + i, stride: size as u32, count, index };
            self.program.ops.push(op);
        }
        Ok((part..part + size as u32).collect())
    }

    fn derivative(&mut self, axis: DerivativeAxis, a: Reg) -> Reg {
        match axis {
            DerivativeAxis::X => self.emit_unary(UnaryOp::AlongX, a),
            DerivativeAxis::Y => self.emit_unary(UnaryOp::AlongY, a),
            DerivativeAxis::Width => {
                let [x, y] = [UnaryOp::AlongX, UnaryOp::AlongY].map(|f| {
                    let along = self.emit_unary(f, a);
                    self.emit_unary(UnaryOp::Abs, along)
                });
                self.emit_binary(BinaryOp::Add, x, y)
            }
        }
    }

    fn literal(&mut self, literal: Literal) -> Result<Reg> {
        self.constant(match literal {
            Literal::F32(x) => x.to_bits(),
            Literal::U32(x) => x,
            Literal::I32(x) => x as u32,
            Literal::Bool(x) => u32::from(x).wrapping_neg(),
            other => return unsupported(other),
        })
    }

    /// A value that is the same everywhere.
    pub fn constant_value(&mut self, handle: Handle<Expression>) -> Result<Vec<Reg>> {
        match &self.module.global_expressions[handle] {
            Expression::Literal(literal) => Ok(vec![self.literal(*literal)?]),
            Expression::Constant(constant) => self.constant_value(self.module.constants[*constant].init),
            Expression::ZeroValue(ty) => {
                let size = self.size(&self.module.types[*ty].inner)?;
                Ok(vec![self.constant(0)?; size as usize])
            }
            Expression::Splat { size, value } => Ok(vec![self.constant_value(*value)?[0]; *size as usize]),
            Expression::Compose { components, .. } => {
                let mut all = vec![];
                for component in components {
                    all.extend(self.constant_value(*component)?);
                }
                Ok(all)
            }
            other => unsupported(other),
        }
    }
}
