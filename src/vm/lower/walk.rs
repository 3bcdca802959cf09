//! What all nodes of a function, nested ones too, have of a kind.

use std::ops::Range;

use crate::program::{Node, Reg};

/// Each row of steps.
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
