//! What shaders declare is what the table of bindings says: group, number, name, content and stages.

use crate::common::{expect_compiled, expect_none, outcome, read};
use naga::{
    AddressSpace, GlobalVariable, ImageClass, Module, ScalarKind, ShaderStage, StorageAccess, TypeInner,
};
use raytoy::bindings::{ALL, Binding, Content, IMAGES, MODELS, Stage};
use raytoy::export::{Language, export};
use raytoy::ir::Scene;
use raytoy::wgsl::Mode;

/// Scenes that together have images and models.
const SCENES: [&str; 3] =
    ["scenes/models.ron", "tests/cases/patterns/image.ron", "tests/cases/export/files_beside_it.ron"];

#[test]
fn shaders_declare_what_the_table_says() {
    let mut seen: Vec<&str> = vec![];
    let mut problems = vec![];
    for (name, module) in modules() {
        for (_, variable) in module.global_variables.iter() {
            if variable.binding.is_none() {
                continue;
            }
            let declared = variable.name.as_deref().unwrap_or_default();
            match row_of(declared) {
                Some(row) => {
                    seen.push(row.name);
                    problems.extend(
                        difference(&module, variable, row).map(|why| format!("{name}: {declared} {why}")),
                    );
                }
                None => problems.push(format!("{name}: {declared} is in no row")),
            }
        }
    }
    problems.extend(
        ALL.iter().filter(|row| !seen.contains(&row.name)).map(|row| format!("{} is nowhere", row.name)),
    );
    expect_none(problems);
}

#[test]
fn entry_points_use_them_in_the_stages_of_the_table() {
    expect_none(modules().into_iter().flat_map(|(name, module)| {
        let flags = naga::valid::ValidationFlags::all();
        let info = naga::valid::Validator::new(flags, Default::default()).validate(&module);
        let info = info.unwrap_or_else(|error| panic!("{name}: {error:?}"));
        let mut problems = vec![];
        for (index, entry) in module.entry_points.iter().enumerate() {
            for (handle, variable) in module.global_variables.iter() {
                let is_used = !info.get_entry_point(index)[handle].is_empty();
                let row = variable.name.as_deref().filter(|_| variable.binding.is_some()).and_then(row_of);
                let Some(row) = row.filter(|_| is_used) else { continue };
                let stage = match entry.stage {
                    ShaderStage::Vertex => Stage::Vertex,
                    ShaderStage::Fragment => Stage::Fragment,
                    _ => Stage::Compute,
                };
                if !row.stages.contains(&stage) {
                    problems.push(format!("{name}: {} uses {}", entry.name, row.name));
                }
            }
        }
        problems
    }));
}

#[test]
fn images_end_where_models_begin() {
    assert_eq!(Binding::image(Scene::MAX_IMAGES as u32).number, MODELS.number);
}

/// Modules of scenes for all hosts that bind something, and files that are apart.
fn modules() -> Vec<(String, Module)> {
    let parsed = |name: &str, text: &str| {
        let module = naga::front::wgsl::parse_str(text);
        (name.to_owned(), module.unwrap_or_else(|error| panic!("{name}: {}", error.emit_to_string(text))))
    };
    // shaders/guard.wgsl stands on no other file.
    let apart = [
        &["shaders/display.wgsl", "shaders/tone.wgsl"][..],
        &["shaders/lines.wgsl"],
        &["shaders/guard.wgsl"],
    ];
    let apart = apart.map(|files| {
        let text: Vec<String> = files.iter().map(|file| read(file)).collect();
        parsed(files[0], &text.join("\n"))
    });
    let scenes = SCENES.iter().flat_map(|scene| {
        let compiled = expect_compiled(outcome(scene, Mode::Live));
        let probed = compiled.probed().expect("no scene has a name of the probe's").source.text();
        let alone = export(&compiled, Language::Wgsl).expect("it takes all scenes").shader;
        let alone = String::from_utf8(alone).expect("WGSL is text");
        [parsed(scene, &probed), parsed(&format!("{scene}, standalone"), &alone)]
    });
    apart.into_iter().chain(scenes).collect()
}

fn row_of(name: &str) -> Option<Binding> {
    let image = name.strip_prefix(IMAGES.name).and_then(|number| number.parse().ok());
    image.map(Binding::image).or_else(|| ALL.iter().copied().find(|row| row.name == name && *row != IMAGES))
}

/// What a declaration has otherwise than its row.
fn difference(module: &Module, variable: &GlobalVariable, row: Binding) -> Option<String> {
    let place = variable.binding?;
    let sampled = |class: ImageClass| match class {
        ImageClass::Sampled { kind: ScalarKind::Float, multi: false } => {
            vec![Content::Texels, Content::Image]
        }
        ImageClass::Sampled { kind: ScalarKind::Uint, multi: false } => vec![Content::Words],
        _ => vec![],
    };
    let contents = match (variable.space, &module.types[variable.ty].inner) {
        (AddressSpace::Uniform, _) => vec![Content::Uniform],
        (AddressSpace::Storage { access }, _) => {
            vec![Content::Storage { is_writable: access.contains(StorageAccess::STORE) }]
        }
        (AddressSpace::Handle, TypeInner::Sampler { comparison: false }) => vec![Content::Sampler],
        (AddressSpace::Handle, TypeInner::Image { class, .. }) => sampled(*class),
        _ => vec![],
    };
    let is_there = (place.group, place.binding) == (row.group, row.number);
    (!is_there || !contents.contains(&row.content))
        .then(|| format!("is {contents:?} at {place:?}, and {row:?} is said"))
}
