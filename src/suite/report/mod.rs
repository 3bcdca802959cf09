//! What came of a run, for people, for programs, and as a page.

mod html;
mod human;
mod json;
mod junit;

pub use html::html;
pub use human::human;
pub use json::json;
pub use junit::junit;

use super::Outcome;

/// A run that is over.
#[derive(Clone, Debug)]
pub struct Run {
    /// In the order of their names.
    pub outcomes: Vec<Outcome>,
    /// What drew the pictures.
    pub adapter: String,
    /// What a call of raytoy needs besides the test's name to do the same again: " --adapter nvidia", or
    /// nothing.
    pub call: String,
}

impl Run {
    pub fn passed(&self) -> usize {
        self.outcomes.iter().filter(|outcome| outcome.passes()).count()
    }

    pub fn failed(&self) -> usize {
        self.outcomes.iter().filter(|outcome| !outcome.failures.is_empty()).count()
    }
}
