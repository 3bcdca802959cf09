//! What a WGSL file declares.
//!
//! In: its tokens. Out: its declarations in order, and the signatures of its functions.

use std::ops::Range;

use super::lexer::{Kind, Token, Tokens};

/// A thing that a file declares.
#[derive(Debug)]
pub struct Declaration<'a> {
    /// `fn`, `const`, `var`, …; another word is no declaration of WGSL.
    pub keyword: Token<'a>,
    pub name: Option<Token<'a>>,
    /// Names behind `@`, before the keyword.
    pub attributes: Vec<Token<'a>>,
    /// From the keyword to the end, the body of a function too.
    pub tokens: Range<usize>,
    /// Where it starts, its attributes too.
    pub start: usize,
}

/// A `name: type` of a signature.
#[derive(Debug)]
pub struct Declared<'a> {
    pub name: &'a str,
    /// Without blanks and comments.
    pub ty: String,
    pub span: Range<usize>,
}

/// The parameters of a function, and what it returns.
#[derive(Debug)]
pub struct Signature<'a> {
    /// Where the declaration starts.
    pub start: usize,
    /// `fn name`
    pub head: Range<usize>,
    pub declared: Vec<Declared<'a>>,
    pub returns: String,
}

pub fn declarations<'a>(tokens: &Tokens<'a>) -> Vec<Declaration<'a>> {
    let all = &tokens.all;
    let mut found = vec![];
    let mut at = 0;
    while at < all.len() {
        let start = all[at].start;
        let mut attributes = vec![];
        while all[at].is("@") && at + 1 < all.len() {
            attributes.push(all[at + 1].clone());
            at += 2;
            if all.get(at).is_some_and(|t| t.is("(")) {
                at = behind_brackets(all, at);
            }
            if at >= all.len() {
                return found;
            }
        }
        let from = at;
        let keyword = all[at].clone();
        at += 1;
        if keyword.is(";") {
            continue;
        }
        while at < all.len() {
            let token = &all[at];
            at = if ["(", "[", "{"].contains(&token.text) { behind_brackets(all, at) } else { at + 1 };
            // A foreign function, such as `float f() { … }`, ends with its body, too.
            if token.is(";") || token.is("{") {
                break;
            }
        }
        let name = name_of(all, from, &keyword);
        found.push(Declaration { keyword, name, attributes, tokens: from..at, start });
    }
    found
}

/// The name behind the keyword, and behind what `var<…>` has between.
fn name_of<'a>(all: &[Token<'a>], from: usize, keyword: &Token<'a>) -> Option<Token<'a>> {
    let mut at = from + 1;
    if keyword.is("var") && all.get(at)?.is("<") {
        at += all[at..].iter().position(|t| t.is(">"))? + 1;
    }
    all.get(at).filter(|t| t.kind == Kind::Word).cloned()
}

/// The token behind the bracket that closes the one at `open`.
fn behind_brackets(all: &[Token<'_>], open: usize) -> usize {
    let mut depth = 0;
    for (at, token) in all.iter().enumerate().skip(open) {
        match token.text {
            "(" | "[" | "{" => depth += 1,
            ")" | "]" | "}" => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return at + 1;
        }
    }
    all.len()
}

impl<'a> Declaration<'a> {
    /// Of a function whose head is whole.
    pub fn signature(&self, tokens: &Tokens<'a>) -> Option<Signature<'a>> {
        let own = &tokens.all[self.tokens.clone()];
        let name = self.name.as_ref().filter(|_| self.keyword.is("fn"))?;
        let open = own.get(2).filter(|t| t.is("(")).map(|_| 2)?;
        let close = behind_brackets(own, open);
        let mut declared = vec![];
        let (mut from, mut depth) = (open + 1, 0);
        for (at, token) in own.iter().enumerate().take(close).skip(open + 1) {
            match token.text {
                "(" | "[" | "<" => depth += 1,
                "]" | ">" => depth -= 1,
                ")" if at + 1 < close => depth -= 1,
                _ => {}
            }
            if at + 1 == close || token.is(",") && depth == 0 {
                declared.extend(parameter(&own[from..at]));
                from = at + 1;
            }
        }
        let body = close + own[close..].iter().position(|t| t.is("{"))?;
        let arrow = own.get(close..close + 2).is_some_and(|t| t[0].is("-") && t[1].is(">"));
        let returns = if arrow { joined(without_attributes(&own[close + 2..body])) } else { String::new() };
        let head = self.keyword.start..name.span().end;
        Some(Signature { start: self.start, head, declared, returns })
    }
}

fn parameter<'a>(tokens: &[Token<'a>]) -> Option<Declared<'a>> {
    let tokens = without_attributes(tokens);
    let [name, colon, ty @ ..] = tokens else { return None };
    let span = name.start..tokens.last()?.span().end;
    colon.is(":").then(|| Declared { name: name.text, ty: joined(ty), span })
}

fn without_attributes<'t, 'a>(tokens: &'t [Token<'a>]) -> &'t [Token<'a>] {
    let mut at = 0;
    while tokens.get(at).is_some_and(|t| t.is("@")) {
        at += 2;
        if tokens.get(at).is_some_and(|t| t.is("(")) {
            at = behind_brackets(tokens, at);
        }
    }
    tokens.get(at..).unwrap_or_default()
}

/// A type by its short name, such as `vec3f`, with a blank behind each comma.
fn joined(tokens: &[Token<'_>]) -> String {
    let text = tokens.iter().map(|t| t.text).collect::<String>();
    let short = ["2", "3", "4"].into_iter().find_map(|n| {
        let scalar = text.strip_prefix("vec")?.strip_prefix(n)?.strip_prefix('<')?.strip_suffix('>')?;
        let letter = ["f32", "i32", "u32"].into_iter().find(|s| *s == scalar.trim_end_matches(','))?;
        Some(format!("vec{n}{}", &letter[..1]))
    });
    short.unwrap_or_else(|| text.replace(',', ", "))
}
