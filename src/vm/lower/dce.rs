//! Dead code elimination: a step whose value nobody reads is removed.

use std::ops::Range;

use super::walk::{each_asked, each_range};
use crate::program::{Node, Op, Reg};

/// Removes steps of the function with these `nodes`, whose steps are the last ones of `ops`. Nothing else
/// reads the registers `own`.
pub fn dce(ops: &mut Vec<Op>, nodes: &mut [Node], own: Range<Reg>) {
    let mut ranges = vec![];
    each_range(nodes, &mut |range| ranges.push(range.clone()));
    let Some(first) = ranges.iter().map(|range| range.start as usize).min() else { return };
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
