//! Strings in the author's style.

use std::fmt::Write;

/// `text` as a string with its quotes.
pub fn quote(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            '\n' => quoted.push_str("\\n"),
            '\r' => quoted.push_str("\\r"),
            '\t' => quoted.push_str("\\t"),
            c if c.is_control() => write!(quoted, "\\u{{{:x}}}", u32::from(c)).expect("a string takes all"),
            c => quoted.push(c),
        }
    }
    quoted.push('"');
    quoted
}

/// `text` in place of the string `old`: raw where that is.
pub fn requote(old: &str, text: &str) -> String {
    let hashes = old.strip_prefix('r').map(|rest| rest.len() - rest.trim_start_matches('#').len());
    match hashes.map(|count| "#".repeat(count)) {
        // RON reads any sign in a raw string as it is, but line ends as the file has them.
        Some(hashes) if !text.contains(&format!("\"{hashes}")) && !text.contains(['\n', '\r']) => {
            format!("r{hashes}\"{text}\"{hashes}")
        }
        _ => quote(text),
    }
}
