//! Limits that are found by counting, before anything is built of what is too much.

use std::ops::Range;

use super::Resolver;
use crate::ir::Value;
use crate::ir::points::Point;

/// Uniform data and compile time grow with the objects of a scene that is written out.
pub const MAX_OBJECTS: usize = 4096;
pub const MAX_LIGHTS: usize = 1024;
pub const MAX_TEXTURES: usize = 1024;
pub const MAX_STOPS: usize = 1024;
/// A ray's way through a solid in a solid is a loop in a loop.
pub const DEEPEST_SOLID: usize = 16;

/// How many textures may be evaluated at a point, and for all materials together. Drivers inline all, and
/// take more than linear time: a software driver about 2 minutes for 512 noises.
const MAX_AT_A_POINT: u64 = 512;
const MAX_IN_ALL: u64 = 4096;

/// What the evaluation of textures costs, so far.
#[derive(Default)]
pub struct Cost {
    /// For each of the named textures, in evaluations, what it costs without those that it names.
    textures: Vec<u64>,
    in_all: u64,
    /// Whether something costs too much, and was reported.
    is_reported: bool,
}

impl Resolver<'_> {
    /// Whether `count` things called `what` at `span` are not too many, else an error.
    pub fn allows(&mut self, count: usize, most: usize, what: &str, span: &Range<usize>) -> bool {
        if count > most {
            self.error(
                span,
                format!("{} {what}: at most {} are allowed", grouped(count as u64), grouped(most as u64)),
            );
        }
        count <= most
    }

    /// Reports the named texture that costs most, if that is too much; `span` gives its place.
    pub fn check_textures(&mut self, span: impl Fn(&str) -> Option<Range<usize>>) {
        let costs =
            (0..self.textures.len()).map(|index| (self.evaluations(&[&Value::Texture(index)]), index));
        let Some((cost, index)) = costs.max() else { return };
        if cost > MAX_AT_A_POINT {
            let name = self.textures[index].name.clone();
            self.too_costly(&span(&name).unwrap_or(0..0), &format!("texture \"{name}\""), cost);
        }
    }

    /// Reports `values`, written at `span` and evaluated at one point, where they cost too much.
    pub fn check_evaluations(&mut self, values: &[&Value], span: &Range<usize>) {
        let cost = self.evaluations(values);
        let before = self.cost.in_all;
        self.cost.in_all = before.saturating_add(cost);
        if cost > MAX_AT_A_POINT {
            self.too_costly(span, "this", cost);
        } else if before <= MAX_IN_ALL && self.cost.in_all > MAX_IN_ALL && !self.cost.is_reported {
            let message =
                format!("the scene evaluates more than {} textures, counted up to here", grouped(MAX_IN_ALL));
            let advice = "declare one material for objects that look alike, and use its name".into();
            self.error(span, message).help.push(advice);
        }
    }

    fn evaluations(&mut self, values: &[&Value]) -> u64 {
        let costs = &mut self.cost.textures;
        while costs.len() < self.textures.len() {
            let cost = Point::of([&self.textures[costs.len()].value]).cost(&self.textures, costs);
            costs.push(cost);
        }
        Point::of(values.iter().copied()).evaluations(&self.textures, costs)
    }

    fn too_costly(&mut self, span: &Range<usize>, what: &str, cost: u64) {
        if std::mem::replace(&mut self.cost.is_reported, true) {
            return;
        }
        let least = if cost == u64::MAX { "at least " } else { "" };
        let (cost, most) = (grouped(cost), grouped(MAX_AT_A_POINT));
        let message =
            format!("{what} evaluates {least}{cost} textures at a point: at most {most} are allowed");
        let advice = "a named texture counts once for each point that a mapping moves to";
        self.error(span, message).help.push(advice.into());
    }
}

/// `1,234,567`
fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let groups: Vec<&str> =
        digits.as_bytes().rchunks(3).rev().map(|g| std::str::from_utf8(g).unwrap_or("")).collect();
    groups.join(",")
}
