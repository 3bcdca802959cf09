//! Which files a scene needs besides its own section.

use std::sync::Arc;

use super::Section;
use crate::library::{BUILT_IN, Function, built_in};

/// The hand-written shader around every scene.
const CORE: [&str; 13] = [
    "pixel",
    "trace",
    "branch",
    "media",
    "footprint_samples",
    "point",
    "shading",
    "light",
    "material",
    "space",
    "hit",
    "ray",
    "frame",
];

/// What goes before it: the entry points, by those who call them.
const OF_RAYTOY: [&str; 4] = ["main", "cover", "view", "number_color"];
const OF_RAYTOY_PLAIN: [&str; 4] = ["main", "cover", "plain", "unviewed"];
const OF_ANY_HOST: [&str; 4] = ["standalone", "cover", "unviewed", "tone"];
const OF_SHADERTOY: [&str; 5] = ["shadertoy", "unviewed", "tone", "integers", "integer_vectors"];

/// Files in shaders/ that are no part of every picture's shader.
const APART: [&str; 5] = ["display", "guard", "lines", "probe", "unmeasured"];
const PROBE: &str = "shaders/probe.wgsl";
const UNMEASURED: &str = "shaders/unmeasured.wgsl";
/// The debug views.
pub const VIEWS: &str = "shaders/view.wgsl";
/// What ends the loops of the author's.
pub const GUARD: &str = "shaders/guard.wgsl";

/// Who draws with a module.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Host {
    /// This program: [`crate::gpu`].
    Raytoy,
    /// The same, as long as it shows no debug view: drivers compile that a fifth sooner.
    RaytoyPlain,
    /// A program of anyone's, without raytoy.
    Any,
    /// shadertoy.com, which takes one function without any bindings.
    Shadertoy,
}

/// The sections that the scene's own text and the functions that it uses stand on.
pub fn needed(own: &Section, used: &[Arc<Function>], host: Host) -> Vec<Section> {
    let mut sections: Vec<Section> =
        used.iter().map(|f| Section { name: f.file.clone(), text: f.text.clone() }).collect();
    // Shared files may use each other, so each round may find more.
    loop {
        let calls = |f: &str| calls(&own.text, f) || sections.iter().any(|s| calls(&s.text, f));
        let found: Vec<Section> = shared()
            .filter(|(name, _)| sections.iter().all(|s| s.name != *name))
            .filter(|(_, text)| functions_in(text).any(calls))
            .map(|(name, text)| section(name, text))
            .collect();
        if found.is_empty() {
            break;
        }
        sections.extend(found);
    }
    let entries = match host {
        Host::Raytoy => &OF_RAYTOY[..],
        Host::RaytoyPlain => &OF_RAYTOY_PLAIN,
        Host::Any => &OF_ANY_HOST,
        Host::Shadertoy => &OF_SHADERTOY,
    };
    for stem in entries.iter().chain(&CORE) {
        let name = format!("shaders/{stem}.wgsl");
        sections.push(section(&name, built_in(&name).expect("the lists name files in shaders/")));
    }
    let may_loop_for_ever = |section: &Section| !section.ships() && has_loop(&section.text);
    let is_ours = matches!(host, Host::Raytoy | Host::RaytoyPlain);
    if is_ours && sections.iter().any(may_loop_for_ever) {
        sections.push(section(GUARD, built_in(GUARD).expect("it ships with raytoy")));
    }
    sections
}

/// The entry points that ask a scene's functions for values.
pub fn probe() -> Section {
    section(PROBE, built_in(PROBE).expect("it ships with raytoy"))
}

/// What stands for the number that nobody measures.
pub fn unmeasured() -> Section {
    section(UNMEASURED, built_in(UNMEASURED).expect("it ships with raytoy"))
}

fn section(name: &str, text: &str) -> Section {
    Section { name: name.into(), text: text.into() }
}

/// Files in shaders/ that are there for those who call them.
fn shared() -> impl Iterator<Item = (&'static str, &'static str)> {
    BUILT_IN.iter().copied().filter(|(name, _)| {
        let stem = name.strip_prefix("shaders/").and_then(|n| n.strip_suffix(".wgsl"));
        let named = [&CORE[..], &OF_RAYTOY, &OF_RAYTOY_PLAIN, &OF_ANY_HOST, &OF_SHADERTOY, &APART];
        stem.is_some_and(|s| !s.contains('/') && !named.iter().any(|list| list.contains(&s)))
    })
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

fn functions_in(text: &str) -> impl Iterator<Item = &str> {
    text.lines().filter_map(|line| line.strip_prefix("fn ")?.split('(').next())
}

fn calls(text: &str, function: &str) -> bool {
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    text.match_indices(function).any(|(at, _)| {
        text[at + function.len()..].trim_start().starts_with('(') && !text[..at].ends_with(is_name)
    })
}
