//! The header of a WGSL file: doc lines and signature, which together are the schema of its name.

use std::ops::Range;
use std::sync::Arc;

use super::{Const, Family, Function, Kind, Parameter, Type, function, parse_color};
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

struct Header<'a> {
    family: Family,
    file: &'a str,
    text: &'a Arc<str>,
    wgsl_name: String,
}

/// A `name: type` of the signature.
struct Declared<'a> {
    name: &'a str,
    ty: &'a str,
    span: Range<usize>,
}

impl Header<'_> {
    fn place(&self, span: Range<usize>) -> Place {
        Place { file: self.file.into(), span }
    }

    fn function(&self, name: String, problems: &mut Vec<Diagnostic>) -> Option<Function> {
        let Some((start, declared, returns)) = self.signature(&self.wgsl_name) else {
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
        let parameters = own.iter().filter_map(|d| self.parameter(d, &docs, problems)).collect();
        self.check_strangers(own, &docs, problems);
        if kind == Kind::Shape {
            self.check_surface(own, problems);
        }
        let caption = docs.first().map_or("", |(line, _)| line).trim_end_matches('.').to_owned();
        let (file, text) = (self.file.to_owned(), self.text.clone());
        Some(Function { name, wgsl_name: self.wgsl_name.clone(), kind, caption, parameters, file, text })
    }

    /// Where `fn name` starts, its parameters, and what it returns.
    fn signature(&self, name: &str) -> Option<(usize, Vec<Declared<'_>>, &str)> {
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
        let first = match self.family {
            Family::Shape => "Ray",
            Family::Texture => "Surface",
        };
        if declared.first().is_none_or(|d| d.ty != first) {
            let argument = if first == "Ray" { "ray: Ray" } else { "at: Surface" };
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
                    Family::Shape => "a shape returns `f32`, the t of the crossing",
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
        match doc_line(name, ty, line) {
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

    /// A shape's second function takes a point and the same parameters.
    fn check_surface(&self, own: &[Declared<'_>], problems: &mut Vec<Diagnostic>) {
        let name = format!("{}Surface", self.wgsl_name);
        let agrees = self.signature(&name).is_some_and(|(_, second, returns)| {
            let same = second.iter().skip(1).map(|d| (d.name, d.ty)).eq(own.iter().map(|d| (d.name, d.ty)));
            returns == "Surface" && second.first().is_some_and(|d| d.ty == "vec3f") && same
        });
        if !agrees {
            let rest: String = own.iter().map(|d| format!(", {}: {}", d.name, d.ty)).collect();
            let message = format!("the shape lacks `fn {name}(p: vec3f{rest}) -> Surface`");
            let advice = "it gives the outward normal and uv at a point of the surface";
            problems.push(Diagnostic::error(message).at(self.place(0..0), "").help(advice));
        }
    }

    /// All snippets of a scene share one WGSL module, so helpers carry their function's name.
    fn misnamed_helpers(&self) -> Vec<Diagnostic> {
        if self.signature(&self.wgsl_name).is_none() {
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

/// The rest of a doc line, after the name: ` = default, low to high: text`.
fn doc_line(name: &str, ty: Type, rest: &str) -> Result<Parameter, String> {
    let (head, doc) =
        rest.split_once(": ").or_else(|| rest.split_once(':')).ok_or("the doc line has no `:`")?;
    let (default_text, limits) = match head.trim().strip_prefix('=') {
        Some(given) => split_default(given.trim()),
        None => ("", head.trim_start_matches(',').trim()),
    };
    let (default_text, choices) = match default_text.split_once(" of ") {
        Some((word, first)) => (word, format!("{first}, {limits}")),
        None => (default_text, String::new()),
    };
    let choices: Vec<String> =
        choices.split(',').map(|c| c.trim().to_owned()).filter(|c| !c.is_empty()).collect();
    let limits = if choices.is_empty() { limits } else { "" };
    let nonzero = limits == "nonzero";
    let range = if limits.is_empty() || nonzero { None } else { Some(range(limits)?) };
    let (default, is_color) = default(ty, default_text, &choices)?;
    let (name, default_text, doc) = (name.to_owned(), default_text.to_owned(), doc.trim().to_owned());
    Ok(Parameter { name, ty, default, default_text, range, nonzero, is_color, choices, doc })
}

/// The default and what stands behind the comma that follows it.
fn split_default(given: &str) -> (&str, &str) {
    let from = if given.starts_with('(') { given.find(')').unwrap_or(0) } else { 0 };
    match given[from..].find(',') {
        Some(comma) => (given[..from + comma].trim(), given[from + comma + 1..].trim()),
        None => (given, ""),
    }
}

fn range(limits: &str) -> Result<(f32, f32), String> {
    let parsed = limits
        .split_once(" to ")
        .and_then(|(low, high)| Some((low.trim().parse().ok()?, high.trim().parse().ok()?)));
    match parsed {
        Some((low, high)) if low < high => Ok((low, high)),
        _ => Err(format!("`{limits}` is not a range")),
    }
}

fn default(ty: Type, text: &str, choices: &[String]) -> Result<(Option<Const>, bool), String> {
    let wrong = || format!("the default `{text}` is not {}", ty.describe());
    if text.is_empty() {
        return Ok((None, false));
    }
    if let Some(color) = text.strip_prefix('"').and_then(|t| t.strip_suffix('"')) {
        let color = parse_color(color).ok_or_else(|| format!("`{text}` is not a color"))?;
        let is_vec3 = ty == Type::Vec3;
        return if is_vec3 { Ok((Some(Const::Vec3(color)), true)) } else { Err(wrong()) };
    }
    if !choices.is_empty() {
        let at = choices.iter().position(|c| c == text).filter(|_| ty == Type::U32);
        return at.map(|i| (Some(Const::U32(i as u32)), false)).ok_or_else(wrong);
    }
    if ty == Type::Bool {
        return text.parse().map(|b| (Some(Const::Bool(b)), false)).map_err(|_| wrong());
    }
    let inner = text.strip_prefix('(').and_then(|t| t.strip_suffix(')')).unwrap_or(text);
    let numbers: Result<Vec<f32>, _> = inner.split(',').map(|n| n.trim().parse::<f32>()).collect();
    let value = numbers.ok().and_then(|n| Const::from_numbers(ty, &n)).ok_or_else(wrong)?;
    Ok((Some(value), false))
}
