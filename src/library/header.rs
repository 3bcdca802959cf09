//! The header of a WGSL file: doc lines and signature, which together are the schema of its name.

use std::ops::Range;
use std::sync::Arc;

use super::declarations::{Declaration, Declared, Signature};
use super::doc_line::doc_line;
use super::function::Traits;
use super::lexer::{Token, Tokens, ends_line, is_name_part};
use super::{Family, Function, Kind, Parameter, Type, function};
use crate::diagnostic::{Diagnostic, Place};

/// A file of WGSL as its tokens and declarations.
pub struct Header<'a> {
    pub family: Family,
    pub wgsl_name: String,
    pub tokens: Tokens<'a>,
    pub declarations: Vec<Declaration<'a>>,
    pub file: &'a str,
    pub text: &'a Arc<str>,
}

impl<'a> Header<'a> {
    pub fn place(&self, span: Range<usize>) -> Place {
        Place { file: self.file.into(), span }
    }

    pub fn function(&self, name: String, problems: &mut Vec<Diagnostic>) -> Option<Function> {
        let of_ray = self.signature(&self.wgsl_name);
        let main = of_ray.or_else(|| self.distance_signature());
        let Some(signature) = main else {
            let noun = self.family.noun();
            let example = match self.family {
                Family::Shape => "(ray: Ray, …) -> f32",
                Family::Texture => "(at: Surface, …) -> vec3f",
            };
            let missing = Diagnostic::error(format!("the file has no function `{}`", self.wgsl_name))
                .at(self.place(0..0), "")
                .help(format!(
                    "the function of a {noun} is named like its file: `fn {}{example}`",
                    self.wgsl_name
                ));
            problems.push(missing);
            return None;
        };
        let kind = self.kind(&signature, problems)?;
        let docs = self.doc_lines(signature.start);
        let own = &signature.declared[1..];
        let mut parameters: Vec<Parameter> =
            own.iter().filter_map(|d| self.parameter(d, &docs, problems)).collect();
        self.check_strangers(own, &docs, problems);
        let (traits, conditions) = match kind {
            Kind::Shape => {
                self.mark_points(&mut parameters, &docs, problems);
                let traits = self.shape_traits(own, &docs, problems);
                (traits, self.conditions(&parameters, &docs, problems))
            }
            _ => (Traits::default(), vec![]),
        };
        let caption = docs.first().map_or("", |(line, _)| line).trim_end_matches('.').to_owned();
        let (file, text) = (self.file.to_owned(), self.text.clone());
        let wgsl_name = self.wgsl_name.clone();
        Some(Function { name, wgsl_name, kind, caption, parameters, traits, conditions, file, text })
    }

    /// The signature of `fn name`.
    pub fn signature(&self, name: &str) -> Option<Signature<'a>> {
        let is_called = |d: &&Declaration<'_>| d.name.as_ref().is_some_and(|n| n.is(name));
        self.declarations.iter().filter(is_called).find_map(|d| d.signature(&self.tokens))
    }

    fn kind(&self, signature: &Signature<'_>, problems: &mut Vec<Diagnostic>) -> Option<Kind> {
        let here = self.place(signature.head.clone());
        let returns = signature.returns.as_str();
        let (first, argument) = match self.family {
            Family::Shape if self.is_distance() => ("vec3f", "p: vec3f"),
            Family::Shape => ("Ray", "ray: Ray"),
            Family::Texture => ("Surface", "at: Surface"),
        };
        if signature.declared.first().is_none_or(|d| d.ty != first) {
            let message = format!("the first parameter of `{}` must be `{argument}`", self.wgsl_name);
            problems.push(Diagnostic::error(message).at(here, ""));
            return None;
        }
        let kind = match (self.family, returns) {
            (Family::Shape, "f32") => Kind::Shape,
            (Family::Texture, "f32") => Kind::Pattern,
            (Family::Texture, "vec3f") => Kind::Color,
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

    /// The `///` lines directly above `start`, with their places; other comments may stand between.
    fn doc_lines(&self, start: usize) -> Vec<(&'a str, Range<usize>)> {
        let text: &'a str = self.text;
        let mut lines = vec![];
        let mut below = start;
        let above = self.tokens.line_comments.iter().rev().filter(|comment| comment.end <= start);
        for comment in above {
            let between = text[comment.end..below].replace("\r\n", "\n");
            let before = text[..comment.start].chars().rev().find(|c| ends_line(*c) || !c.is_whitespace());
            let starts_line = before.is_none_or(|c| ends_line(c) || c == '\u{feff}');
            if !between.trim().is_empty() || between.matches(ends_line).count() > 1 || !starts_line {
                break;
            }
            below = comment.start;
            if let Some(doc) = text[comment.clone()].strip_prefix("///") {
                let lead = comment.start + 3 + doc.len() - doc.trim_start().len();
                lines.push((doc.trim(), lead..lead + doc.trim().len()));
            }
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
            problems.push(problem.suggest(&declared.ty, types));
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
            let is_name = word.chars().all(is_name_part);
            if is_name && !names.contains(&word) {
                let message = format!("`{}` has no parameter `{word}`", self.wgsl_name);
                let place = self.place(span.start..span.start + word.len());
                problems.push(Diagnostic::error(message).at(place, "").suggest(word, names.iter().copied()));
            }
        }
    }

    /// All snippets of a scene share one WGSL module, so helpers carry their function's name.
    pub fn misnamed_helpers(&self) -> Vec<Diagnostic> {
        if self.signature(&self.wgsl_name).is_none() && !self.is_distance() {
            return vec![];
        }
        let functions = self.declarations.iter().filter(|d| d.keyword.is("fn"));
        let helpers =
            functions.filter_map(|d| d.name.as_ref().filter(|n| !n.text.starts_with(&self.wgsl_name)));
        let wrong = |helper: &Token<'_>| {
            let name = helper.text;
            let better = format!("{}{}", self.wgsl_name, function::name_of(name));
            Diagnostic::error(format!("the helper `{name}` must begin with `{}`", self.wgsl_name))
                .at(self.place(helper.span()), "")
                .help(format!("call it `{better}`, so that it cannot clash with another file"))
        };
        helpers.map(wrong).collect()
    }
}
