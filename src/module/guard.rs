//! Ends the loops of an author's snippets that would not end by themselves: on a GPU nothing else can.
//!
//! In: a parsed module with shaders/guard.wgsl in it. Out: the same, where each such loop asks that file at
//! each step whether to go on, and the report of each loop. The author's text stays as it is.

use std::collections::{HashMap, HashSet};

use naga::{Arena, Block, Expression, Function, Handle, Literal, Module, Span, Statement, SwitchCase};

use super::{is_authors, place};
use crate::diagnostic::{Diagnostic, Place, Report};
use crate::wgsl::Source;

/// As shaders/guard.wgsl says.
const CALL_STEPS: u32 = 1 << 15;
const PIXEL_STEPS: u32 = 1 << 24;

/// Rewrites `module`. Returns the reports for its loops 1, 2, …, if one had to be ended.
pub fn lay_into(module: &mut Module, source: &Source) -> Vec<Report> {
    let named = |name: &str| {
        let mut functions = module.functions.iter();
        let found = functions.find(|(_, function)| function.name.as_deref() == Some(name));
        found.expect("shaders/guard.wgsl has it").0
    };
    let [allow_steps, loop_ends] = ["allowSteps", "loopEnds"].map(named);
    let is_snippet = |handle: &Handle<Function>| is_authors(source, module.functions.get_span(*handle));
    let snippets = module.functions.iter().map(|(handle, _)| handle).filter(is_snippet).collect();
    // naga wants a function before those that call it.
    let mut functions: Vec<_> = std::mem::take(&mut module.functions).drain().collect();
    functions.sort_by_key(|(old, ..)| *old != allow_steps && *old != loop_ends);
    let mut arena = Arena::new();
    let moved = functions.into_iter().map(|(old, function, span)| (old, arena.append(function, span)));
    let moved: HashMap<_, _> = moved.collect();
    let mut writer = Writer { source, allow_steps, loop_ends, snippets, moved, reports: vec![] };
    for (_, function) in arena.iter_mut() {
        writer.rewrite(function);
    }
    module.functions = arena;
    for entry in &mut module.entry_points {
        writer.rewrite(&mut entry.function);
    }
    writer.reports
}

/// What is known while the functions are rewritten, which have moved already. The text has their old handles.
struct Writer<'a> {
    source: &'a Source,
    allow_steps: Handle<Function>,
    loop_ends: Handle<Function>,
    /// The author's functions.
    snippets: HashSet<Handle<Function>>,
    moved: HashMap<Handle<Function>, Handle<Function>>,
    reports: Vec<Report>,
}

impl Writer<'_> {
    fn rewrite(&mut self, function: &mut Function) {
        for (_, expression) in function.expressions.iter_mut() {
            if let Expression::CallResult(called) = expression {
                *called = self.moved[called];
            }
        }
        let body = std::mem::take(&mut function.body);
        function.body = self.block(body, &mut function.expressions, None);
    }

    /// `outer` is the loop that the block is in.
    fn block(&mut self, block: Block, into: &mut Arena<Expression>, outer: Option<&Place>) -> Block {
        let mut written = Block::with_capacity(block.len());
        for (statement, span) in block.span_into_iter() {
            match statement {
                Statement::Block(inner) => {
                    written.push(Statement::Block(self.block(inner, into, outer)), span);
                }
                Statement::If { condition, accept, reject } => {
                    let accept = self.block(accept, into, outer);
                    let reject = self.block(reject, into, outer);
                    written.push(Statement::If { condition, accept, reject }, span);
                }
                Statement::Switch { selector, cases } => {
                    let case =
                        |case: SwitchCase| SwitchCase { body: self.block(case.body, into, outer), ..case };
                    let cases = cases.into_iter().map(case).collect();
                    written.push(Statement::Switch { selector, cases }, span);
                }
                Statement::Loop { body, continuing, break_if } => {
                    let here = is_authors(self.source, span).then(|| self.first_line(span));
                    let mut guarded = Block::new();
                    if let Some(here) = &here {
                        self.reports.push(self.report(here, outer));
                        guarded = self.question(into, span);
                    }
                    let within = here.as_ref().or(outer);
                    guarded.append(&mut self.block(body, into, within));
                    let continuing = self.block(continuing, into, within);
                    written.push(Statement::Loop { body: guarded, continuing, break_if }, span);
                }
                Statement::Call { function, arguments, result } => {
                    if self.snippets.contains(&function) && !is_authors(self.source, span) {
                        let (arguments, result) = (vec![], None);
                        let function = self.moved[&self.allow_steps];
                        written.push(Statement::Call { function, arguments, result }, span);
                    }
                    let function = self.moved[&function];
                    written.push(Statement::Call { function, arguments, result }, span);
                }
                other => written.push(other, span),
            }
        }
        written
    }

    /// `if loopEnds(number) { break; }`, with the number of the last report.
    fn question(&self, into: &mut Arena<Expression>, span: Span) -> Block {
        let function = self.moved[&self.loop_ends];
        let number = into.append(Expression::Literal(Literal::U32(self.reports.len() as u32)), span);
        let ends = into.append(Expression::CallResult(function), span);
        let mut block = Block::new();
        block.push(Statement::Call { function, arguments: vec![number], result: Some(ends) }, span);
        let mut accept = Block::new();
        accept.push(Statement::Break, span);
        block.push(Statement::If { condition: ends, accept, reject: Block::new() }, span);
        block
    }

    /// The line in which a loop begins, up to its brace.
    fn first_line(&self, span: Span) -> Place {
        let place = place(self.source, span.to_range().unwrap_or_default());
        let text = self.text(&place.file);
        let line = text[place.span.clone()].lines().next().unwrap_or_default();
        let head = line.split('{').next().unwrap_or(line).trim_end();
        let end = place.span.start + head.len();
        Place { span: place.span.start..end, ..place }
    }

    fn text(&self, file: &str) -> &str {
        let section = self.source.sections.iter().find(|section| section.name == file);
        &section.expect("a place is in one of the sections").text
    }

    fn report(&self, here: &Place, outer: Option<&Place>) -> Report {
        let mut problem = Diagnostic::error("this loop ran too long and was stopped").at(here.clone(), "");
        if let Some(outer) = outer {
            problem = problem.at(outer.clone(), "or this one, which contains it");
        }
        let problem = problem
            .help(
                "give the loop a largest number of steps, \
                 as in `for (var i = 0u; i < 200u && x < 2.0; i++)`",
            )
            .help(format!(
                "all loops of a file together may take {CALL_STEPS} steps in one call, \
                 and {PIXEL_STEPS} steps for one sample of a pixel"
            ));
        let text = self.text(&here.file).into();
        Report { diagnostics: vec![problem], texts: [(here.file.clone(), text)].into() }
    }
}
