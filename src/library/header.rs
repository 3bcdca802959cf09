//! The header of a WGSL file: doc lines and signature, which together are the schema of its name.

use std::ops::Range;
use std::sync::Arc;

use super::doc_line::doc_line;
use super::function::Traits;
use super::{Family, Function, Kind, Parameter, Type, function};
use crate::diagnostic::{Diagnostic, Place};

/// Reads the file called `file`, whose stem names its function.
///
/// # Errors
/// All that breaks the contract of LANGUAGE.md; errors of WGSL itself are naga's to find.
pub fn read(family: Family, file: &str, text: &Arc<str>) -> Result<Function, Vec<Diagnostic>> {
    let stem = file.rsplit('/').next().unwrap_or(file).trim_end_matches(".wgsl");
    let header = Header { family, file, text, wgsl_name: function::wgsl_name_of(stem) };
    let mut problems = header.misnamed_helpers();
    let function = header.function(function::name_of(stem), &mut problems);
    match function {
        Some(function) if problems.is_empty() => Ok(function),
        _ => Err(problems),
    }
}

pub struct Header<'a> {
    pub family: Family,
    file: &'a str,
    text: &'a Arc<str>,
    pub wgsl_name: String,
}

/// A `name: type` of the signature.
pub struct Declared<'a> {
    pub name: &'a str,
    pub ty: &'a str,
    pub span: Range<usize>,
}

/// Where a function starts, its parameters, and what it returns.
pub type Signature<'a> = (usize, Vec<Declared<'a>>, &'a str);

impl Header<'_> {
    pub fn place(&self, span: Range<usize>) -> Place {
        Place { file: self.file.into(), span }
    }

    fn function(&self, name: String, problems: &mut Vec<Diagnostic>) -> Option<Function> {
        let of_ray = self.signature(&self.wgsl_name);
        let main = of_ray.or_else(|| self.distance_signature());
        let Some((start, declared, returns)) = main else {
            let noun = self.family.noun();
            let example = match self.family {
                Family::Shape => "(ray: Ray, …) -> f32",
                Family::Texture => "(at: Surface, …) -> vec3f",
            };
            let missing = Diagnostic::error(format!("the file has no function `{}`", self.wgsl_name))
                .at(self.place(0..0), "")
                .help(format!("a {noun}'s file and function share a name: `fn {}{example}`", self.wgsl_name));
            problems.push(missing);
            return None;
        };
        let kind = self.kind(returns, start, &declared, problems)?;
        let docs = self.doc_lines(start);
        let own = &declared[1..];
        let mut parameters: Vec<Parameter> =
            own.iter().filter_map(|d| self.parameter(d, &docs, problems)).collect();
        self.check_strangers(own, &docs, problems);
        let traits = match kind {
            Kind::Shape => {
                self.mark_points(&mut parameters, &docs, problems);
                self.shape_traits(own, &docs, problems)
            }
            _ => Traits::default(),
        };
        let caption = docs.first().map_or("", |(line, _)| line).trim_end_matches('.').to_owned();
        let (file, text) = (self.file.to_owned(), self.text.clone());
        let wgsl_name = self.wgsl_name.clone();
        Some(Function { name, wgsl_name, kind, caption, parameters, traits, file, text })
    }

    /// The signature of `fn name`, which starts a line.
    pub fn signature(&self, name: &str) -> Option<Signature<'_>> {
        let text = self.text;
        let head = format!("fn {name}(");
        let starts_line = |at: usize| at == 0 || text[..at].ends_with('\n');
        let start = text.match_indices(&head).map(|(at, _)| at).find(|at| starts_line(*at))?;
        let open = start + head.len();
        let close = open + text[open..].find(')')?;
        let mut declared = vec![];
        let mut at = open;
        for part in text[open..close].split(',') {
            let lead = part.len() - part.trim_start().len();
            if let Some((name, ty)) = part.split_once(':') {
                let span = at + lead..at + part.trim_end().len();
                declared.push(Declared { name: name.trim(), ty: ty.trim(), span });
            }
            at += part.len() + 1;
        }
        let rest = &text[close + 1..];
        let returns = rest[..rest.find('{')?].trim().strip_prefix("->")?.trim();
        Some((start, declared, returns))
    }

    fn kind(
        &self,
        returns: &str,
        start: usize,
        declared: &[Declared<'_>],
        problems: &mut Vec<Diagnostic>,
    ) -> Option<Kind> {
        let here = self.place(start..start + 3 + self.wgsl_name.len());
        let (first, argument) = match self.family {
            Family::Shape if self.is_distance() => ("vec3f", "p: vec3f"),
            Family::Shape => ("Ray", "ray: Ray"),
            Family::Texture => ("Surface", "at: Surface"),
        };
        if declared.first().is_none_or(|d| d.ty != first) {
            let message = format!("the first parameter of `{}` must be `{argument}`", self.wgsl_name);
            problems.push(Diagnostic::error(message).at(here, ""));
            return None;
        }
        let kind = match (self.family, returns) {
            (Family::Shape, "f32") => Kind::Shape,
            (Family::Texture, "f32") => Kind::Pattern,
            (Family::Texture, "vec3f" | "vec3<f32>") => Kind::Color,
            (Family::Texture, "Surface") => Kind::Mapping,
            _ => {
                let allowed = match self.family {
                    Family::Shape => "a shape returns `f32`, the t of the crossing or a distance",
                    Family::Texture => "a pattern returns `f32`, a color `vec3f`, a mapping `Surface`",
                };
                let message = format!("`{}` returns `{returns}`", self.wgsl_name);
                problems.push(Diagnostic::error(message).at(here, "").help(allowed));
                return None;
            }
        };
        Some(kind)
    }

    /// The `///` lines that end at `start`, with their places.
    fn doc_lines(&self, start: usize) -> Vec<(&str, Range<usize>)> {
        let mut lines = vec![];
        let mut end = start;
        while let Some(before) = self.text[..end].strip_suffix('\n') {
            let begin = before.rfind('\n').map_or(0, |n| n + 1);
            let Some(doc) = before[begin..].strip_prefix("///") else { break };
            let lead = doc.len() - doc.trim_start().len();
            lines.push((doc.trim(), begin + 3 + lead..before.len()));
            end = begin;
        }
        lines.reverse();
        lines
    }

    fn parameter(
        &self,
        declared: &Declared<'_>,
        docs: &[(&str, Range<usize>)],
        problems: &mut Vec<Diagnostic>,
    ) -> Option<Parameter> {
        let name = declared.name.trim_end_matches('_');
        let types = Type::NAMES.map(|(n, _)| n);
        let Some((_, ty)) = Type::NAMES.into_iter().find(|(n, _)| *n == declared.ty) else {
            let message = format!("a parameter cannot be a `{}`", declared.ty);
            let problem = Diagnostic::error(message).at(self.place(declared.span.clone()), "");
            problems.push(problem.suggest(declared.ty, types));
            return None;
        };
        let documented = docs.iter().find_map(|(line, span)| {
            let rest = line.strip_prefix(name)?;
            rest.trim_start().starts_with(['=', ':', ',']).then_some((rest.trim_start(), span))
        });
        let Some((line, span)) = documented else {
            let message = format!("parameter `{name}` has no doc line");
            let advice =
                format!("write above the function: `/// {name} = default, low to high: what it does`");
            problems.push(Diagnostic::error(message).at(self.place(declared.span.clone()), "").help(advice));
            return None;
        };
        match doc_line(declared.name, ty, line) {
            Ok(parameter) => Some(parameter),
            Err(message) => {
                let advice = format!("write `{name} = default, low to high: what it does`");
                problems.push(Diagnostic::error(message).at(self.place(span.clone()), "").help(advice));
                None
            }
        }
    }

    /// Doc lines with a default that belong to no parameter.
    fn check_strangers(
        &self,
        own: &[Declared<'_>],
        docs: &[(&str, Range<usize>)],
        problems: &mut Vec<Diagnostic>,
    ) {
        let names: Vec<&str> = own.iter().map(|d| d.name.trim_end_matches('_')).collect();
        for (line, span) in docs {
            let Some((word, _)) = line.split_once(" = ") else { continue };
            let is_name = word.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
            if is_name && !names.contains(&word) {
                let message = format!("`{}` has no parameter `{word}`", self.wgsl_name);
                let place = self.place(span.start..span.start + word.len());
                problems.push(Diagnostic::error(message).at(place, "").suggest(word, names.iter().copied()));
            }
        }
    }

    /// All snippets of a scene share one WGSL module, so helpers carry their function's name.
    fn misnamed_helpers(&self) -> Vec<Diagnostic> {
        if self.signature(&self.wgsl_name).is_none() && !self.is_distance() {
            return vec![];
        }
        let starts =
            self.text.match_indices("fn ").filter(|(at, _)| *at == 0 || self.text[..*at].ends_with('\n'));
        let helpers = starts.filter_map(|(at, _)| {
            let rest = &self.text[at + 3..];
            let name = &rest[..rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '_')?];
            (!name.starts_with(&self.wgsl_name)).then_some((name, at + 3))
        });
        let wrong = |(name, at): (&str, usize)| {
            let better = format!("{}{}", self.wgsl_name, function::name_of(name));
            Diagnostic::error(format!("the helper `{name}` must begin with `{}`", self.wgsl_name))
                .at(self.place(at..at + name.len()), "")
                .help(format!("call it `{better}`, so that it cannot meet another file's"))
        };
        helpers.map(wrong).collect()
    }
}
