//! A WGSL file as a function that scenes can name.
//!
//! In: the text of a file. Out: a [`Function`], or all that breaks the contract.

use std::sync::Arc;

use super::declarations::declarations;
use super::header::Header;
use super::lexer::tokens;
use super::{Family, Function, function, unfit};
use crate::diagnostic::Diagnostic;

/// Reads the file called `file`, whose stem names its function.
///
/// # Errors
/// All that breaks the contract of LANGUAGE.md; errors of WGSL itself are naga's to find.
pub fn read(family: Family, file: &str, text: &Arc<str>) -> Result<Function, Vec<Diagnostic>> {
    let stem = file.rsplit('/').next().unwrap_or(file).trim_end_matches(".wgsl");
    let tokens = tokens(text);
    let declarations = declarations(&tokens);
    let wgsl_name = function::wgsl_name_of(stem);
    let header = Header { family, file, text, wgsl_name, tokens, declarations };
    let mut problems = unfit::problems(&header);
    if !problems.is_empty() {
        return Err(problems);
    }
    problems = header.misnamed_helpers();
    let function = header.function(function::name_of(stem), &mut problems);
    match function {
        Some(function) if problems.is_empty() => Ok(function),
        _ => Err(problems),
    }
}
