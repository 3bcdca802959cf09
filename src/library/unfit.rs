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
                .help("give a part of it a name: `let part = …;`"),
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
        Diagnostic::error(format!("`{first}` and `{second}` need brackets between them"))
            .at(header.place(token.span()), "")
            .help("Chrome and WGSL itself refuse this: put brackets around the part that comes first")
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
        return Some(problem.help("`frame.time`, `frame.mouse` and `frame.resolution` are at hand"));
    }
    if keyword.is("var") && !is_private {
        let message = "a variable outside of functions must be `var<private>`".to_owned();
        return Some(error(message, space.unwrap_or(keyword)).help("a value that stays is a `const`"));
    }
    if keyword.is("override") {
        let message = "nobody gives an `override` its value".to_owned();
        let problem = error(message, keyword).help("write `const` instead of `override`");
        return Some(problem.help("what a scene may set is a parameter of the function"));
    }
    if ["enable", "requires", "diagnostic"].contains(&keyword.text) {
        let message =
            format!("`{}` stands at the top of a module, and this file is only a part of one", keyword.text);
        return Some(error(message, keyword).help("leave the line out"));
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
        return Some(problem.help("a name for a value is `const NAME = value;`"));
    }
    let is_foreign = GLSL.contains(&first.text) && rest.first().is_some_and(|t| t.kind == Kind::Word);
    is_foreign.then(|| {
        let problem = error(format!("`{}` begins no line of WGSL: this looks like GLSL", first.text), first);
        let returns = if header.family == super::Family::Shape { "f32" } else { "vec3f" };
        problem
            .help(format!("a function is `fn name(p: vec2f) -> {returns} {{ … }}`, a value `let x = 1.0;`"))
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
        let problem =
            error(format!("`{text}` asks the pixels beside this one, which may show something else"));
        return Some(problem.help(match header.family {
            super::Family::Texture => "`at.footprint` is how wide a pixel is at this point",
            super::Family::Shape => "a ray is alone: a shape is asked for each by itself",
        }));
    }
    if is_call && (COMPUTES.contains(&text) || text.starts_with("subgroup") || text.starts_with("quadSwap")) {
        return Some(error(format!("`{text}` is for compute shaders, and pictures are drawn by others")));
    }
    let is_half = matches!(text, "f16" | "vec2h" | "vec3h" | "vec4h");
    if is_half {
        return Some(error(format!("`{text}` is not known everywhere")).help("write it with `f32`"));
    }
    if text == "discard" && next.is(";") {
        let problem = error("`discard` is for entry points".into());
        return Some(problem.help(format!("a {} always gives a value: `return`", header.family.noun())));
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
