//! What a value is wanted for, which says how the images in it are read.

use super::Resolver;

/// What a value is wanted for. All that a color is made of is wanted for the same; a parameter that is a
/// number wants a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Usage {
    /// Light that comes from it.
    Light,
    /// The share of light that a surface gives back.
    Surface,
    /// A height, a share, a direction.
    Number,
}

impl Resolver<'_> {
    /// What `resolve` gives where all is wanted for `usage`.
    pub fn wanted_for<T>(&mut self, usage: Usage, resolve: impl FnOnce(&mut Self) -> T) -> T {
        let before = std::mem::replace(&mut self.usage, usage);
        let value = resolve(self);
        self.usage = before;
        value
    }
}
