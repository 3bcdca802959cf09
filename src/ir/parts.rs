//! Which objects a solid is made of, and in which groups.

use super::{Combination, Operation, Solid};

/// The most parts of a combination, and of a group of them: drivers compile more at once slowly.
const MOST_PARTS: usize = 16;

impl Solid {
    /// Whether it is or has this one of [`super::Scene::objects`].
    pub fn has(&self, object: usize) -> bool {
        match self {
            Solid::Object(index) => *index == object,
            Solid::Combination(combination) => combination.parts.iter().any(|part| part.has(object)),
        }
    }
}

impl Combination {
    /// The same solid, in which many parts are combinations of a few.
    pub fn in_groups(mut self) -> Self {
        let name = self.name.clone();
        if self.parts.len() > MOST_PARTS && self.operation == Operation::Difference {
            // What is in none of many is not in their union.
            let cut = group(format!("{name}, what is cut away"), Operation::Union, self.parts.split_off(1));
            self.parts.push(Solid::Combination(cut.in_groups()));
        }
        let mut width = 1;
        while self.parts.len() > MOST_PARTS {
            width *= MOST_PARTS;
            let mut parts = std::mem::take(&mut self.parts).into_iter().peekable();
            for first in (1..).step_by(width) {
                if parts.peek().is_none() {
                    break;
                }
                let few = parts.by_ref().take(MOST_PARTS).collect();
                let name = format!("{name}, parts {first} to {}", first + width - 1);
                self.parts.push(Solid::Combination(group(name, self.operation, few)));
            }
        }
        self
    }
}

fn group(name: String, operation: Operation, parts: Vec<Solid>) -> Combination {
    Combination { name, caption: format!("{operation:?}"), operation, parts }
}
