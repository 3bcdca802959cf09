//! Places in memory: what pointers point to.

use naga::{AddressSpace, Expression, Handle, TypeInner};

use super::{Body, Lowering, Result, unsupported};
use crate::op::UnaryOp;
use crate::program::{Buffer, Op, Reg};

/// Where a value lies, and what chooses among several of its kind.
pub struct Place {
    base: Base,
    /// Registers or words after the base.
    offset: u32,
    chosen: Option<Chosen>,
    /// Whether nobody looks there once the function has returned.
    is_local: bool,
}

#[derive(Clone, Copy)]
enum Base {
    Registers(Reg),
    Buffer(Buffer),
}

/// `stride * index`, where index ends at `count`.
struct Chosen {
    index: Reg,
    stride: u32,
    count: u32,
}

impl<'m> Lowering<'m> {
    pub fn place(&mut self, body: &mut Body<'m>, pointer: Handle<Expression>) -> Result<Place> {
        match &body.function.expressions[pointer] {
            Expression::LocalVariable(local) => {
                let base = Base::Registers(body.locals[local.index()]);
                Ok(Place { base, offset: 0, chosen: None, is_local: true })
            }
            Expression::FunctionArgument(index) => {
                let base = Base::Registers(body.arguments[*index as usize][0]);
                Ok(Place { base, offset: 0, chosen: None, is_local: false })
            }
            Expression::GlobalVariable(handle) => {
                let variable = &self.module.global_variables[*handle];
                let base = match (variable.space, variable.binding) {
                    (AddressSpace::Uniform, Some(binding)) => Base::Buffer(match binding.binding {
                        0 => Buffer::Frame,
                        2 => Buffer::Numbers,
                        4 => Buffer::Corner,
                        other => return unsupported(other),
                    }),
                    _ => match self.globals.get(handle) {
                        Some(first) => Base::Registers(*first),
                        None => return unsupported(variable),
                    },
                };
                Ok(Place { base, offset: 0, chosen: None, is_local: false })
            }
            Expression::AccessIndex { base, index } => {
                let mut place = self.place(body, *base)?;
                let pointee = self.pointee(body, *base)?;
                place.offset += self.offset_of(&pointee, *index, place.base)?;
                Ok(place)
            }
            Expression::Access { base, index } => {
                let mut place = self.place(body, *base)?;
                let pointee = self.pointee(body, *base)?;
                let (stride, count) = (self.offset_of(&pointee, 1, place.base)?, count_of(&pointee)?);
                let index = self.scalar(body, *index)?;
                if place.chosen.is_some() {
                    return unsupported("an index behind an index");
                }
                place.chosen = Some(Chosen { index, stride, count });
                Ok(place)
            }
            other => unsupported(other),
        }
    }

    fn pointee(&self, body: &Body<'m>, pointer: Handle<Expression>) -> Result<TypeInner> {
        Ok(match body.inner(self.module, pointer) {
            TypeInner::Pointer { base, .. } => self.module.types[*base].inner.clone(),
            TypeInner::ValuePointer { size: Some(size), scalar, .. } => {
                TypeInner::Vector { size: *size, scalar: *scalar }
            }
            TypeInner::ValuePointer { size: None, scalar, .. } => TypeInner::Scalar(*scalar),
            other => return unsupported(other),
        })
    }

    /// Where part `index` of a value begins, in registers or in words of a buffer.
    fn offset_of(&self, inner: &TypeInner, index: u32, base: Base) -> Result<u32> {
        let types = &self.module.types;
        let is_buffer = matches!(base, Base::Buffer(_));
        Ok(match inner {
            TypeInner::Vector { .. } => index,
            TypeInner::Matrix { rows, .. } if !is_buffer => index * *rows as u32,
            TypeInner::Array { stride, .. } if is_buffer => index * stride / 4,
            TypeInner::Array { base, .. } => index * self.size(&types[*base].inner)?,
            TypeInner::Struct { members, .. } if is_buffer => members[index as usize].offset / 4,
            TypeInner::Struct { members, .. } => {
                let before = &members[..index as usize];
                before.iter().map(|member| self.size(&types[member.ty].inner)).sum::<Result<u32>>()?
            }
            other => return unsupported(other),
        })
    }

    /// The registers of part `index` among those of a whole value.
    pub fn part(&self, inner: &TypeInner, index: u32, whole: &[Reg]) -> Result<Vec<Reg>> {
        let base = Base::Registers(0);
        let start = self.offset_of(inner, index, base)? as usize;
        let end = match inner {
            TypeInner::Struct { members, .. } => {
                start as u32 + self.size(&self.module.types[members[index as usize].ty].inner)?
            }
            _ => self.offset_of(inner, index + 1, base)?,
        };
        Ok(whole[start..end as usize].to_vec())
    }

    /// `size` numbers from `place` on.
    pub fn load(&mut self, place: &Place, size: u32) -> Result<Vec<Reg>> {
        let first = self.registers(size);
        for i in 0..size {
            let to = first + i;
            let at = place.offset + i;
            let op = match (place.base, &place.chosen) {
                (Base::Registers(base), None) => Op::Unary { f: UnaryOp::Copy, to, a: base + at },
                (Base::Registers(base), Some(Chosen { index, stride, count })) => {
                    Op::Gather { to, first: base + at, stride: *stride, count: *count, index: *index }
                }
                (Base::Buffer(buffer), None) => Op::Word { to, buffer, word: at },
                (Base::Buffer(buffer), Some(Chosen { index, stride, count })) => {
                    Op::WordAt { to, buffer, word: at, stride: *stride, count: *count, index: *index }
                }
            };
            self.program.ops.push(op);
        }
        Ok((first..first + size).collect())
    }

    /// Stores where `depth` branches and loops are around the statement.
    pub fn store(&mut self, place: &Place, value: Vec<Reg>, depth: u32) -> Result<()> {
        let Base::Registers(base) = place.base else { return unsupported("a store to a buffer") };
        // Outside of all, no lane that is not on its way here will ever look at a local variable again.
        let is_for_all = depth == 0 && place.is_local;
        for (to, a) in (base + place.offset..).zip(value) {
            self.program.ops.push(match place.chosen {
                None if is_for_all => Op::Unary { f: UnaryOp::Copy, to, a },
                None => Op::Store { to, a },
                Some(Chosen { index, stride, count }) => Op::Scatter { first: to, stride, count, index, a },
            });
        }
        Ok(())
    }
}

/// How many parts an index chooses from.
pub fn count_of(inner: &TypeInner) -> Result<u32> {
    Ok(match inner {
        TypeInner::Vector { size, .. } => *size as u32,
        TypeInner::Matrix { columns, .. } => *columns as u32,
        TypeInner::Array { size: naga::ArraySize::Constant(count), .. } => count.get(),
        other => return unsupported(other),
    })
}
