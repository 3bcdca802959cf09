//! Calls: what goes into a function, and what comes back.

use naga::{Expression, Function, Handle, Type, TypeInner};

use super::functions::is_straight;
use super::{Body, Lowering, Result};
use crate::op::UnaryOp;
use crate::program::{Node, Reg};

impl<'m> Lowering<'m> {
    /// What `function` returns where `body` calls it.
    pub fn call(
        &mut self,
        body: &mut Body<'m>,
        function: Handle<Function>,
        arguments: &[Handle<Expression>],
        nodes: &mut Vec<Node>,
    ) -> Result<Vec<Reg>> {
        let called = &self.module.functions[function];
        let (mut given, mut places, mut images) = (vec![], vec![], vec![]);
        for (argument, parameter) in arguments.iter().zip(&called.arguments) {
            let inner = &self.module.types[parameter.ty].inner;
            let is_image = matches!(inner, TypeInner::Image { .. });
            images.push(is_image.then(|| self.image(body, *argument)).transpose()?);
            given.push(match inner {
                TypeInner::Pointer { .. } => {
                    let place = self.place(body, *argument)?;
                    let size = self.size(self.passed(parameter.ty))?;
                    let there = self.load(&place, size)?;
                    places.push((given.len(), place));
                    there
                }
                TypeInner::Image { .. } | TypeInner::Sampler { .. } => vec![],
                _ => self.value(body, *argument)?,
            });
        }
        let (returned, left) = if is_straight(&called.body) {
            let mut inside = self.body(called, &self.info[function], given, None)?;
            inside.images = images;
            self.block(&mut inside, &called.body, nodes)?;
            (inside.returned, inside.arguments)
        } else {
            let own = &self.program.functions[function.index()];
            let (parameters, results) = (own.arguments.clone(), own.results.clone());
            let both = parameters.iter().flatten().zip(given.into_iter().flatten());
            both.for_each(|(to, a)| self.copy(*to, a));
            self.leave(nodes, Node::Call(function.index()));
            // The next call of the function leaves its own there.
            (results.into_iter().map(|a| self.emit_unary(UnaryOp::Copy, a)).collect(), parameters)
        };
        for (argument, place) in places {
            self.store(&place, left[argument].clone(), body.depth)?;
        }
        Ok(returned)
    }

    /// What is passed for an argument: what a pointer points to goes there and back.
    pub fn passed(&self, ty: Handle<Type>) -> &TypeInner {
        match &self.module.types[ty].inner {
            TypeInner::Pointer { base, .. } => &self.module.types[*base].inner,
            other => other,
        }
    }
}
