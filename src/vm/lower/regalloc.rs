//! Register allocation: few registers for many values, so that those in use stay in the nearest cache.

use std::ops::Range;

use super::table::Table;
use super::walk::{each_asked, each_range};
use crate::program::{Node, Op, Reg};

/// Renames the registers `own` of the function with these `nodes`, whose steps are the last ones of `ops`;
/// where they end now. One that is only used within a row of steps is free again after that.
pub fn regalloc(ops: &mut [Op], nodes: &mut [Node], own: Range<Reg>) -> Reg {
    let mut rows = vec![];
    each_range(nodes, &mut |range| rows.push(range.start as usize..range.end as usize));
    let lasting = lasting(ops, nodes, &rows, &own);
    let mut names = Table::new(own.end);
    let mut end = own.start;
    for register in own.clone().filter(|register| lasting[(register - own.start) as usize]) {
        names.insert(register, end);
        end += 1;
    }
    let name = |register: &mut Reg| *register = names.get(*register).unwrap_or(*register);
    each_asked(nodes, &mut |register| name(register));
    let first_free = end;
    let (mut last_use, mut brief) = (Table::new(own.end), Table::new(own.end));
    for row in rows {
        let ops = &mut ops[row];
        for (i, op) in (0..).zip(ops.iter_mut()) {
            op.each_register(|register| last_use.insert(*register, i));
        }
        let (mut free, mut next) = (vec![], first_free);
        for (i, op) in (0..).zip(ops.iter_mut()) {
            let mut done = vec![];
            op.each_register(|register| {
                let before = *register;
                if !own.contains(&before) || lasting[(before - own.start) as usize] {
                    return name(register);
                }
                *register = brief.get(before).unwrap_or_else(|| {
                    let new = free.pop().unwrap_or_else(|| {
                        next += 1;
                        next - 1
                    });
                    brief.insert(before, new);
                    new
                });
                if last_use.get(before) == Some(i) && !done.contains(register) {
                    done.push(*register);
                }
            });
            free.extend(done);
        }
        last_use.clear();
        brief.clear();
        end = end.max(next);
    }
    end
}

/// Which registers keep a value from one row of steps to another, or lie in a row that an index chooses from.
fn lasting(ops: &[Op], nodes: &mut [Node], rows: &[Range<usize>], own: &Range<Reg>) -> Vec<bool> {
    let mut lasting = vec![false; own.len()];
    let mut row_of: Vec<Option<usize>> = vec![None; own.len()];
    let mut last = |register: Reg| {
        if own.contains(&register) {
            lasting[(register - own.start) as usize] = true;
        }
    };
    each_asked(nodes, &mut |register| last(*register));
    for (number, row) in rows.iter().enumerate() {
        for op in &ops[row.clone()] {
            let mut op = *op;
            if let Some(several) = op.contiguous() {
                several.for_each(&mut last);
            }
            let whole = op.full_write();
            // What is read, or written in some lanes only, has to be there already.
            op.each_register(|register| {
                if !own.contains(register) {
                    return;
                }
                let place = &mut row_of[(*register - own.start) as usize];
                match place {
                    Some(row) if *row == number => {}
                    None if whole == Some(*register) => *place = Some(number),
                    _ => last(*register),
                }
            });
        }
    }
    lasting
}
