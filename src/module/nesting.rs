//! How many branches a driver has in each other at most, once all functions are written into one.
//!
//! In: a module. Out: their number, and a warning where Mesa's software driver forgets some of them. On its
//! way to them, all that follows a branch with a `return` or `continue` in it goes into a branch of its own,
//! and so do the later cases of a `switch`; in a loop `return` is a `break`, and does nothing of the kind.

use naga::{Block, Module, ShaderStage, Span, Statement};

use super::{is_authors, place};
use crate::diagnostic::Diagnostic;
use crate::wgsl::Source;

/// The branches that Mesa's software driver keeps (`LP_MAX_TGSI_NESTING`).
const MAX_BRANCHES: usize = 80;

/// Branches in each other.
#[derive(Clone, Debug, Default)]
pub struct Nest {
    pub depth: usize,
    /// The statements on the way to the innermost, from the outside.
    way: Vec<Span>,
}

/// The deepest of what draws a pixel.
pub fn deepest(module: &Module) -> Nest {
    // A function stands before those that call it.
    let mut known: Vec<Nest> = vec![];
    for (_, function) in module.functions.iter() {
        let nest = Known(&known).block(&function.body, false).nest;
        known.push(nest);
    }
    let fragments = module.entry_points.iter().filter(|entry| entry.stage == ShaderStage::Fragment);
    let nests = fragments.map(|entry| Known(&known).block(&entry.function.body, false).nest);
    nests.max_by_key(|nest| nest.depth).unwrap_or_default()
}

/// Returns a warning if a file of the author's nests deeper than Mesa's software driver supports.
pub fn warning(module: &Module, source: &Source) -> Option<Diagnostic> {
    let Nest { depth, way } = deepest(module);
    let innermost = way.into_iter().rev().find(|span| is_authors(source, *span));
    let innermost = innermost.filter(|_| depth > MAX_BRANCHES)?;
    let message = format!(
        "a computer without a GPU may draw this wrong: {depth} branches are nested, \
         but Mesa's software driver supports only {MAX_BRANCHES}"
    );
    let problem =
        Diagnostic::warning(message).at(place(source, innermost.to_range()?), "this is inside all of them");
    Some(problem.help(
        "write a `switch` whose cases assign to a `var`, and return the `var` at the end",
    ).help(
        "the code after an `if` with a `return` or `continue` counts as nested in it, as do each `else if` \
         and the cases of a `switch` after one that returns",
    ))
}

/// The nests of the functions so far.
struct Known<'a>(&'a [Nest]);

/// What a block does to the nest of those around it.
#[derive(Default)]
struct Effect {
    nest: Nest,
    /// Whether a pixel may leave it so that what follows has to ask.
    leaves: bool,
}

impl Known<'_> {
    fn block(&self, block: &Block, in_loop: bool) -> Effect {
        let mut all = Effect::default();
        let mut passed = 0;
        for (statement, span) in block.span_iter() {
            let effect = self.statement(statement, in_loop);
            all.take(&effect, passed, *span);
            passed += usize::from(effect.leaves);
        }
        all
    }

    fn statement(&self, statement: &Statement, in_loop: bool) -> Effect {
        let mut all = Effect::default();
        match statement {
            Statement::Block(inner) => return self.block(inner, in_loop),
            Statement::If { accept, reject, .. } => {
                for block in [accept, reject] {
                    all.take(&self.block(block, in_loop), 1, start(block));
                }
            }
            Statement::Switch { cases, .. } => {
                let mut passed = 1;
                for case in cases {
                    let effect = self.block(&case.body, in_loop);
                    all.take(&effect, passed, start(&case.body));
                    passed += usize::from(effect.leaves);
                }
            }
            Statement::Loop { body, continuing, .. } => {
                for block in [body, continuing] {
                    all.take(&self.block(block, true), 0, start(block));
                }
                all.leaves = !in_loop && returns(body);
            }
            Statement::Call { function, .. } => all.nest = self.0[function.index()].clone(),
            Statement::Return { .. } => all.leaves = !in_loop,
            Statement::Continue => all.leaves = true,
            _ => (),
        }
        all
    }
}

impl Effect {
    /// `inner` is at `span`, in so many branches.
    fn take(&mut self, inner: &Effect, outside: usize, span: Span) {
        self.leaves |= inner.leaves;
        let depth = inner.nest.depth + outside;
        if depth > self.nest.depth {
            let way = [span].into_iter().chain(inner.nest.way.iter().copied()).collect();
            self.nest = Nest { depth, way };
        }
    }
}

fn start(block: &Block) -> Span {
    block.span_iter().next().map_or(Span::UNDEFINED, |(_, span)| *span)
}

fn returns(block: &Block) -> bool {
    block.iter().any(|statement| match statement {
        Statement::Return { .. } => true,
        Statement::Block(inner) => returns(inner),
        Statement::If { accept, reject, .. } => returns(accept) || returns(reject),
        Statement::Switch { cases, .. } => cases.iter().any(|case| returns(&case.body)),
        Statement::Loop { body, .. } => returns(body),
        _ => false,
    })
}
