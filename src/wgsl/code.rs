//! Text: expressions that break where a line gets too long, and lines.

use std::fmt::Write;

/// The longest line.
const WIDTH: usize = 100;

/// An expression.
#[derive(Clone, Debug, PartialEq)]
pub enum Code {
    Atom(String),
    Call(String, Vec<Code>),
    /// The selectors of a `case`.
    Cases(Vec<Code>),
}

/// Lines of text, without their ends.
#[derive(Default)]
pub struct CodeLines(Vec<String>);

impl Code {
    pub fn atom(text: impl Into<String>) -> Self {
        Self::Atom(text.into())
    }

    pub fn call(name: impl Into<String>, arguments: impl IntoIterator<Item = Code>) -> Self {
        Self::Call(name.into(), arguments.into_iter().collect())
    }

    fn flat(&self) -> String {
        let flat = |codes: &[Code]| codes.iter().map(Code::flat).collect::<Vec<_>>().join(", ");
        match self {
            Self::Atom(text) => text.clone(),
            Self::Call(name, arguments) => format!("{name}({})", flat(arguments)),
            Self::Cases(cases) => flat(cases),
        }
    }

    /// The text where `indent` columns stand before its line, `before` before it and `after` behind it.
    fn laid_out(&self, indent: usize, before: usize, after: usize) -> String {
        let flat = self.flat();
        if before + flat.len() + after <= WIDTH {
            return flat;
        }
        let (mut text, arguments) = match self {
            Self::Atom(_) => return flat,
            Self::Call(name, arguments) => (format!("{name}(\n"), arguments),
            Self::Cases(cases) => {
                let names: Vec<String> = cases.iter().map(Code::flat).collect();
                return names.join(&format!(",\n{:1$}", "", indent + 5));
            }
        };
        for argument in arguments {
            let laid_out = argument.laid_out(indent + 4, indent + 4, 1);
            writeln!(text, "{:1$}{laid_out},", "", indent + 4).expect("a String takes all text");
        }
        write!(text, "{:1$})", "", indent).expect("a String takes all text");
        text
    }
}

impl CodeLines {
    pub fn push(&mut self, line: impl Into<String>) {
        self.0.push(line.into());
    }

    pub fn extend(&mut self, lines: CodeLines) {
        self.0.extend(lines.0);
    }

    /// `before code after`, `indent` columns in, broken where it is too long.
    pub fn statement(&mut self, indent: usize, before: &str, code: &Code, after: &str) {
        let text = code.laid_out(indent, indent + before.len(), after.len());
        let whole = format!("{:indent$}{before}{text}{after}", "");
        self.0.extend(whole.lines().map(str::to_owned));
    }

    /// `case selectors: { before code; }` of a switch in a function; over several lines where it is too long.
    pub fn case(&mut self, selectors: &Code, before: &str, code: &Code) {
        let flat = format!("        case {}: {{ {before}{}; }}", selectors.flat(), code.flat());
        if flat.len() <= WIDTH {
            return self.push(flat);
        }
        self.statement(8, "case ", selectors, ": {");
        self.statement(12, before, code, ";");
        self.push("        }");
    }

    /// `fn head { return code; }`, over three lines and more.
    pub fn function(&mut self, head: &str, code: &Code) {
        self.push(format!("fn {head} {{"));
        self.statement(4, "return ", code, ";");
        self.push("}");
    }

    /// `before a && b after`, `indent` columns in, one term a line where it is too long.
    pub fn chain(&mut self, indent: usize, before: &str, operator: &str, terms: &[String], after: &str) {
        let flat = format!("{:indent$}{before}{}{after}", "", terms.join(&format!(" {operator} ")));
        if flat.len() <= WIDTH {
            return self.push(flat);
        }
        let broken = terms.join(&format!("\n{:1$}{operator} ", "", indent + 4));
        self.0.extend(format!("{:indent$}{before}{broken}{after}", "").lines().map(str::to_owned));
    }

    /// The text, each line with its end.
    pub fn finish(self) -> String {
        self.0.into_iter().map(|line| line + "\n").collect()
    }
}

/// `text` without what ends a line of WGSL, cut where it is too long.
pub fn one_line(text: &str) -> String {
    let ends_line = |c: char| c.is_control() || matches!(c, '\u{2028}' | '\u{2029}');
    let line: Vec<char> = text.chars().map(|c| if ends_line(c) { ' ' } else { c }).collect();
    match line.len() <= WIDTH {
        true => line.into_iter().collect(),
        false => line.into_iter().take(WIDTH - 1).chain(['…']).collect(),
    }
}

/// Names after `head`, over as many comment lines as they need; nothing where there are none.
pub fn list(head: &str, names: &[&str]) -> CodeLines {
    let mut lines = CodeLines::default();
    let mut line = head.to_owned();
    for (i, name) in names.iter().enumerate() {
        let end = if i + 1 < names.len() { ", " } else { "" };
        if line.len() + name.len() + end.len() > WIDTH && line.len() > head.len() {
            lines.push(one_line(line.trim_end()));
            line = format!("{:1$}", "//", head.len());
        }
        line += name;
        line += end;
    }
    if !names.is_empty() {
        lines.push(one_line(line.trim_end()));
    }
    lines
}
