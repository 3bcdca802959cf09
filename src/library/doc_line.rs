//! The doc line of a parameter: its default, its range or choices, and what it does.

use super::{Const, Parameter, Type, parse_color};

/// The rest of the doc line of `wgsl_name`, after the name: ` = default, low to high: text`.
pub fn doc_line(wgsl_name: &str, ty: Type, rest: &str) -> Result<Parameter, String> {
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
    let (default_text, doc) = (default_text.to_owned(), doc.trim().to_owned());
    let (name, wgsl_name) = (wgsl_name.trim_end_matches('_').to_owned(), wgsl_name.to_owned());
    let is_point = false;
    Ok(Parameter {
        name,
        wgsl_name,
        ty,
        default,
        default_text,
        range,
        nonzero,
        is_color,
        is_point,
        choices,
        doc,
    })
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
