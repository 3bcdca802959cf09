//! Runs a program: which lanes are on their way, and where they go.

use std::time::Instant;

use super::image::Image;
use super::lanes::{LANES, Lanes, SIDE, and, and_not, any, binary, or, store, ternary, unary};
use super::program::{Buffer, Case, Node, Op, Program, Reg};

const ALL: Lanes = [u32::MAX; LANES];
const NONE: Lanes = [0; LANES];

/// What a program reads besides its registers, as words.
#[derive(Clone, Copy)]
pub struct Inputs<'a> {
    pub frame: &'a [u32],
    pub numbers: &'a [u32],
    pub images: &'a [Image<'a>],
    /// When to give up.
    pub until: Instant,
}

/// The time was up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OutOfTime;

pub struct Machine<'a> {
    program: &'a Program,
    inputs: Inputs<'a>,
    registers: Vec<Lanes>,
    #[cfg(target_arch = "x86_64")]
    has_avx2: bool,
    /// The lanes that are on their way.
    mask: Lanes,
    /// Those that end without a color.
    killed: Lanes,
    /// Where `break` and `continue` lead, the innermost last.
    targets: Vec<Target>,
}

struct Target {
    is_loop: bool,
    broken: Lanes,
    continued: Lanes,
}

impl<'a> Machine<'a> {
    pub fn new(program: &'a Program, inputs: Inputs<'a>) -> Self {
        let mut registers = vec![NONE; program.registers];
        for (register, value) in &program.constants {
            registers[*register as usize] = [*value; LANES];
        }
        Self {
            program,
            inputs,
            registers,
            #[cfg(target_arch = "x86_64")]
            has_avx2: is_x86_feature_detected!("avx2"),
            mask: NONE,
            killed: NONE,
            targets: vec![],
        }
    }

    /// Red, green, blue and depth of the pixels right of and below `corner`, row by row.
    pub fn square(&mut self, corner: [u32; 2]) -> Result<[[f32; 4]; LANES], OutOfTime> {
        self.mask = ALL;
        self.killed = NONE;
        self.targets.clear();
        for (variable, begin) in &self.program.variables {
            self.registers[*variable as usize] = self.registers[*begin as usize];
        }
        let [x, y] = self.program.pixel;
        for i in 0..LANES {
            let center = [corner[0] + (i % SIDE) as u32, corner[1] + (i / SIDE) as u32];
            self.registers[x as usize][i] = (center[0] as f32 + 0.5).to_bits();
            self.registers[y as usize][i] = (center[1] as f32 + 0.5).to_bits();
        }
        self.call(self.program.entry)?;
        let channels = self.program.result.map(|r| &self.registers[r as usize]);
        Ok(std::array::from_fn(|i| channels.map(|lanes| f32::from_bits(lanes[i]))))
    }

    fn call(&mut self, function: usize) -> Result<(), OutOfTime> {
        let before = self.mask;
        let program = self.program;
        self.run(&program.functions[function].body)?;
        self.mask = and_not(&before, &self.killed);
        Ok(())
    }

    /// Afterwards the mask has the lanes that come out at the end.
    fn run(&mut self, nodes: &'a [Node]) -> Result<(), OutOfTime> {
        for node in nodes {
            if !any(&self.mask) {
                return Ok(());
            }
            match node {
                Node::Ops(range) => {
                    self.steps(&self.program.ops[range.start as usize..range.end as usize]);
                }
                Node::If { condition, accept, reject } => {
                    let whole = self.mask;
                    let condition = self.registers[*condition as usize];
                    self.mask = and(&whole, &condition);
                    self.run(accept)?;
                    let accepted = self.mask;
                    self.mask = and_not(&whole, &condition);
                    self.run(reject)?;
                    self.mask = or(&self.mask, &accepted);
                }
                Node::Switch { selector, cases } => self.switch(*selector, cases)?,
                Node::Loop { body, continuing, break_if } => self.repeat(body, continuing, *break_if)?,
                Node::Break => {
                    let target = self.targets.last_mut().expect("naga lets none break out of nothing");
                    target.broken = or(&target.broken, &self.mask);
                    self.mask = NONE;
                }
                Node::Continue => {
                    let target = self.targets.iter_mut().rev().find(|target| target.is_loop);
                    let target = target.expect("naga lets none continue outside of a loop");
                    target.continued = or(&target.continued, &self.mask);
                    self.mask = NONE;
                }
                Node::Return => self.mask = NONE,
                Node::Kill => {
                    self.killed = or(&self.killed, &self.mask);
                    self.mask = NONE;
                }
                Node::Call(function) => self.call(*function)?,
            }
        }
        Ok(())
    }

    fn switch(&mut self, selector: Reg, cases: &'a [Case]) -> Result<(), OutOfTime> {
        let whole = self.mask;
        let selector = self.registers[selector as usize];
        let is = |value: u32| -> Lanes {
            std::array::from_fn(|i| 0u32.wrapping_sub((selector[i] == value) as u32))
        };
        let named = cases.iter().filter_map(|case| case.value).fold(NONE, |all, value| or(&all, &is(value)));
        self.targets.push(Target { is_loop: false, broken: NONE, continued: NONE });
        let (mut out, mut falling) = (NONE, NONE);
        for case in cases {
            let chosen = match case.value {
                Some(value) => and(&whole, &is(value)),
                None => and_not(&whole, &named),
            };
            self.mask = or(&chosen, &falling);
            self.run(&case.body)?;
            falling = NONE;
            match case.falls_through {
                true => falling = self.mask,
                false => out = or(&out, &self.mask),
            }
        }
        let target = self.targets.pop().expect("it was just pushed");
        self.mask = or(&out, &target.broken);
        Ok(())
    }

    fn repeat(
        &mut self,
        body: &'a [Node],
        continuing: &'a [Node],
        break_if: Option<Reg>,
    ) -> Result<(), OutOfTime> {
        self.targets.push(Target { is_loop: true, broken: NONE, continued: NONE });
        while any(&self.mask) {
            if Instant::now() > self.inputs.until {
                return Err(OutOfTime);
            }
            self.run(body)?;
            let target = self.targets.last_mut().expect("each loop pops its own");
            self.mask = or(&self.mask, &std::mem::replace(&mut target.continued, NONE));
            self.run(continuing)?;
            if let Some(condition) = break_if {
                let ends = and(&self.mask, &self.registers[condition as usize]);
                let target = self.targets.last_mut().expect("each loop pops its own");
                target.broken = or(&target.broken, &ends);
                self.mask = and_not(&self.mask, &ends);
            }
        }
        self.mask = self.targets.pop().expect("it was just pushed").broken;
        Ok(())
    }

    fn steps(&mut self, ops: &[Op]) {
        #[cfg(target_arch = "x86_64")]
        if self.has_avx2 {
            // SAFETY: the processor has been asked.
            return unsafe { self.wide_steps(ops) };
        }
        ops.iter().for_each(|op| self.step(op));
    }

    /// The same with vectors of eight, which programs do not use unasked.
    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    fn wide_steps(&mut self, ops: &[Op]) {
        for op in ops {
            self.step(op);
        }
    }

    #[inline(always)]
    fn step(&mut self, op: &Op) {
        let registers = &mut self.registers;
        let buffer = |buffer| match buffer {
            Buffer::Frame => self.inputs.frame,
            Buffer::Numbers => self.inputs.numbers,
            Buffer::Corner => &[0; 2],
        };
        match *op {
            Op::Unary { f, to, a } => registers[to as usize] = unary(f, &registers[a as usize]),
            Op::Binary { f, to, a, b } => {
                registers[to as usize] = binary(f, &registers[a as usize], &registers[b as usize]);
            }
            Op::Ternary { f, to, a, b, c } => {
                let [a, b, c] = [a, b, c].map(|r| &registers[r as usize]);
                registers[to as usize] = ternary(f, a, b, c);
            }
            Op::Store { to, a } => {
                let new = registers[a as usize];
                store(&self.mask, &new, &mut registers[to as usize]);
            }
            Op::Gather { to, first, stride, count, index } => {
                let index = registers[index as usize];
                let from = |i: usize| (first + stride * index[i].min(count - 1)) as usize;
                let out = std::array::from_fn(|i| registers[from(i)][i]);
                registers[to as usize] = out;
            }
            Op::Scatter { first, stride, count, index, a } => {
                let (index, new) = (registers[index as usize], registers[a as usize]);
                for i in (0..LANES).filter(|i| self.mask[*i] != 0) {
                    registers[(first + stride * index[i].min(count - 1)) as usize][i] = new[i];
                }
            }
            Op::Word { to, buffer: of, word } => {
                registers[to as usize] = [buffer(of).get(word as usize).copied().unwrap_or(0); LANES];
            }
            Op::WordAt { to, buffer: of, word, stride, count, index } => {
                let index = registers[index as usize];
                let words = buffer(of);
                let at = |i: usize| (word + stride * index[i].min(count - 1)) as usize;
                registers[to as usize] = std::array::from_fn(|i| words.get(at(i)).copied().unwrap_or(0));
            }
            Op::Texel { to, image, x, y } => {
                let (x, y) = (registers[x as usize], registers[y as usize]);
                let image = &self.inputs.images[image as usize];
                for i in 0..LANES {
                    let texel = image.texel([x[i], y[i]]);
                    (0..4).for_each(|c| registers[to as usize + c][i] = texel[c]);
                }
            }
            Op::Sample { to, image, u, v, level } => {
                let [u, v, level] = [u, v, level].map(|r| registers[r as usize].map(f32::from_bits));
                let image = &self.inputs.images[image as usize];
                for i in (0..LANES).filter(|i| self.mask[*i] != 0) {
                    let color = image.color([u[i], v[i]], level[i]);
                    (0..4).for_each(|c| registers[to as usize + c][i] = color[c].to_bits());
                }
            }
            Op::Size { to, image } => {
                let size = self.inputs.images[image as usize].size();
                (0..2).for_each(|c| registers[to as usize + c] = [size[c]; LANES]);
            }
        }
    }
}
