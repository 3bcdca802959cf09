//! Functions, each with registers of its own.

use naga::{Block, Handle, Statement};

use super::copy_prop::copy_prop;
use super::dce::dce;
use super::regalloc::regalloc;
use super::{Body, Lowering, Result, SHARED, unsupported};
use crate::program::{Function, Reg};

impl<'m> Lowering<'m> {
    /// All functions, and at last the entry point.
    pub fn functions(&mut self, entry: &str) -> Result<()> {
        let module = self.module;
        // naga keeps them so that each calls only those before it.
        for (handle, function) in module.functions.iter() {
            match is_straight(&function.body) {
                // It is written out where it is called.
                true => {
                    self.ends.push(self.first_free(function));
                    self.program.functions.push(Function::default());
                }
                false => self.function(function, &self.info[handle])?,
            }
        }
        let index = module.entry_points.iter().position(|e| e.name == entry);
        let Some(index) = index else { return unsupported(entry) };
        let function = &module.entry_points[index].function;
        self.function(function, self.info.get_entry_point(index))?;
        self.program.entry = self.program.functions.len() - 1;
        self.program.registers = self.ends.iter().copied().max().unwrap_or(SHARED) as usize;
        let own = &self.program.functions[self.program.entry];
        let arguments: Vec<Reg> = own.arguments.iter().flatten().copied().collect();
        let (Some(pixel), Some(results)) = (arguments.first_chunk(), own.results.first_chunk()) else {
            return unsupported("an entry point without a pixel or a color");
        };
        (self.program.pixel, self.program.result) = (*pixel, *results);
        Ok(())
    }

    /// The first register above those of all that `function` calls.
    fn first_free(&self, function: &naga::Function) -> Reg {
        let mut free = SHARED;
        callees(&function.body, &mut |callee| free = free.max(self.ends[callee.index()]));
        free
    }

    fn function(&mut self, function: &'m naga::Function, info: &'m naga::valid::FunctionInfo) -> Result<()> {
        self.next = self.first_free(function);
        let mut arguments: Vec<Vec<Reg>> = vec![];
        for argument in &function.arguments {
            let size = self.size(self.passed(argument.ty))?;
            let first = self.registers(size);
            arguments.push((first..first + size).collect());
        }
        let size = match &function.result {
            Some(result) => self.size(&self.module.types[result.ty].inner)?,
            None => 0,
        };
        let first = self.registers(size);
        let results: Vec<Reg> = (first..first + size).collect();
        let mut body = self.body(function, info, arguments.clone(), Some(results.clone()))?;
        let mut nodes = vec![];
        self.block(&mut body, &function.body, &mut nodes)?;
        self.flush(&mut nodes);
        let own = first + size..self.next;
        copy_prop(&mut self.program.ops, &mut nodes, own.end);
        dce(&mut self.program.ops, &mut nodes, own.clone());
        self.flushed = self.program.ops.len();
        let end = regalloc(&mut self.program.ops, &mut nodes, own);
        self.program.functions.push(Function { body: nodes, arguments, results });
        self.ends.push(end);
        Ok(())
    }

    /// A function with what its local variables begin with.
    pub fn body(
        &mut self,
        function: &'m naga::Function,
        info: &'m naga::valid::FunctionInfo,
        arguments: Vec<Vec<Reg>>,
        results: Option<Vec<Reg>>,
    ) -> Result<Body<'m>> {
        let values = vec![None; function.expressions.len()];
        let mut body = Body {
            function,
            info,
            arguments,
            images: vec![],
            locals: vec![],
            values,
            results,
            depth: 0,
            returned: vec![],
        };
        for (_, local) in function.local_variables.iter() {
            let size = self.size(&self.module.types[local.ty].inner)?;
            let first = self.registers(size);
            let begin = match local.init {
                Some(init) => self.value(&mut body, init)?,
                None => vec![self.constant(0)?; size as usize],
            };
            (first..).zip(begin).for_each(|(to, a)| self.copy(to, a));
            body.locals.push(first);
        }
        Ok(body)
    }
}

/// Whether a function has one way through it, to a `return` at its end.
pub fn is_straight(block: &Block) -> bool {
    let last = block.len().saturating_sub(1);
    block.iter().enumerate().all(|(i, statement)| match statement {
        Statement::Emit(_) | Statement::Store { .. } | Statement::Call { .. } => true,
        Statement::Return { .. } => i == last,
        _ => false,
    })
}

/// Tells all functions that a block calls.
fn callees(block: &Block, tell: &mut impl FnMut(Handle<naga::Function>)) {
    for statement in block.iter() {
        let inside = match statement {
            Statement::Call { function, .. } => {
                tell(*function);
                vec![]
            }
            Statement::Block(block) => vec![block],
            Statement::If { accept, reject, .. } => vec![accept, reject],
            Statement::Switch { cases, .. } => cases.iter().map(|case| &case.body).collect(),
            Statement::Loop { body, continuing, .. } => vec![body, continuing],
            _ => vec![],
        };
        inside.into_iter().for_each(|block| callees(block, tell));
    }
}
