//! How the cases of a switch give what their function returns.

use super::code::CodeLines;

/// The most cases that return. Mesa's software driver puts all that follows a `return` into a branch of its
/// own, one in the other, and loses count of more than 80. What is assigned leaves nothing to follow.
const MAX_RETURNS: usize = 16;

/// What a function with a switch returns.
pub struct Answer {
    /// With `_` in it, which no name has that an author may choose.
    name: &'static str,
    ty: &'static str,
    is_returned: bool,
}

impl Answer {
    /// Of a switch with so many cases.
    pub fn new(cases: usize, name: &'static str, ty: &'static str) -> Self {
        Self { name, ty, is_returned: cases <= MAX_RETURNS }
    }

    /// What stands before the answer in a case: `return ` or `name = `.
    pub fn give(&self) -> String {
        if self.is_returned { "return ".into() } else { format!("{} = ", self.name) }
    }

    /// The same as a whole statement.
    pub fn given(&self, answer: &str) -> String {
        format!("{}{answer};", self.give())
    }

    /// `switch selector` with `cases`, whose lines are eight columns in.
    pub fn switch(&self, selector: &str, cases: CodeLines) -> CodeLines {
        let Self { name, ty, is_returned } = self;
        let mut lines = CodeLines::default();
        if !is_returned {
            lines.push(format!("    var {name}: {ty};"));
        }
        lines.push(format!("    switch {selector} {{"));
        lines.extend(cases);
        lines.push("    }");
        if !is_returned {
            lines.push(format!("    return {name};"));
        }
        lines
    }
}
