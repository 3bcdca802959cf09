//! Copy propagation: who reads a copy reads the original instead.

use super::table::Table;
use super::walk::each_range;
use crate::op::UnaryOp;
use crate::program::{Node, Op, Reg};

/// Reads originals in the function with these `nodes`, whose registers end at `end`.
pub fn copy_prop(ops: &mut [Op], nodes: &mut [Node], end: Reg) {
    let mut originals = Originals { of: Table::new(end), all: vec![] };
    each_range(nodes, &mut |range| originals.read(&mut ops[range.start as usize..range.end as usize]));
}

/// Which registers hold a copy of another one.
struct Originals {
    of: Table,
    /// Registers that have been copied.
    all: Vec<Reg>,
}

impl Originals {
    /// Reads originals instead of copies, within a row of steps that all are taken.
    fn read(&mut self, ops: &mut [Op]) {
        for op in ops {
            op.reads_mut(|register| *register = self.of.get(*register).unwrap_or(*register));
            for written in op.writes() {
                self.of.remove(written);
                if self.all.contains(&written) {
                    self.of.forget(written);
                    self.all.retain(|original| *original != written);
                }
            }
            if let Op::Unary { f: UnaryOp::Copy, to, a } = *op {
                self.of.insert(to, a);
                if !self.all.contains(&a) {
                    self.all.push(a);
                }
            }
        }
        self.of.clear();
        self.all.clear();
    }
}
