//! `raytoy textures` and `raytoy shapes`: what scenes can name, read from the files that define it.

use std::fmt::Write;

use super::{Failure, Result, print_report, print_result};
use crate::diagnostic::{Diagnostic, Report};
use crate::library::{Family, Function, Kind, Library, Parameter, Type};
use crate::sources::Sources;

/// What no file defines, and how it is written.
const TEXTURE_FORMS: [[&str; 2]; 3] = [
    ["Ramp", r##"Ramp(by: Noise(), stops: [(0, "#000"), (1, "#fff")], interpolation: Smooth)"##],
    ["Triplanar", "Triplanar(of: Brick(), sharpness: 4)"],
    ["Image", r#"Image(file: "photo.png", width: 1, repeat: true, under: "white", channel: Color)"#],
];
const SHAPE_FORMS: [[&str; 2]; 3] = [
    ["Union", "Union(parts: [Box(), Sphere()])"],
    ["Intersection", "Intersection(parts: [Box(), Sphere()])"],
    ["Difference", "Difference(parts: [Box(), Sphere(radius: 1.2)])"],
];

pub fn run(family: Family, name: Option<&str>) -> Result {
    let here = std::env::current_dir()?;
    let sources = Sources::on_disk(&here);
    // As a scene in scenes/ sees it, where there is such a folder.
    let library = Library::new(&sources, &here.join("scenes"));
    match name {
        Some(name) => {
            let function = find(&library, &sources, family, name)?;
            print_result(&details(&function))
        }
        None => print_result(&overview(&library, family)?),
    }
}

fn find(
    library: &Library<'_>,
    sources: &Sources,
    family: Family,
    name: &str,
) -> Result<std::sync::Arc<Function>> {
    library.find(family, name).map_err(|problems| match problems {
        Some(diagnostics) => {
            print_report(&Report { diagnostics, texts: sources.texts() });
            Failure::Scene
        }
        None => {
            let names = library.names(family);
            let unknown = Diagnostic::error(format!("there is no {} `{name}`", family.noun()));
            let problem = unknown.suggest(name, names.iter().map(String::as_str));
            let advice = match problem.help.as_slice() {
                [] => format!("`raytoy {}s` lists them", family.noun()),
                help => help.join("; "),
            };
            Failure::Call(format!("{}; {advice}", problem.message))
        }
    })
}

fn overview(library: &Library<'_>, family: Family) -> Result<String> {
    let mut text = String::new();
    for name in library.names(family) {
        let (kind, caption) = match library.find(family, &name) {
            Ok(function) => (function.kind.noun(), function.caption.clone()),
            Err(_) => ("", "has mistakes: see `raytoy check`".into()),
        };
        let kind = if family == Family::Texture { format!("{kind:<9}") } else { String::new() };
        writeln!(text, "{name:<16} {kind}{caption}").expect("a String takes all text");
    }
    let forms: &[[&str; 2]] = if family == Family::Texture { &TEXTURE_FORMS } else { &SHAPE_FORMS };
    text += "\nBuilt into raytoy:\n";
    for [name, use_] in forms {
        writeln!(text, "{name:<16} {use_}").expect("a String takes all text");
    }
    Ok(text)
}

fn details(function: &Function) -> String {
    let mut text = format!("{}: {}. From {}.\n", function.name, function.caption, function.file);
    for parameter in &function.parameters {
        let default = match &parameter.default {
            Some(_) => format!(" = {}", parameter.default_text),
            None => " (required)".into(),
        };
        writeln!(text, "\n  {}{default}", parameter.name).expect("a String takes all text");
        writeln!(text, "      {}", parameter.doc).expect("a String takes all text");
        writeln!(text, "      {}", takes(function.kind, parameter)).expect("a String takes all text");
    }
    if function.kind != Kind::Shape {
        text += "\n  at\n      a mapping, which moves the point at which the texture is evaluated\n";
    }
    text
}

fn takes(kind: Kind, parameter: &Parameter) -> String {
    let what = match parameter.ty {
        _ if !parameter.choices.is_empty() => format!("one of {}", parameter.choices.join(", ")),
        Type::Vec3 if parameter.is_color => "a color".into(),
        ty => ty.describe().to_owned(),
    };
    let range = parameter.range.map_or(String::new(), |(low, high)| format!(" from {low} to {high}"));
    let varies = kind != Kind::Shape && matches!(parameter.ty, Type::F32 | Type::Vec3);
    let texture = if varies { ", or a texture" } else { "" };
    format!("takes {what}{range}{texture}")
}
