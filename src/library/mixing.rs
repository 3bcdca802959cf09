//! Operators that WGSL wants brackets between: naga takes `a < b & c`, and Chrome refuses it.
//!
//! In: the tokens of a file. Out: each first operator that may not stand beside those before it.

use super::lexer::{Kind, Token};

/// In which order operators bind; those of a group that are written alike may follow each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Group {
    Sum,
    Shift,
    Comparison,
    Bits,
    Logic,
}

/// Names whose `<` opens a list of types.
const TEMPLATES: [&str; 7] = ["vec2", "vec3", "vec4", "array", "ptr", "bitcast", "var"];

/// Operators of several signs, those with more first.
const LONG: [&str; 20] = [
    "<<=", ">>=", "<<", ">>", "<=", ">=", "==", "!=", "&&", "||", "+=", "-=", "*=", "/=", "%=", "&=", "|=",
    "^=", "++", "--",
];

/// Words that no value ends with.
const STATEMENTS: [&str; 8] = ["return", "if", "else", "switch", "case", "while", "for", "const_assert"];

/// The operators between two brackets, commas or semicolons so far.
#[derive(Default)]
struct Piece<'a>(Vec<(Group, String, &'a Token<'a>)>);

/// Pairs of operators with the second one's token.
pub fn mixed<'a>(tokens: &'a [Token<'a>]) -> Vec<(String, String, &'a Token<'a>)> {
    let mut found = vec![];
    let mut outer: Vec<Piece<'_>> = vec![];
    let mut piece = Piece::default();
    let mut is_value = false;
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        at += 1;
        if token.kind != Kind::Sign {
            is_value = !STATEMENTS.contains(&token.text);
            let is_template = TEMPLATES.contains(&token.text) || token.text.starts_with("mat");
            if is_template && tokens.get(at).is_some_and(|t| t.is("<")) {
                at = behind_template(tokens, at);
            }
            continue;
        }
        match token.text {
            "(" | "[" => {
                outer.push(std::mem::take(&mut piece));
                is_value = false;
            }
            ")" | "]" => {
                found.extend(piece.wrong());
                piece = outer.pop().unwrap_or_default();
                is_value = true;
            }
            "{" | "}" | ";" | "," | ":" | "@" => {
                found.extend(std::mem::take(&mut piece).wrong());
                is_value = false;
            }
            "." => {}
            _ if !is_value => {}
            _ => {
                let operator = operator(&tokens[at - 1..]);
                at += operator.len() - 1;
                if let Some(group) = group(&operator) {
                    piece.0.push((group, operator, token));
                } else {
                    found.extend(std::mem::take(&mut piece).wrong());
                }
                is_value = false;
            }
        }
    }
    found.extend(piece.wrong());
    found
}

/// The longest operator that `tokens` open with.
fn operator(tokens: &[Token<'_>]) -> String {
    let together = tokens.windows(2).take(2).take_while(|pair| pair[0].span().end == pair[1].start).count();
    let near: String = tokens.iter().take(together + 1).map(|t| t.text).collect();
    let known = LONG.iter().find(|long| near.starts_with(**long));
    known.map_or_else(|| tokens[0].text.to_owned(), |long| (*long).to_owned())
}

fn group(operator: &str) -> Option<Group> {
    Some(match operator {
        "+" | "-" | "*" | "/" | "%" => Group::Sum,
        "<<" | ">>" => Group::Shift,
        "<" | ">" | "<=" | ">=" | "==" | "!=" => Group::Comparison,
        "&" | "|" | "^" => Group::Bits,
        "&&" | "||" => Group::Logic,
        _ => return None,
    })
}

impl<'a> Piece<'a> {
    /// The first two that want brackets, and where.
    fn wrong(self) -> Option<(String, String, &'a Token<'a>)> {
        let pair = |a: &str, b: &(Group, String, &'a Token<'a>)| Some((a.to_owned(), b.1.clone(), b.2));
        let of = |group: Group| self.0.iter().find(move |o| o.0 == group);
        if let Some(bits) = of(Group::Bits) {
            let other = self.0.iter().find(|o| o.1 != bits.1)?;
            return if other.2.start > bits.2.start { pair(&bits.1, other) } else { pair(&other.1, bits) };
        }
        if let Some(first) = of(Group::Logic)
            && let Some(other) = self.0.iter().find(|o| o.0 == Group::Logic && o.1 != first.1)
        {
            return pair(&first.1, other);
        }
        for part in self.0.split(|o| o.0 == Group::Logic) {
            let mut comparisons = part.iter().filter(|o| o.0 == Group::Comparison);
            if let (Some(first), Some(second)) = (comparisons.next(), comparisons.next()) {
                return pair(&first.1, second);
            }
            for side in part.split(|o| o.0 == Group::Comparison) {
                let shifts = side.iter().any(|o| o.0 == Group::Shift);
                if let (true, [first, second, ..]) = (shifts, side) {
                    return pair(&first.1, second);
                }
            }
        }
        None
    }
}

/// The token behind the `>` that closes the `<` at `open`.
fn behind_template(tokens: &[Token<'_>], open: usize) -> usize {
    let mut depth = 0;
    for (at, token) in tokens.iter().enumerate().skip(open) {
        match token.text {
            "<" => depth += 1,
            ">" => depth -= 1,
            ";" | "{" => return at,
            _ => {}
        }
        if depth == 0 {
            return at + 1;
        }
    }
    tokens.len()
}
