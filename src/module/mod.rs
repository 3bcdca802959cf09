//! naga's verdict on a generated module, reported at the place in the file that it came from.
//!
//! In: a [`Source`]. Out: a [`Module`] that wgpu will take, or diagnostics. Loops of the author's end in it.

mod bounded;
mod guard;
pub mod nesting;

use std::ops::Range;
use std::sync::Arc;

use naga::Span;
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};

use crate::diagnostic::{Diagnostic, Place, Report};
use crate::wgsl::Source;

/// A module that naga has parsed and validated.
#[derive(Clone, Debug)]
pub struct Module {
    naga: Arc<naga::Module>,
    info: Arc<ModuleInfo>,
    loops: Arc<[Report]>,
    unguarded: Option<String>,
    warning: Option<Diagnostic>,
}

impl Module {
    pub fn naga(&self) -> &naga::Module {
        &self.naga
    }

    /// The types of its expressions.
    pub fn info(&self) -> &ModuleInfo {
        &self.info
    }

    /// The report of each loop that shaders/guard.wgsl may have to end, in the order of its numbers.
    pub fn loops(&self) -> &Arc<[Report]> {
        &self.loops
    }

    /// The file and line of a loop of the author's that nothing would end; none unless this program is wrong,
    /// or the module is for another one.
    pub fn unguarded(&self) -> Option<&str> {
        self.unguarded.as_deref()
    }

    /// Warnings about it, although a driver takes it.
    pub fn warning(&self) -> Option<&Diagnostic> {
        self.warning.as_ref()
    }
}

/// Parses and validates `source`. Needs a deep stack: see [`crate::compile::on_deep_stack`].
///
/// # Errors
/// The first mistake that naga finds, at its place in a file of the author's or of ours.
pub fn validate(source: &Source) -> Result<Module, Diagnostic> {
    let text = source.text();
    let mut module = naga::front::wgsl::parse_str(&text).map_err(|error| {
        let mut problem = Diagnostic::error(lower(error.message()));
        for (span, label) in error.labels() {
            if let Some(range) = span.to_range() {
                problem = problem.at(place(source, range), label);
            }
        }
        explained(problem)
    })?;
    let loops = if source.is_guarded() { guard::lay_into(&mut module, source) } else { vec![] };
    // The same that wgpu grants a shader on a device without optional features.
    let capabilities = Capabilities::default();
    let info = Validator::new(ValidationFlags::all(), capabilities).validate(&module).map_err(|error| {
        let mut chain: Vec<String> = vec![];
        let mut cause: Option<&dyn std::error::Error> = Some(error.as_inner());
        while let Some(error) = cause {
            chain.push(readable(&lower(&error.to_string())));
            cause = error.source();
        }
        let message = chain.pop().unwrap_or_default();
        let mut problem = Diagnostic::error(message);
        // The innermost place comes last, after the function that it is in.
        if let Some(range) = error.spans().last().and_then(|(span, _)| span.to_range()) {
            problem = problem.at(place(source, range), "");
        }
        if let Some(context) = chain.into_iter().next() {
            problem = problem.help(format!("naga reports: {context}"));
        }
        explained(problem)
    })?;
    let unguarded = bounded::unguarded(&module, source);
    let warning = nesting::warning(&module, source);
    Ok(Module { naga: Arc::new(module), info: Arc::new(info), loops: loops.into(), unguarded, warning })
}

/// Whether that is in a file beside the scene.
fn is_authors(source: &Source, span: Span) -> bool {
    let range = span.to_range();
    range.is_some_and(|range| {
        let section = source.origin(range.start).0;
        !section.ships() && section.name != source.sections[0].name
    })
}

fn place(source: &Source, range: Range<usize>) -> Place {
    let (section, start) = source.origin(range.start);
    let end = (start + range.len()).min(section.text.len());
    Place { file: section.name.clone(), span: start..end }
}

/// A hint where the mistake is in text that the author never wrote.
fn explained(problem: Diagnostic) -> Diagnostic {
    match problem.labels.first() {
        Some((place, _)) if place.file.starts_with("generated from ") => {
            problem.help("this is generated code: `raytoy generate` prints all of it")
        }
        _ => problem,
    }
}

/// What naga says in its own terms, in those of WGSL.
fn readable(message: &str) -> String {
    if message.starts_with("the `return` expression") {
        return "the value that is returned does not have the type that the function declares".into();
    }
    let mut text = message.to_owned();
    for (kind, letter) in [("Float", "f"), ("Sint", "i"), ("Uint", "u")] {
        let scalar = format!("Scalar {{ kind: {kind}, width: 4 }}");
        for (size, n) in [("Bi", 2), ("Tri", 3), ("Quad", 4)] {
            let vector = format!("Vector {{ size: {size}, scalar: {scalar} }}");
            text = text.replace(&format!("(of type {vector})"), &format!("`vec{n}{letter}`"));
        }
        text = text.replace(&format!("(of type Scalar({scalar}))"), &format!("`{letter}32`"));
    }
    // naga numbers its expressions and functions: `[4] (of type …)`, `[12] 'brick'`.
    let words = text.split(' ').filter(|word| {
        let number = word.strip_prefix('[').and_then(|w| w.strip_suffix(']'));
        number.is_none_or(|n| n.parse::<u32>().is_err())
    });
    words.collect::<Vec<_>>().join(" ")
}

fn lower(message: &str) -> String {
    let mut letters = message.trim_end_matches('.').chars();
    match letters.next() {
        Some(first) if !message.chars().nth(1).is_some_and(char::is_uppercase) => {
            first.to_lowercase().chain(letters).collect()
        }
        _ => message.to_owned(),
    }
}
