//! `raytoy check`: all mistakes of scenes and snippets, in both number modes.

use std::path::Path;

use super::args::CheckOptions;
use super::{Failure, Result, print_report, sources_for};
use crate::compile::{Outcome, compile};
use crate::diagnostic::Report;
use crate::library::{Family, Library, knot, name_of, sample};
use crate::sources::{Disk, Sources};
use crate::suite::{Walk, is_settings, kind_of};
use crate::wgsl::Mode;

pub fn run(options: &CheckOptions) -> Result {
    let disk = super::disk(&options.root, &options.paths)?;
    let mut walk = Walk::default();
    let mut files = vec![];
    for path in &options.paths {
        if path.is_dir() {
            let found = walk.files_below(path).map_err(Failure::Call)?;
            files.extend(found.into_iter().filter(|file| kind_of(file).is_some()));
        } else if is_settings(path) {
            // `raytoy test` reads them.
            continue;
        } else if path == Path::new("-") || path.exists() {
            files.push(path.clone());
        } else {
            return Err(Failure::Call(format!("there is no file or folder `{}`", path.display())));
        }
    }
    let mut wrong = 0;
    for file in &files {
        let outcome = check(&disk, file)?;
        print_report(&outcome.report);
        wrong += usize::from(outcome.compiled.is_none());
    }
    match (files.len(), wrong) {
        (0, _) => Err(Failure::Call("the folders contain no .ron or .wgsl files".into())),
        (1, 0) => {
            eprintln!("{}: no mistakes", files[0].display());
            Ok(())
        }
        (n, 0) => {
            eprintln!("{n} files checked, no mistakes");
            Ok(())
        }
        (n, wrong) => {
            eprintln!("{wrong} of {n} files have mistakes");
            Err(Failure::Scene)
        }
    }
}

fn check(disk: &Disk, file: &Path) -> Result<Outcome> {
    let sources = sources_for(disk, file)?;
    if file.extension().is_some_and(|e| e == "wgsl") {
        return check_snippet(sources, file);
    }
    let baked = compile(&sources, file, Mode::Baked, None);
    // The live text differs only in how it prints numbers, so it has nothing to add to a scene's mistakes.
    let live = baked.compiled.as_ref().map(|_| compile(&sources, file, Mode::Live, None));
    Ok(live.filter(|outcome| outcome.compiled.is_none()).unwrap_or(baked))
}

/// Compiles the smallest scene that uses the snippet.
fn check_snippet(sources: Sources, file: &Path) -> Result<Outcome> {
    let family =
        if file.parent().is_some_and(|f| f.ends_with("shapes")) { Family::Shape } else { Family::Texture };
    let stem = file.file_stem().unwrap_or_default().to_string_lossy();
    let name = name_of(&stem);
    let folder = file.parent().and_then(Path::parent).unwrap_or(Path::new(""));
    let library = Library::new(&sources, folder);
    let function = match library.find(family, &name) {
        Ok(function) => function,
        Err(problems) => {
            let report = Report { diagnostics: problems.unwrap_or_default(), texts: sources.texts() };
            return Ok(Outcome { compiled: None, report });
        }
    };
    let call = sample::call(&function);
    let object = match function.kind {
        crate::library::Kind::Shape => call,
        crate::library::Kind::Mapping => format!("Sphere(material: (color: Noise(at: {call})))"),
        _ => format!("Sphere(material: (color: {call}))"),
    };
    let scene = folder.join("-");
    let sources = sources.with(&scene, &format!("(objects: [{object}])"));
    let sources = sources.with(folder.join(knot::FILE), &knot::obj());
    Ok(compile(&sources, &scene, Mode::Baked, None))
}
