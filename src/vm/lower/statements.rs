//! Statements: what flows where.

use naga::{AtomicFunction, Block, Statement, SwitchValue};

use super::{Body, Lowering, Result, unsupported};
use crate::op::BinaryOp;
use crate::program::{Case, Node, Op};

impl<'m> Lowering<'m> {
    fn nodes(&mut self, body: &mut Body<'m>, block: &'m Block) -> Result<Vec<Node>> {
        let mut nodes = vec![];
        body.depth += 1;
        self.block(body, block, &mut nodes)?;
        body.depth -= 1;
        self.flush(&mut nodes);
        Ok(nodes)
    }

    /// The operations since the last node become one.
    pub fn flush(&mut self, nodes: &mut Vec<Node>) {
        let end = self.program.ops.len();
        if end > self.flushed {
            nodes.push(Node::Ops(self.flushed as u32..end as u32));
            self.flushed = end;
        }
    }

    pub fn block(&mut self, body: &mut Body<'m>, block: &'m Block, nodes: &mut Vec<Node>) -> Result<()> {
        for statement in block.iter() {
            self.statement(body, statement, nodes)?;
        }
        Ok(())
    }

    fn statement(
        &mut self,
        body: &mut Body<'m>,
        statement: &'m Statement,
        nodes: &mut Vec<Node>,
    ) -> Result<()> {
        match statement {
            Statement::Emit(range) => {
                for expression in range.clone() {
                    self.evaluate(body, expression)?;
                }
            }
            Statement::Block(block) => self.block(body, block, nodes)?,
            Statement::If { condition, accept, reject } => {
                let condition = self.scalar(body, *condition)?;
                self.flush(nodes);
                let accept = self.nodes(body, accept)?;
                let reject = self.nodes(body, reject)?;
                nodes.push(Node::If { condition, accept, reject });
            }
            Statement::Switch { selector, cases } => {
                let selector = self.scalar(body, *selector)?;
                self.flush(nodes);
                let mut lowered = vec![];
                for case in cases {
                    let value = match case.value {
                        SwitchValue::I32(value) => Some(value as u32),
                        SwitchValue::U32(value) => Some(value),
                        SwitchValue::Default => None,
                    };
                    let nodes = self.nodes(body, &case.body)?;
                    lowered.push(Case { value, body: nodes, falls_through: case.fall_through });
                }
                nodes.push(Node::Switch { selector, cases: lowered });
            }
            Statement::Loop { body: block, continuing, break_if } => {
                self.flush(nodes);
                let inside = self.nodes(body, block)?;
                let mut after = vec![];
                body.depth += 1;
                self.block(body, continuing, &mut after)?;
                body.depth -= 1;
                let break_if = break_if.map(|condition| self.scalar(body, condition)).transpose()?;
                self.flush(&mut after);
                nodes.push(Node::Loop { body: inside, continuing: after, break_if });
            }
            Statement::Break => self.leave(nodes, Node::Break),
            Statement::Continue => self.leave(nodes, Node::Continue),
            Statement::Kill => self.leave(nodes, Node::Kill),
            Statement::Return { value } => {
                let value = value.map(|value| self.value(body, value)).transpose()?.unwrap_or_default();
                match &body.results {
                    None => body.returned = value,
                    Some(results) => {
                        let stores = results.iter().zip(value).map(|(to, a)| Op::Store { to: *to, a });
                        self.program.ops.extend(stores);
                        self.leave(nodes, Node::Return);
                    }
                }
            }
            Statement::Store { pointer, value } => {
                let value = self.value(body, *value)?;
                let place = self.place(body, *pointer)?;
                self.store(&place, value, body.depth)?;
            }
            Statement::Atomic { pointer, fun: AtomicFunction::Max, value, result } => {
                let place = self.place(body, *pointer)?;
                let (before, value) = (self.load(&place, 1)?, self.scalar(body, *value)?);
                let most = self.emit_binary(BinaryOp::UintMax, before[0], value);
                self.store(&place, vec![most], body.depth)?;
                if let Some(result) = result {
                    body.values[result.index()] = Some(before);
                }
            }
            Statement::Call { function, arguments, result } => {
                let returned = self.call(body, *function, arguments, nodes)?;
                if let Some(result) = result {
                    body.values[result.index()] = Some(returned);
                }
            }
            other => return unsupported(other),
        }
        Ok(())
    }

    pub fn leave(&mut self, nodes: &mut Vec<Node>, node: Node) {
        self.flush(nodes);
        nodes.push(node);
    }
}
