//! What a file of WGSL may not have as a part of raytoy's module, although naga lets it pass on its own.
//!
//! In: a [`Header`]. Out: an error at each such place, with what to write instead.

use super::declarations::Declaration;
use super::header::Header;
use super::lexer::{Kind, Token};
use super::{function, mixing, taken};
use crate::diagnostic::Diagnostic;

/// How deep brackets may be nested: readers of WGSL recurse.
const DEEPEST: usize = 100;

/// Functions that compare a pixel with those beside it.
const NEIGHBORS: [&str; 12] = [
    "dpdx",
    "dpdy",
    "fwidth",
    "dpdxCoarse",
    "dpdyCoarse",
    "fwidthCoarse",
    "dpdxFine",
    "dpdyFine",
    "fwidthFine",
    "textureSample",
    "textureSampleBias",
    "textureSampleCompare",
];

/// Functions that only compute shaders have.
const COMPUTES: [&str; 4] = ["workgroupBarrier", "storageBarrier", "textureBarrier", "workgroupUniformLoad"];

/// Words that begin a line of GLSL.
const GLSL: [&str; 14] = [
    "void",
    "float",
    "int",
    "uint",
    "vec2",
    "vec3",
    "vec4",
    "mat2",
    "mat3",
    "mat4",
    "uniform",
    "precision",
    "in",
    "out",
];

/// All that stands in the way.
pub fn problems(header: &Header<'_>) -> Vec<Diagnostic> {
    let deep = deep_bracket(&header.tokens.all);
    if let Some(token) = deep {
        return vec![
            Diagnostic::error(format!("brackets are nested more than {DEEPEST} deep"))
                .at(header.place(token.span()), "")
                .help("give a part of the expression a name: `let part = …;`"),
        ];
    }
    let mut problems: Vec<Diagnostic> =
        header.declarations.iter().filter_map(|d| of_declaration(header, d)).collect();
    // One look at another language is enough.
    if problems.iter().any(|p| p.message.contains("GLSL")) {
        problems.truncate(1);
        return problems;
    }
    problems.extend(header.tokens.all.windows(2).filter_map(|pair| of_word(header, &pair[0], &pair[1])));
    problems.extend(mixing::mixed(&header.tokens.all).into_iter().map(|(first, second, token)| {
        Diagnostic::error(format!("`{first}` and `{second}` need brackets to show which comes first"))
            .at(header.place(token.span()), "")
            .help("WGSL forbids this without brackets: put brackets around the part that comes first")
    }));
    problems
}

fn of_declaration(header: &Header<'_>, declaration: &Declaration<'_>) -> Option<Diagnostic> {
    let own = &header.tokens.all[declaration.tokens.clone()];
    let error =
        |message: String, token: &Token<'_>| Diagnostic::error(message).at(header.place(token.span()), "");
    let keyword = &declaration.keyword;
    let has = |names: &[&str]| declaration.attributes.iter().find(|a| names.contains(&a.text));
    if let Some(stage) = has(&["compute", "fragment", "vertex", "workgroup_size"]) {
        let problem = error(format!("a {} has no entry points", header.family.noun()), stage);
        return Some(problem.help(format!("raytoy calls `fn {}` for each point", header.wgsl_name)));
    }
    let space = own.get(2).filter(|_| keyword.is("var") && own[1].is("<"));
    let is_private = space.is_some_and(|s| s.is("private"));
    if let Some(binding) = has(&["group", "binding", "id"]).filter(|_| !keyword.is("override")) {
        let problem = error(format!("a {} has no bindings", header.family.noun()), binding);
        return Some(problem.help("you can use `frame.time`, `frame.mouse` and `frame.resolution`"));
    }
    if keyword.is("var") && !is_private {
        let message = "a variable outside of functions must be `var<private>`".to_owned();
        return Some(
            error(message, space.unwrap_or(keyword)).help("for a value that does not change, write `const`"),
        );
    }
    if keyword.is("override") {
        let message = "an `override` never gets a value here".to_owned();
        let problem = error(message, keyword).help("write `const` instead of `override`");
        return Some(problem.help("for a value that scenes set, add a parameter to the function"));
    }
    if ["enable", "requires", "diagnostic"].contains(&keyword.text) {
        let message = format!(
            "`{}` is only allowed at the start of a module, and this file is only a part of one",
            keyword.text
        );
        return Some(error(message, keyword).help("remove the line"));
    }
    if let Some(problem) = of_another_language(header, own, error) {
        return Some(problem);
    }
    let name = declaration.name.as_ref()?;
    let owner = taken::owner(name.text)?;
    let problem = error(format!("the name `{}` is taken: {owner}", name.text), name);
    if name.is(&header.wgsl_name) {
        let better = format!("my_{}", function::stem_of(name.text));
        let call = function::wgsl_name_of(&better);
        return Some(problem.help(format!("call the file `{better}.wgsl` and the function `{call}`")));
    }
    let better = format!("{}{}", header.wgsl_name, function::name_of(name.text));
    Some(problem.help(format!("call it `{better}`")))
}

/// `float wave(vec2 p) {` or `#define`.
fn of_another_language(
    header: &Header<'_>,
    own: &[Token<'_>],
    error: impl Fn(String, &Token<'_>) -> Diagnostic,
) -> Option<Diagnostic> {
    let [first, rest @ ..] = own else { return None };
    if first.is("#") {
        let problem = error("WGSL has no `#`: this looks like GLSL".into(), first);
        return Some(problem.help("to name a value, write `const NAME = value;`"));
    }
    let is_foreign = GLSL.contains(&first.text) && rest.first().is_some_and(|t| t.kind == Kind::Word);
    is_foreign.then(|| {
        let problem =
            error(format!("`{}` cannot begin a line in WGSL: this looks like GLSL", first.text), first);
        let returns = if header.family == super::Family::Shape { "f32" } else { "vec3f" };
        problem.help(format!(
            "write a function as `fn name(p: vec2f) -> {returns} {{ … }}`, a value as `let x = 1.0;`"
        ))
    })
}

/// A call, or a statement, that some command of raytoy's cannot take.
fn of_word(header: &Header<'_>, token: &Token<'_>, next: &Token<'_>) -> Option<Diagnostic> {
    if token.kind != Kind::Word {
        return None;
    }
    let error = |message: String| Diagnostic::error(message).at(header.place(token.span()), "");
    let (text, is_call) = (token.text, next.is("("));
    if is_call && NEIGHBORS.contains(&text) {
        let problem = error(format!("`{text}` reads neighboring pixels, which may show another object"));
        return Some(problem.help(match header.family {
            super::Family::Texture => "`at.footprint` is the width of a pixel at this point",
            super::Family::Shape => "raytoy calls a shape for one ray at a time",
        }));
    }
    if is_call && (COMPUTES.contains(&text) || text.starts_with("subgroup") || text.starts_with("quadSwap")) {
        return Some(error(format!(
            "`{text}` is for compute shaders, and raytoy draws with fragment shaders"
        )));
    }
    let is_half = matches!(text, "f16" | "vec2h" | "vec3h" | "vec4h");
    if is_half {
        return Some(error(format!("`{text}` is not available on all GPUs")).help("use `f32` instead"));
    }
    if text == "discard" && next.is(";") {
        let problem = error("`discard` is only allowed in entry points".into());
        return Some(problem.help(format!("a {} must return a value: use `return`", header.family.noun())));
    }
    None
}

fn deep_bracket<'a, 't>(tokens: &'t [Token<'a>]) -> Option<&'t Token<'a>> {
    let mut depth = 0_usize;
    let mut signs = 0_usize;
    tokens.iter().find(|token| {
        match token.text {
            "(" | "[" | "{" => depth += 1,
            ")" | "]" | "}" => depth = depth.saturating_sub(1),
            _ => {}
        }
        // Signs before a value nest, too.
        let is_sign = matches!(token.text, "-" | "!" | "~" | "&" | "*");
        signs = if is_sign { signs + 1 } else { 0 };
        depth > DEEPEST || signs > DEEPEST
    })
}
