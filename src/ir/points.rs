//! What is evaluated at one point, and what at points that a mapping makes of it.
//!
//! In: values. Out: their [`Point`], and how many evaluations they cost if each named texture is evaluated
//! once at a point.

use std::collections::BTreeSet;

use super::{Call, Fit, Texture, Value};

/// Values that are evaluated at the same point, apart from what stands in the textures that they name.
#[derive(Default)]
pub struct Point {
    /// The named textures, as often as they are named.
    pub named: Vec<usize>,
    /// The images that are looked up.
    pub images: Vec<usize>,
    /// What is evaluated at other points, and how often the text of that runs.
    pub others: Vec<(u64, Point)>,
    /// Textures and mappings without a name.
    own: u64,
}

/// A texture of three sides looks at each.
const SIDES: u64 = 3;

impl Point {
    pub fn of<'v>(values: impl IntoIterator<Item = &'v Value>) -> Self {
        let mut point = Self::default();
        values.into_iter().for_each(|value| point.add(value));
        point
    }

    /// How many textures and mappings are evaluated; `costs` has for each texture that may be named what it
    /// costs by itself.
    pub fn evaluations(&self, textures: &[Texture], costs: &[u64]) -> u64 {
        let mut open = self.named.clone();
        let mut seen = BTreeSet::new();
        while let Some(index) = open.pop() {
            if seen.insert(index) {
                open.extend(Point::of([&textures[index].value]).named);
            }
        }
        let named = seen.iter().fold(0u64, |sum, index| sum.saturating_add(costs[*index]));
        named.saturating_add(self.cost(textures, costs))
    }

    /// The same without what the named textures cost at this point.
    pub fn cost(&self, textures: &[Texture], costs: &[u64]) -> u64 {
        let cost = |(times, point): &(u64, Point)| times.saturating_mul(point.evaluations(textures, costs));
        self.others.iter().map(cost).fold(self.own, u64::saturating_add)
    }

    fn add(&mut self, value: &Value) {
        match value {
            Value::Const(_) | Value::Model(_) => {}
            Value::Texture(index) => self.named.push(*index),
            Value::Grey(inner) | Value::Luminance(inner) => self.add(inner),
            Value::Call(call) => {
                let place = self.moved(call.at.as_deref());
                place.own += 1;
                call.arguments.iter().for_each(|argument| place.add(argument));
            }
            Value::Ramp(ramp) => {
                let place = self.moved(ramp.at.as_deref());
                place.own += 1;
                place.add(&ramp.by);
                ramp.stops.iter().for_each(|(_, stop)| place.add(stop));
            }
            Value::Triplanar(form) => {
                let place = self.moved(form.at.as_deref());
                place.own += 1;
                place.others.push((SIDES, Point::of([&form.of])));
            }
            Value::Image(picture) => {
                self.images.push(picture.image);
                picture.under.iter().for_each(|under| self.add(under));
                let place = match picture.fit {
                    Fit::Mapping => self.other(1),
                    _ => self,
                };
                place.moved(picture.at.as_deref()).own += 1;
            }
        }
    }

    /// The point that `mapping` makes of this one.
    fn moved(&mut self, mapping: Option<&Call>) -> &mut Self {
        let Some(mapping) = mapping else { return self };
        let place = self.moved(mapping.at.as_deref());
        place.own += 1;
        mapping.arguments.iter().for_each(|argument| place.add(argument));
        place.other(1)
    }

    fn other(&mut self, times: u64) -> &mut Self {
        self.others.push((times, Self::default()));
        &mut self.others.last_mut().expect("it was just pushed").1
    }
}

impl Call {
    /// What moves the point before all others do: this, or what it is given as `at`.
    pub fn innermost(&self) -> &Self {
        self.at.as_deref().map_or(self, Self::innermost)
    }
}
