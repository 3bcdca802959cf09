//! Fewer steps for the same values: who reads a copy may read the original, and what nobody reads need not be
//! there.

use std::ops::Range;

use super::table::Table;
use crate::sketch::lanes::One;
use crate::sketch::program::{Node, Op, Reg};

/// Simplifies the function with these `nodes`, whose steps are the last ones of `ops`. Nothing else looks at
/// the registers `own`.
pub fn simplify(ops: &mut Vec<Op>, nodes: &mut [Node], own: Range<Reg>) {
    let mut ranges = vec![];
    each_range(nodes, &mut |range| ranges.push(range.clone()));
    let Some(first) = ranges.iter().map(|range| range.start as usize).min() else { return };
    let mut originals = Originals { of: Table::new(own.end), all: vec![] };
    for range in ranges {
        originals.read(&mut ops[range.start as usize..range.end as usize]);
    }
    let mut asked = vec![false; own.len()];
    each_asked(nodes, &mut |register| mark(&mut asked, &own, *register..*register + 1));
    let kept = needed(&ops[first..], &own, asked);
    let mut new_place = vec![first as u32];
    kept.iter().for_each(|keep| new_place.push(new_place[new_place.len() - 1] + u32::from(*keep)));
    each_range(nodes, &mut |range| {
        *range = new_place[range.start as usize - first]..new_place[range.end as usize - first];
    });
    let mut kept = kept.into_iter();
    let mut at = 0;
    ops.retain(|_| {
        at += 1;
        at <= first || kept.next().unwrap_or(true)
    });
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
            if let Op::One { f: One::Copy, to, a } = *op {
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

/// Which steps write what another step reads that is needed itself, or `asked` for.
fn needed(ops: &[Op], own: &Range<Reg>, mut asked: Vec<bool>) -> Vec<bool> {
    let mut kept = vec![false; ops.len()];
    // Loops lead back, so one round may find more than the one before.
    loop {
        let mut found = false;
        for (i, op) in ops.iter().enumerate().rev().filter(|(i, _)| !kept[*i]).collect::<Vec<_>>() {
            let written = op.writes();
            let is_asked = |register: Reg| !own.contains(&register) || asked[(register - own.start) as usize];
            if written.into_iter().any(is_asked) {
                kept[i] = true;
                found = true;
                op.reads(|read| mark(&mut asked, own, read));
            }
        }
        if !found {
            return kept;
        }
    }
}

fn mark(asked: &mut [bool], own: &Range<Reg>, registers: Range<Reg>) {
    for register in registers.filter(|register| own.contains(register)) {
        asked[(register - own.start) as usize] = true;
    }
}

pub fn each_range(nodes: &mut [Node], tell: &mut impl FnMut(&mut Range<u32>)) {
    for node in nodes {
        match node {
            Node::Ops(range) => tell(range),
            Node::If { accept, reject, .. } => {
                each_range(accept, tell);
                each_range(reject, tell);
            }
            Node::Switch { cases, .. } => cases.iter_mut().for_each(|case| each_range(&mut case.body, tell)),
            Node::Loop { body, continuing, .. } => {
                each_range(body, tell);
                each_range(continuing, tell);
            }
            _ => {}
        }
    }
}

/// The registers by which control flows.
pub fn each_asked(nodes: &mut [Node], tell: &mut impl FnMut(&mut Reg)) {
    for node in nodes {
        match node {
            Node::If { condition, accept, reject } => {
                tell(condition);
                each_asked(accept, tell);
                each_asked(reject, tell);
            }
            Node::Switch { selector, cases } => {
                tell(selector);
                cases.iter_mut().for_each(|case| each_asked(&mut case.body, tell));
            }
            Node::Loop { body, continuing, break_if } => {
                break_if.iter_mut().for_each(&mut *tell);
                each_asked(body, tell);
                each_asked(continuing, tell);
            }
            _ => {}
        }
    }
}
