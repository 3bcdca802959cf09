//! `raytoy gallery`: a page with a picture of every texture and shape that scenes can name.

use std::fmt::Write;
use std::path::Path;

use super::progress::with_progress;
use super::{Failure, Result, print_report, write_output};
use crate::capture::jpeg;
use crate::compile::compile;
use crate::frame::Moment;
use crate::gpu::{self, AdapterChoice, Gpu};
use crate::library::{Family, Function, Library, Parameter, sample};
use crate::sources::Sources;
use crate::wgsl::Mode;

const SIZE: [u32; 2] = [200, 150];
const SAMPLES: u32 = 8;

pub fn run(folder: &Path) -> Result {
    let here = std::env::current_dir()?;
    let sources = Sources::on_disk(&here);
    let library = Library::new(&sources, &here.join("scenes"));
    let gpu = Gpu::headless(&AdapterChoice::Fastest)?;
    std::fs::create_dir_all(folder)?;
    let mut page = String::from("# What scenes can name\n\nWritten by `raytoy gallery`.\n");
    let mut digests = String::new();
    let mut wrong = 0;
    for (family, title) in [(Family::Texture, "Textures and mappings"), (Family::Shape, "Shapes")] {
        write!(page, "\n## {title}\n\n| | | |\n|---|---|---|\n")?;
        let names = library.names(family);
        with_progress(title, |progress| {
            for (i, name) in names.iter().enumerate() {
                match library.find(family, name) {
                    Ok(function) => {
                        draw(&gpu, &here, &function, folder)?;
                        writeln!(page, "{}", row(&function))?;
                        writeln!(digests, "{:016x} {name}", sample::digest(&function))?;
                    }
                    Err(_) => wrong += 1,
                }
                let _ = progress((i + 1) as f32 / names.len() as f32);
            }
            Ok::<(), Failure>(())
        })?;
    }
    write_output(&folder.join("README.md"), page.as_bytes())?;
    write_output(&folder.join("digests.txt"), digests.as_bytes())?;
    eprintln!("The page is {}.", folder.join("README.md").display());
    if wrong > 0 {
        eprintln!("{wrong} files have mistakes; `raytoy check` reports them");
        return Err(Failure::Scene);
    }
    Ok(())
}

fn draw(gpu: &Gpu, here: &Path, function: &Function, folder: &Path) -> Result {
    let (sources, scene) = sample::shown(function, Sources::on_disk(here), &here.join("scenes"));
    let outcome = compile(&sources, &scene, Mode::Baked, None);
    let Some(compiled) = outcome.compiled else {
        print_report(&outcome.report);
        return Err(Failure::Scene);
    };
    let moment = Moment::of(&compiled.scene);
    let picture = gpu::render(gpu, &compiled, &moment, SIZE, SAMPLES, &mut |_| ())?;
    write_output(&folder.join(format!("{}.jpg", function.name)), &jpeg(&picture)?)
}

fn row(function: &Function) -> String {
    let name = &function.name;
    let parameters: Vec<String> = function.parameters.iter().map(parameter).collect();
    format!(
        "| ![{name}]({name}.jpg) | **{name}**, a {}<br>{} | {} |",
        function.kind.noun(),
        function.caption,
        parameters.join("<br>")
    )
}

fn parameter(parameter: &Parameter) -> String {
    let default = match parameter.default {
        Some(_) => format!(" = {}", parameter.default_text),
        None => String::new(),
    };
    let range = parameter.range.map_or(String::new(), |(low, high)| format!(", {low} to {high}"));
    let choices = match parameter.choices.is_empty() {
        true => String::new(),
        false => format!(" of {}", parameter.choices.join(", ")),
    };
    format!("`{}{default}{choices}{range}`: {}", parameter.name, parameter.doc)
}
