//! Which files a module has besides the scene's own section.
//!
//! In: a [`Target`], the scene's section, the functions that it uses. Out: sections.

use std::sync::Arc;

use super::{Host, Section, Target};
use crate::library::{Function, built_in};

/// Which modules have a file of shaders/.
enum Presence {
    /// Those of which this is true.
    If(fn(&Module) -> bool),
    /// Those in which one of its functions is called.
    IfCalled,
    /// No scene's: it is a pass over a finished picture.
    Never,
}

/// What decides on the files of one module.
struct Module<'a> {
    target: &'a Target,
    /// Whether the scene's own section has `measuredAt`.
    is_measured: bool,
    /// Whether a file of the author's has loops.
    may_loop_for_ever: bool,
}

/// The end of the loops of the author's.
pub const GUARD: &str = "shaders/guard.wgsl";

/// Each file of shaders/ but for the shapes, in the order of a module's sections. Those that are there if
/// they are called stand before all others.
const FILES: [(&str, Presence); 51] = [
    ("shaders/bands.wgsl", Presence::IfCalled),
    ("shaders/bounds.wgsl", Presence::IfCalled),
    ("shaders/bump.wgsl", Presence::IfCalled),
    ("shaders/cells.wgsl", Presence::IfCalled),
    ("shaders/facet.wgsl", Presence::IfCalled),
    ("shaders/footprint.wgsl", Presence::IfCalled),
    ("shaders/image.wgsl", Presence::IfCalled),
    ("shaders/light_kinds.wgsl", Presence::IfCalled),
    ("shaders/luminance.wgsl", Presence::IfCalled),
    ("shaders/march.wgsl", Presence::IfCalled),
    ("shaders/model.wgsl", Presence::IfCalled),
    ("shaders/model_surface.wgsl", Presence::IfCalled),
    ("shaders/noise.wgsl", Presence::IfCalled),
    ("shaders/octaves.wgsl", Presence::IfCalled),
    ("shaders/ramp.wgsl", Presence::IfCalled),
    ("shaders/remainder.wgsl", Presence::IfCalled),
    ("shaders/sky.wgsl", Presence::IfCalled),
    ("shaders/solid.wgsl", Presence::IfCalled),
    ("shaders/space.wgsl", Presence::IfCalled),
    ("shaders/tangents.wgsl", Presence::IfCalled),
    ("shaders/triplanar.wgsl", Presence::IfCalled),
    ("shaders/watertight.wgsl", Presence::IfCalled),
    // Entry points, by those who call them, and what these stand on.
    ("shaders/main.wgsl", Presence::If(|module| module.is_for_raytoy())),
    ("shaders/standalone.wgsl", Presence::If(|module| module.target.host == Host::Any)),
    ("shaders/shadertoy.wgsl", Presence::If(|module| module.is_for_shadertoy())),
    ("shaders/cover.wgsl", Presence::If(|module| !module.is_for_shadertoy())),
    ("shaders/view.wgsl", Presence::If(|module| module.target.views)),
    ("shaders/number_color.wgsl", Presence::If(|module| module.target.views)),
    ("shaders/plain.wgsl", Presence::If(|module| module.is_for_raytoy() && !module.target.views)),
    ("shaders/unviewed.wgsl", Presence::If(|module| !module.target.views)),
    ("shaders/tone.wgsl", Presence::If(|module| !module.is_for_raytoy())),
    ("shaders/integers.wgsl", Presence::If(|module| module.is_for_shadertoy())),
    ("shaders/integer_vectors.wgsl", Presence::If(|module| module.is_for_shadertoy())),
    // The core of every module.
    ("shaders/pixel.wgsl", Presence::If(|_| true)),
    ("shaders/trace.wgsl", Presence::If(|_| true)),
    ("shaders/branch.wgsl", Presence::If(|_| true)),
    ("shaders/media.wgsl", Presence::If(|_| true)),
    ("shaders/footprint_samples.wgsl", Presence::If(|_| true)),
    ("shaders/point.wgsl", Presence::If(|_| true)),
    ("shaders/shading.wgsl", Presence::If(|_| true)),
    ("shaders/light.wgsl", Presence::If(|_| true)),
    ("shaders/material.wgsl", Presence::If(|_| true)),
    ("shaders/placed.wgsl", Presence::If(|_| true)),
    ("shaders/hit.wgsl", Presence::If(|_| true)),
    ("shaders/ray.wgsl", Presence::If(|_| true)),
    ("shaders/frame.wgsl", Presence::If(|_| true)),
    // What few modules have besides.
    (GUARD, Presence::If(|module| module.is_for_raytoy() && module.may_loop_for_ever)),
    ("shaders/unmeasured.wgsl", Presence::If(|module| module.target.views && !module.is_measured)),
    ("shaders/probe.wgsl", Presence::If(|module| module.target.probe)),
    ("shaders/display.wgsl", Presence::Never),
    ("shaders/lines.wgsl", Presence::Never),
];

impl Module<'_> {
    fn is_for_raytoy(&self) -> bool {
        self.target.host == Host::Raytoy
    }

    fn is_for_shadertoy(&self) -> bool {
        matches!(self.target.host, Host::Shadertoy { .. })
    }
}

/// The files of shaders/ that modules have, and those of other passes: all but the shapes.
pub fn files() -> impl Iterator<Item = &'static str> {
    FILES.iter().map(|(name, _)| *name)
}

/// The sections that the scene's own text and the functions that it uses stand on.
pub fn needed(own: &Section, used: &[Arc<Function>], target: &Target, is_measured: bool) -> Vec<Section> {
    let mut sections: Vec<Section> =
        used.iter().map(|f| Section { name: f.file.clone(), text: f.text.clone() }).collect();
    let may_loop_for_ever = sections.iter().any(|section| !section.ships() && has_loop(&section.text));
    let module = Module { target, is_measured, may_loop_for_ever };
    let in_any_case = FILES.iter().filter_map(|(name, presence)| match presence {
        Presence::If(is_in) => is_in(&module).then(|| section(name)),
        Presence::IfCalled | Presence::Never => None,
    });
    let in_any_case: Vec<Section> = in_any_case.collect();
    // Shared files may use each other, so each round may find more.
    loop {
        let calls = |function: &str| {
            let mut all = sections.iter().chain(&in_any_case).chain([own]);
            all.any(|section| calls(&section.text, function))
        };
        let shared = FILES.iter().filter(|(_, presence)| matches!(presence, Presence::IfCalled));
        let found: Vec<Section> = shared
            .filter(|(name, _)| sections.iter().all(|s| s.name != *name))
            .filter(|(name, _)| functions_in(text_of(name)).any(calls))
            .map(|(name, _)| section(name))
            .collect();
        if found.is_empty() {
            break;
        }
        sections.extend(found);
    }
    sections.extend(in_any_case);
    sections
}

fn section(name: &str) -> Section {
    Section { name: name.into(), text: text_of(name).into() }
}

fn text_of(name: &str) -> &'static str {
    built_in(name).expect("the table names files in shaders/")
}

/// Whether a word of the text begins a loop. One in a comment may count, too, but none may be missed: a
/// module with a loop that is (`module/bounded.rs`) is not drawn.
fn has_loop(text: &str) -> bool {
    // Behind `/*`, two slashes may be part of a comment that ends on their line.
    let is_plain = !text.contains("/*");
    let ends_line = |c: char| matches!(c, '\n'..='\r' | '\u{85}' | '\u{2028}' | '\u{2029}');
    let code = text.split(ends_line).map(|line| match line.find("//").filter(|_| is_plain) {
        Some(comment) => &line[..comment],
        None => line,
    });
    let mut words = code.flat_map(|line| line.split(|c: char| !c.is_alphanumeric() && c != '_'));
    words.any(|word| matches!(word, "for" | "loop" | "while"))
}

/// The functions of a file of raytoy's, whose lines begin with them.
pub fn functions_in(text: &str) -> impl Iterator<Item = &str> {
    text.lines().filter_map(|line| line.strip_prefix("fn ")?.split('(').next())
}

fn calls(text: &str, function: &str) -> bool {
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    text.match_indices(function).any(|(at, _)| {
        without_blanks(&text[at + function.len()..]).starts_with('(') && !text[..at].ends_with(is_name)
    })
}

/// `text` from its first word or sign on.
fn without_blanks(text: &str) -> &str {
    let rest = text.trim_start();
    let end = match rest.get(..2) {
        Some("/*") => rest.find("*/").map(|at| at + 2),
        Some("//") => rest.find('\n'),
        _ => return rest,
    };
    end.map_or("", |end| without_blanks(&rest[end..]))
}
