//! What a module becomes: steps for many pixels at a time, each value in a register with one lane for each.

use std::ops::Range;

use super::op::{BinaryOp, TernaryOp, UnaryOp};

/// The number of a register.
pub type Reg = u32;

/// A module's entry point, ready to run.
#[derive(Debug, Default)]
pub struct Program {
    pub ops: Vec<Op>,
    pub functions: Vec<Function>,
    /// Registers that never change, with what they hold.
    pub constants: Vec<(Reg, u32)>,
    /// Registers of the variables that each pixel has for itself, with those that they begin as.
    pub variables: Vec<(Reg, Reg)>,
    pub registers: usize,
    /// Where the entry point expects x and y of its pixel.
    pub pixel: [Reg; 2],
    /// Its function, and where that leaves red, green, blue and depth.
    pub entry: usize,
    pub result: [Reg; 4],
}

/// A function whose arguments and results have registers of their own: nothing calls itself in WGSL.
#[derive(Debug, Default)]
pub struct Function {
    pub body: Vec<Node>,
    pub arguments: Vec<Vec<Reg>>,
    pub results: Vec<Reg>,
}

/// A step in the flow of control. Each lane takes its own way; what is left of them is a mask.
#[derive(Debug)]
pub enum Node {
    /// A range of [`Program::ops`].
    Ops(Range<u32>),
    If {
        condition: Reg,
        accept: Vec<Node>,
        reject: Vec<Node>,
    },
    Switch {
        selector: Reg,
        cases: Vec<Case>,
    },
    Loop {
        body: Vec<Node>,
        continuing: Vec<Node>,
        break_if: Option<Reg>,
    },
    Break,
    Continue,
    Return,
    Kill,
    Call(usize),
}

#[derive(Debug)]
pub struct Case {
    /// None for the default.
    pub value: Option<u32>,
    pub body: Vec<Node>,
    /// Whether the next case's body follows.
    pub falls_through: bool,
}

/// A step that all lanes take; `to` is written, the others are read.
#[derive(Clone, Copy, Debug)]
pub enum Op {
    Unary {
        f: UnaryOp,
        to: Reg,
        a: Reg,
    },
    Binary {
        f: BinaryOp,
        to: Reg,
        a: Reg,
        b: Reg,
    },
    Ternary {
        f: TernaryOp,
        to: Reg,
        a: Reg,
        b: Reg,
        c: Reg,
    },
    /// Only in the lanes that are on their way.
    Store {
        to: Reg,
        a: Reg,
    },
    /// `first + stride * index`, where index ends at `count`.
    Gather {
        to: Reg,
        first: Reg,
        stride: u32,
        count: u32,
        index: Reg,
    },
    /// The same, written.
    Scatter {
        first: Reg,
        stride: u32,
        count: u32,
        index: Reg,
        a: Reg,
    },
    /// A word of a uniform buffer.
    Word {
        to: Reg,
        buffer: Buffer,
        word: u32,
    },
    /// The same, at `word + stride * index`.
    WordAt {
        to: Reg,
        buffer: Buffer,
        word: u32,
        stride: u32,
        count: u32,
        index: Reg,
    },
    /// A texel, to four registers from `to`.
    Texel {
        to: Reg,
        image: u32,
        x: Reg,
        y: Reg,
    },
    /// A filtered color, to four registers from `to`.
    Sample {
        to: Reg,
        image: u32,
        u: Reg,
        v: Reg,
        level: Reg,
    },
    /// Width and height, to two registers from `to`.
    Size {
        to: Reg,
        image: u32,
    },
}

impl Op {
    /// The registers that get a value.
    pub fn writes(&self) -> Range<Reg> {
        match *self {
            Op::Unary { to, .. }
            | Op::Binary { to, .. }
            | Op::Ternary { to, .. }
            | Op::Store { to, .. }
            | Op::Gather { to, .. }
            | Op::Word { to, .. }
            | Op::WordAt { to, .. } => to..to + 1,
            Op::Scatter { first, stride, count, .. } => first..first + stride * (count - 1) + 1,
            Op::Texel { to, .. } | Op::Sample { to, .. } => to..to + 4,
            Op::Size { to, .. } => to..to + 2,
        }
    }

    /// Tells all registers that it reads, but for those that it writes in some lanes only.
    pub fn reads(&self, mut tell: impl FnMut(Range<Reg>)) {
        if let Op::Gather { first, stride, count, .. } = *self {
            tell(first..first + stride * (count - 1) + 1);
        }
        self.clone().reads_mut(|register| tell(*register..*register + 1));
    }

    /// The registers that must lie in a row.
    pub fn contiguous(&self) -> Option<Range<Reg>> {
        match *self {
            Op::Gather { first, stride, count, .. } => Some(first..first + stride * (count - 1) + 1),
            Op::Scatter { .. } | Op::Texel { .. } | Op::Sample { .. } | Op::Size { .. } => {
                Some(self.writes())
            }
            _ => None,
        }
    }

    /// The register that it writes in all lanes, where that is one.
    pub fn full_write(&self) -> Option<Reg> {
        match self {
            Op::Store { .. } | Op::Scatter { .. } => None,
            _ => Some(self.writes()).filter(|all| all.len() == 1).map(|all| all.start),
        }
    }

    /// All that it names: what is read first.
    pub fn each_register(&mut self, mut tell: impl FnMut(&mut Reg)) {
        self.reads_mut(&mut tell);
        match self {
            Op::Unary { to, .. }
            | Op::Binary { to, .. }
            | Op::Ternary { to, .. }
            | Op::Store { to, .. }
            | Op::Word { to, .. }
            | Op::WordAt { to, .. }
            | Op::Texel { to, .. }
            | Op::Sample { to, .. }
            | Op::Size { to, .. }
            | Op::Scatter { first: to, .. } => tell(to),
            Op::Gather { to, first, .. } => [first, to].into_iter().for_each(tell),
        }
    }

    /// Those that might as well be others.
    pub fn reads_mut(&mut self, mut tell: impl FnMut(&mut Reg)) {
        match self {
            Op::Unary { a, .. } | Op::Store { a, .. } => tell(a),
            Op::Binary { a, b, .. } => [a, b].into_iter().for_each(tell),
            Op::Ternary { a, b, c, .. } => [a, b, c].into_iter().for_each(tell),
            Op::Gather { index, .. } | Op::WordAt { index, .. } => tell(index),
            Op::Scatter { index, a, .. } => [index, a].into_iter().for_each(tell),
            Op::Texel { x, y, .. } => [x, y].into_iter().for_each(tell),
            Op::Sample { u, v, level, .. } => [u, v, level].into_iter().for_each(tell),
            Op::Word { .. } | Op::Size { .. } => {}
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Buffer {
    Frame,
    Numbers,
    /// Where in the picture the part lies that is drawn: a sketch is drawn whole.
    Corner,
}
