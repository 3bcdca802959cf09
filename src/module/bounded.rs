//! The promise on which `gpu/pipeline.rs` has wgpu count no loops: each loop of an author's has a guard.
//!
//! In: a module that [`super::guard`] has rewritten if words of its text begin loops, and its source. Out:
//! a loop of the module itself that nothing would end.

use naga::{Block, Function, Handle, Module, Span, Statement};

use super::place;
use crate::wgsl::Source;

/// The first loop that asks nobody whether to go on, and is in no file that ships: its file and line.
pub fn unguarded(module: &Module, source: &Source) -> Option<String> {
    let mut functions = module.functions.iter();
    let asked = functions.find(|(_, function)| function.name.as_deref() == Some("loopEnds"));
    // Without shaders/guard.wgsl a function of that name is the author's.
    let asked = asked.filter(|_| source.is_guarded()).map(|(handle, _)| handle);
    let entries = module.entry_points.iter().map(|entry| &entry.function);
    let mut functions = module.functions.iter().map(|(_, function)| function).chain(entries);
    let span = functions.find_map(|function| first(&function.body, source, asked))?;
    let Some(range) = span.to_range() else { return Some("an unknown place".into()) };
    let place = place(source, range);
    let section = source.sections.iter().find(|section| section.name == place.file)?;
    let line = 1 + section.text[..place.span.start].matches('\n').count();
    Some(format!("{}:{line}", place.file))
}

/// The first such loop of a block.
fn first(block: &Block, source: &Source, asked: Option<Handle<Function>>) -> Option<Span> {
    let within = |block: &Block| first(block, source, asked);
    block.span_iter().find_map(|(statement, span)| match statement {
        Statement::Loop { body, continuing, .. } => {
            let is_free = !is_ours(source, *span) && !asks_first(body, asked);
            is_free.then_some(*span).or_else(|| within(body)).or_else(|| within(continuing))
        }
        Statement::Block(inner) => within(inner),
        Statement::If { accept, reject, .. } => within(accept).or_else(|| within(reject)),
        Statement::Switch { cases, .. } => cases.iter().find_map(|case| within(&case.body)),
        _ => None,
    })
}

/// Whether that is in a file that ships, or in the text that is generated: their loops are bounded.
fn is_ours(source: &Source, span: Span) -> bool {
    span.to_range().is_some_and(|range| {
        let section = source.origin(range.start).0;
        section.ships() || section.name == source.sections[0].name
    })
}

/// Whether a loop's body begins with `if loopEnds(number) { break; }`.
fn asks_first(body: &Block, asked: Option<Handle<Function>>) -> bool {
    match &body[..] {
        [Statement::Call { function, result, .. }, Statement::If { condition, accept, .. }, ..] => {
            Some(*function) == asked
                && *result == Some(*condition)
                && matches!(accept[..], [Statement::Break])
        }
        _ => false,
    }
}
