//! The files of shaders/ that modules are made of: each is known to the table, and no module has one twice.

use crate::common::{expect_compiled, expect_none, files, outcome};
use raytoy::ir::Measure;
use raytoy::wgsl::{Host, Mode, Target, generate};

#[test]
fn the_table_names_each_file_of_shaders() {
    let shipped = files("shaders", "wgsl").into_iter().filter(|file| !file.starts_with("shaders/shapes/"));
    let mut shipped: Vec<String> = shipped.collect();
    let mut known: Vec<String> = raytoy::wgsl::files().map(str::to_owned).collect();
    shipped.sort();
    known.sort();
    assert_eq!(known, shipped, "src/wgsl/sections.rs says of each file which modules have it");
}

#[test]
fn a_target_decides_on_entry_points() {
    let scene = expect_compiled(outcome("scenes/glass.ron", Mode::Live)).scene;
    let measured = raytoy::ir::Scene { measure: Some(Measure::Distance), ..scene.clone() };
    let probe = Target { probe: true, ..Target::raytoy(Mode::Baked) };
    let shadertoy = Target::without_raytoy(Host::Shadertoy { settings: vec![] });
    let cases = [
        (&scene, Target::raytoy(Mode::Live), "luminance main cover view number_color unmeasured"),
        (&measured, Target::raytoy(Mode::Live), "luminance main cover view number_color"),
        (&measured, Target::plain(), "main cover plain unviewed"),
        (&scene, probe, "luminance main cover view number_color unmeasured probe"),
        (&measured, Target::without_raytoy(Host::Any), "standalone cover unviewed tone"),
        (&scene, shadertoy, "shadertoy unviewed tone integers integer_vectors"),
    ];
    let core = names(&generate(&scene, &Target::plain()));
    let core: Vec<&String> =
        core.iter().filter(|name| !"main cover plain unviewed".contains(*name)).collect();
    expect_none(cases.iter().filter_map(|(scene, target, expected)| {
        let names = names(&generate(scene, target));
        let own: Vec<&str> = names.iter().filter(|name| !core.contains(name)).map(String::as_str).collect();
        (own.join(" ") != *expected).then(|| format!("{target:?} has {own:?} instead of {expected}"))
    }));
}

/// The stems of the files of shaders/ that a module has.
fn names(source: &raytoy::wgsl::Source) -> Vec<String> {
    let stem = |name: &str| Some(name.strip_prefix("shaders/")?.strip_suffix(".wgsl")?.to_owned());
    source.sections.iter().filter_map(|section| stem(&section.name)).collect()
}
