//! From naga's module to a program: every value a register of its own for each of its numbers.
//!
//! A function's registers lie above those of all that it calls, so functions that never run at the same time
//! share theirs. Functions without branches are written out where they are called.

mod calls;
mod copy_prop;
mod dce;
mod expressions;
mod functions;
mod math;
mod operators;
mod places;
mod regalloc;
mod statements;
mod table;
mod walk;

use std::collections::HashMap;

use naga::{Expression, Handle, TypeInner};

use super::op::{BinaryOp, TernaryOp, UnaryOp};
use super::program::{Op, Program, Reg};

/// What a module has that a program cannot do, as naga has it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unsupported(String);

impl Unsupported {
    pub fn of(what: impl std::fmt::Debug) -> Self {
        Self(format!("{what:?}"))
    }
}

impl std::fmt::Display for Unsupported {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "only a driver can draw it: {}", self.0)
    }
}

impl std::error::Error for Unsupported {}

pub type Result<T> = std::result::Result<T, Unsupported>;

pub fn unsupported<T>(what: impl std::fmt::Debug) -> Result<T> {
    Err(Unsupported::of(what))
}

/// Registers for private variables and constants, below those of all functions.
const SHARED: Reg = 1 << 14;

/// The program of the fragment shader `entry`.
///
/// # Errors
/// Where the module has something that programs do not do: none of raytoy's own files has.
pub fn lower(module: &naga::Module, info: &naga::valid::ModuleInfo, entry: &str) -> Result<Program> {
    let mut lowering = Lowering {
        module,
        info,
        program: Program::default(),
        constants: HashMap::new(),
        globals: HashMap::new(),
        flushed: 0,
        next: 0,
        ends: vec![],
    };
    for (handle, variable) in module.global_variables.iter() {
        let is_lane =
            matches!(variable.space, naga::AddressSpace::Private | naga::AddressSpace::Storage { .. });
        if is_lane {
            let size = lowering.size(&module.types[variable.ty].inner)?;
            let first = lowering.registers(size);
            lowering.globals.insert(handle, first);
            let begin = match variable.init {
                Some(init) => lowering.constant_value(init)?,
                None => vec![lowering.constant(0)?; size as usize],
            };
            lowering.program.variables.extend((first..).zip(begin));
        }
    }
    if lowering.next > SHARED / 2 {
        return unsupported("so many private variables");
    }
    lowering.functions(entry)?;
    let mut program = lowering.program;
    program.constants = lowering.constants.into_iter().map(|(value, register)| (register, value)).collect();
    Ok(program)
}

struct Lowering<'m> {
    module: &'m naga::Module,
    info: &'m naga::valid::ModuleInfo,
    program: Program,
    constants: HashMap<u32, Reg>,
    /// The first registers of variables that every pixel has for itself.
    globals: HashMap<Handle<naga::GlobalVariable>, Reg>,
    /// Operations before this one have their node.
    flushed: usize,
    /// The next free register.
    next: Reg,
    /// Of each function so far, where its registers end.
    ends: Vec<Reg>,
}

/// A function as it is being lowered.
struct Body<'m> {
    function: &'m naga::Function,
    info: &'m naga::valid::FunctionInfo,
    arguments: Vec<Vec<Reg>>,
    /// The bindings of those that are images.
    images: Vec<Option<u32>>,
    /// The first register of each local variable.
    locals: Vec<Reg>,
    /// The registers of what has been evaluated.
    values: Vec<Option<Vec<Reg>>>,
    /// Where the result goes; none in a function that is written out.
    results: Option<Vec<Reg>>,
    /// How many branches and loops are around the statement.
    depth: u32,
    /// What a function that is written out returns.
    returned: Vec<Reg>,
}

impl<'m> Body<'m> {
    fn inner<'a>(&'a self, module: &'a naga::Module, expression: Handle<Expression>) -> &'a TypeInner {
        self.info[expression].ty.inner_with(&module.types)
    }
}

impl Lowering<'_> {
    /// So many new registers; the first of them.
    fn registers(&mut self, count: u32) -> Reg {
        self.next += count;
        self.next - count
    }

    fn constant(&mut self, value: u32) -> Result<Reg> {
        if let Some(register) = self.constants.get(&value) {
            return Ok(*register);
        }
        let used: u32 = self.constants.len() as u32;
        // From the top, where no variable is.
        let register = SHARED - 1 - used;
        if used > SHARED / 2 {
            return unsupported("so many constants");
        }
        self.constants.insert(value, register);
        Ok(register)
    }

    fn float(&mut self, value: f32) -> Result<Reg> {
        self.constant(value.to_bits())
    }

    fn emit_unary(&mut self, f: UnaryOp, a: Reg) -> Reg {
        let to = self.registers(1);
        self.program.ops.push(Op::Unary { f, to, a });
        to
    }

    fn emit_binary(&mut self, f: BinaryOp, a: Reg, b: Reg) -> Reg {
        let to = self.registers(1);
        self.program.ops.push(Op::Binary { f, to, a, b });
        to
    }

    fn emit_ternary(&mut self, f: TernaryOp, a: Reg, b: Reg, c: Reg) -> Reg {
        let to = self.registers(1);
        self.program.ops.push(Op::Ternary { f, to, a, b, c });
        to
    }

    fn copy(&mut self, to: Reg, a: Reg) {
        self.program.ops.push(Op::Unary { f: UnaryOp::Copy, to, a });
    }

    /// How many registers a value of the type has.
    fn size(&self, inner: &TypeInner) -> Result<u32> {
        let of = |ty: &Handle<naga::Type>| self.size(&self.module.types[*ty].inner);
        Ok(match inner {
            TypeInner::Scalar(_) | TypeInner::Atomic(_) => 1,
            TypeInner::Vector { size, .. } => *size as u32,
            TypeInner::Matrix { columns, rows, .. } => *columns as u32 * *rows as u32,
            TypeInner::Array { base, size: naga::ArraySize::Constant(count), .. } => count.get() * of(base)?,
            TypeInner::Struct { members, .. } => {
                members.iter().map(|member| of(&member.ty)).sum::<Result<u32>>()?
            }
            // They are known beforehand.
            TypeInner::Image { .. } | TypeInner::Sampler { .. } => 0,
            other => return unsupported(other),
        })
    }
}
