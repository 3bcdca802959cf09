//! Exports: each scene in each language, judged by those who read it; drawn without raytoy; the heads of two.

mod bodies;
mod files;
mod host;
mod tint;
mod validators;

use crate::common;
use crate::{device, draw};
use std::process::{Command, Stdio};

use crate::common::{check_text, expect_compiled, expect_none, good_scenes, outcome, outcome_of};
use naga::BinaryOperator;
use naga::Expression::Binary;
use naga::valid::{Capabilities, ValidationFlags, Validator};
use raytoy::export::{Export, ExportError, Language, export};
use raytoy::frame::View;
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;
use raytoy::{Compiled, Outcome};

const SCENE: &str = "tests/cases/export/stands_alone.ron";

/// An image and a model.
const WITH_FILES: &str = "tests/cases/export/files_beside_it.ron";

/// The entry points of shaders/standalone.wgsl.
const ENTRIES: [&str; 4] = ["coverPicture", "drawPicture", "drawLight", "showSamples"];

#[test]
fn each_scene_stands_alone_in_each_language() {
    expect_none(good_scenes().iter().flat_map(|name| {
        let compiled = expect_compiled(outcome(name, Mode::Baked));
        let wrong = Language::ALL.map(|(language, wanted)| {
            let told = |why: String| format!("{name} as {language}: {why}");
            let cannot = takes_files(&compiled) && wanted == Language::Glsl;
            match export(&compiled, wanted) {
                Err(ExportError::NeedsFiles(files)) if cannot && !files.is_empty() => None,
                Err(error) => Some(told(error.to_string())),
                Ok(_) if cannot => Some(told("Shadertoy has no files".into())),
                Ok(Export { texels, .. }) if texels.is_empty() == takes_files(&compiled) => {
                    Some(told(format!("{} bytes of texels are beside it", texels.len())))
                }
                Ok(Export { shader, .. }) => judge(wanted, &shader).err().map(told),
            }
        });
        wrong.into_iter().flatten().collect::<Vec<_>>()
    }));
}

/// naga takes some text that Chrome refuses, such as `a < b & c` without brackets.
#[test]
fn chrome_takes_each_text() {
    let texts = good_scenes().into_iter().flat_map(|name| {
        let [baked, live] = [Mode::Baked, Mode::Live].map(|mode| expect_compiled(outcome(&name, mode)));
        let alone = text_of(&baked, Language::Wgsl);
        let plain = baked.plain().expect("naga took the whole").source.text();
        let probed = baked.probed().expect("no scene has a name of the probe's").source.text();
        let texts = [("export", alone), ("plain", plain), ("probe", probed), ("live", live.source.text())];
        texts.map(|(what, text)| (format!("{name}, {what}"), text))
    });
    let (names, texts): (Vec<String>, Vec<String>) = texts.unzip();
    let Some(objections) = tint::objections(&texts) else { return };
    let refused = names.iter().zip(&objections).filter(|(_, objection)| !objection.is_empty());
    expect_none(refused.map(|(name, objection)| format!("{name}: {objection}")));
    let unclear = "fn f(a: i32, b: i32, c: bool) -> bool { return a < b & c; }".to_owned();
    let told = tint::objections(&[unclear]).expect("it was there before").remove(0);
    assert!(told.contains("requires parenthes"), "Tint is awake: {told}");
}

/// What it refuses has a place in the author's file.
#[test]
fn what_check_takes_every_command_takes() {
    let mut texts = vec![];
    let mut problems = vec![];
    for line in bodies::BODIES.lines().filter(|line| !line.is_empty()) {
        let (outside, body) = line.split_once(" | ").unwrap_or(("", line));
        let texture = format!("{outside}\n/// A wave.\nfn wave(at: Surface) -> f32 {{ {body} }}\n");
        let sources = Sources::in_memory().with("a.ron", "(objects: [Sphere(material: (color: Wave()))])");
        let sources = sources.with("textures/wave.wgsl", &texture);
        let Outcome { compiled, report } = raytoy::compile(&sources, "a.ron".as_ref(), Mode::Baked, None);
        let Some(compiled) = compiled else {
            let place = report.diagnostics[0].labels.first().map(|(place, _)| place.file.as_str());
            if place != Some("textures/wave.wgsl") {
                problems.push(format!("{line}: it is not refused at its place: {report}"));
            }
            continue;
        };
        for (language, wanted) in Language::ALL {
            match export(&compiled, wanted) {
                // Shadertoy lacks some of WGSL, and that is told.
                Err(_) if wanted == Language::Glsl => {}
                Err(error) => problems.push(format!("{line}: as {language}: {error}")),
                Ok(Export { shader, .. }) => {
                    problems.extend(judge(wanted, &shader).err().map(|why| format!("{line}: {why}")));
                }
            }
        }
        match compiled.probed() {
            Err(problem) => problems.push(format!("{line}: as a probe: {problem:?}")),
            Ok(probed) => texts.push((line, probed.source.text())),
        }
    }
    let (names, texts): (Vec<&str>, Vec<String>) = texts.into_iter().unzip();
    let refused = tint::objections(&texts).unwrap_or_default();
    problems.extend(
        names.iter().zip(refused).filter(|(_, why)| !why.is_empty()).map(|(n, why)| format!("{n}: {why}")),
    );
    expect_none(problems);
}

/// `%` of negative numbers is undefined there.
#[test]
fn what_ships_leaves_no_signed_remainder_to_glsl() {
    expect_none(good_scenes().iter().filter_map(|name| {
        let compiled = expect_compiled(outcome(name, Mode::Baked));
        let module = compiled.module.naga();
        let is_signed = |(handle, function): (naga::Handle<naga::Function>, &naga::Function)| {
            let info = &compiled.module.info()[handle];
            let signed = function.expressions.iter().any(|(expression, what)| {
                let kind = info[expression].ty.inner_with(&module.types).scalar_kind();
                let is_remainder = matches!(what, Binary { op: BinaryOperator::Modulo, .. });
                is_remainder && kind == Some(naga::ScalarKind::Sint)
            });
            signed.then(|| function.name.clone().unwrap_or_default())
        };
        module.functions.iter().find_map(is_signed).map(|function| format!("{name}: `{function}` has one"))
    }));
}

/// The gallery, and what no scene of it has: glslang is too slow at HLSL to read all cases.
#[test]
fn the_gallery_is_valid_hlsl() {
    let scenes = common::scenes("scenes").into_iter().chain([WITH_FILES.to_owned()]);
    expect_none(scenes.filter_map(|name| {
        let compiled = expect_compiled(outcome(&name, Mode::Baked));
        let judged = validators::direct3d_accepts(&text_of(&compiled, Language::Hlsl));
        judged.err().map(|why| format!("{name}: {why}"))
    }));
}

#[test]
fn the_same_scene_gives_the_same_bytes() {
    for name in common::scenes("scenes") {
        for (language, wanted) in Language::ALL {
            let run = || export(&expect_compiled(outcome(&name, Mode::Baked)), wanted);
            assert!(run() == run(), "{name} as {language}");
        }
    }
}

/// Numbers are literals, however the scene was compiled.
#[test]
fn a_live_scene_is_exported_as_a_baked_one() {
    let [live, baked] = [Mode::Live, Mode::Baked].map(|mode| expect_compiled(outcome(SCENE, mode)));
    assert!(export(&live, Language::Wgsl) == export(&baked, Language::Wgsl));
}

/// The head, which files of raytoy's follow, and each line that is in none of them.
#[test]
fn a_standalone_text_is_its_head_the_scene_and_files_of_raytoys() {
    let compiled = expect_compiled(outcome(SCENE, Mode::Baked));
    let text = text_of(&compiled, Language::Wgsl);
    let (head, rest) = text.split_once("\n\n").expect("an empty line is under the head");
    let mut shipped: Vec<(String, String)> = ["shaders", "textures"]
        .iter()
        .flat_map(|folder| common::files(folder, "wgsl"))
        .map(|file| (common::read(&file), file))
        .collect();
    // None is the start of a longer one that follows.
    shipped.sort_by_key(|(section, _)| std::cmp::Reverse(section.len()));
    let (_, scene) = compiled.source.generated().split_once("\n\n").expect("it has a head of its own");
    let mut rest = rest.strip_prefix(scene).expect("the scene's text is first");
    let mut golden = format!("{head}\n\n(stands_alone.wgsl, below its head)\n");
    while !rest.is_empty() {
        if let Some((section, file)) = shipped.iter().find(|(section, _)| rest.starts_with(section)) {
            golden += &format!("({file})\n");
            rest = rest[section.len()..].trim_start_matches('\n');
        } else {
            let (line, below) = rest.split_once('\n').unwrap_or((rest, ""));
            golden += &format!("{line}\n");
            rest = below;
        }
    }
    expect_none(check_text("tests/cases/export/stands_alone.standalone.txt", &golden).err());
}

/// The head, and the two functions that its reader looks for; naga translates the rest, and others judge that.
#[test]
fn a_shadertoy_is_its_head_a_function_of_numbers_and_one_for_the_host() {
    let text = text_of(&expect_compiled(outcome(SCENE, Mode::Baked)), Language::Glsl);
    let (head, rest) = text.split_once("\n\n").expect("an empty line is under the head");
    let function = |begins: &str| {
        let from = rest.find(begins).unwrap_or_else(|| panic!("there is no {begins}"));
        let length = rest[from..].find("\n}\n").expect("it ends") + 3;
        &rest[from..from + length]
    };
    let functions = ["void setScene() {", "void mainImage("].map(function).join("\n");
    let golden = format!("{head}\n\n{functions}");
    expect_none(check_text("tests/cases/export/stands_alone.glsl.txt", &golden).err());
}

#[test]
fn a_plain_host_draws_what_raytoy_draws() {
    let Some(gpu) = device::gpu() else { return };
    let named = ["tests/cases/patterns/image.ron", WITH_FILES].map(str::to_owned);
    let scenes = common::scenes("scenes").into_iter().chain(named);
    let scenes = scenes.map(|name| expect_compiled(outcome(&name, Mode::Baked)));
    let shown = [
        "exposure: -1, tone_map: Reinhard",
        "exposure: 1.5, tone_map: Agx",
        "tone_map: Aces, transfer: Linear",
    ];
    let shown = shown.into_iter().chain(["transfer: Gamma(1.8), shadows: false, texture_filter: false"]);
    let with_settings = shown.map(|settings| {
        let text = common::read(SCENE).replace("exposure: 0.5, tone_map: Aces", settings);
        expect_compiled(outcome_of(settings, &text, Mode::Baked))
    });
    expect_none(scenes.chain(with_settings).filter_map(|compiled| {
        let size = [96, 54];
        let (text, texels) = standalone(&compiled);
        let drawn = host::one_sample(gpu, &text, &texels, size);
        let raytoy = draw::picture(gpu, &compiled, size, View::Color).rgba;
        host::difference(&drawn, &raytoy).map(|why| format!("{}: {why}", compiled.scene.name))
    }));
}

#[test]
fn a_plain_host_gathers_samples_as_raytoy_does() {
    let Some(gpu) = device::gpu() else { return };
    for name in [SCENE, WITH_FILES] {
        let compiled = expect_compiled(outcome(name, Mode::Baked));
        let (size, samples) = ([96, 54], 5);
        let (text, texels) = standalone(&compiled);
        let drawn = host::many_samples(gpu, &text, &texels, size, samples);
        let moment = raytoy::frame::Moment::of(&compiled.scene);
        let raytoy =
            raytoy::gpu::render(gpu, &compiled, &moment, size, samples, &mut |_| ()).expect("it draws");
        assert_eq!(host::difference(&drawn, &raytoy.rgba), None, "{name}");
        let one = host::one_sample(gpu, &text, &texels, size);
        assert_ne!(host::difference(&one, &raytoy.rgba), None, "{name}: edges of many samples are smooth");
    }
}

#[test]
fn what_a_texture_cannot_do_on_its_own_is_told() {
    let error = |name: &str, body: &str, language| {
        let scene =
            format!("(objects: [Sphere(material: (color: {}()))])", name[..1].to_uppercase() + &name[1..]);
        let texture = format!("/// A texture.\nfn {name}(at: Surface) -> f32 {{ {body} }}\n");
        let sources = Sources::in_memory().with("a.ron", &scene);
        let sources = sources.with(format!("textures/{name}.wgsl"), &texture);
        let compiled = expect_compiled(raytoy::compile(&sources, "a.ron".as_ref(), Mode::Baked, None));
        export(&compiled, language).expect_err("it is refused").to_string()
    };
    assert_eq!(
        error("waves", "return f32(countOneBits(u32(at.uv.x)));", Language::Glsl),
        "the scene cannot be exported: Shadertoy has no `countOneBits`, which `waves` uses"
    );
    let unknown = "return f32(select(vec2u(1u), vec2u(2u), at.uv > vec2f(0.0)).x);";
    assert_eq!(
        error("waves", unknown, Language::Glsl),
        "the scene cannot be exported: Shadertoy has no `select` for vectors of whole numbers, which `waves` \
         uses; write one for each component"
    );
}

#[test]
fn a_shadertoy_with_files_is_refused() {
    let told = generate(&["scenes/models.ron", "--lang", "glsl"]);
    assert_eq!(told.status.code(), Some(2));
    assert_eq!(
        String::from_utf8_lossy(&told.stderr),
        "raytoy: Shadertoy cannot read images and models from files: remove everything that uses \
         `scenes/models/knot.obj`, `scenes/models/gem.glb`\n"
    );
}

#[test]
fn the_head_tells_what_to_bind_in_each_language() {
    let compiled = expect_compiled(outcome(WITH_FILES, Mode::Baked));
    let tables = [
        (Language::Wgsl, ["@group(1) @binding(0)", "@group(1) @binding(1)", "@group(1) @binding(15)"]),
        (Language::Msl, ["[[sampler(0)]]", "[[texture(1)]]", "[[texture(15)]]"]),
        (Language::Hlsl, ["register(s0, space1)", "register(t1, space1)", "register(t15, space1)"]),
    ];
    for (language, [sampler, image, models]) in tables {
        let table = format!(
            "
// Images and models are textures, for the fragment entry too. Their texels are in the file beside this one
// that has its name and .texels behind, 65536 bytes, little-endian. There each texture has its levels, the
// largest first, each other one half as wide and as high as the one before it, rounded down, but at least 1;
// and each level its rows, from the top, without gaps.
//
//   bound to                type             name          what goes there
//   {sampler:22}  sampler          image_sampler  linear in a level and between levels; repeats to all sides
//   {image:22}  texture_2d<f32>  image0        rgba16float, 64x48, 7 levels from byte 0: tests/cases/patterns/photo.jpg
//   {models:22}  texture_2d<u32>  models        rgba32uint, 2048x1, 1 level from byte 32768: scenes/models/gem.glb
//
"
        );
        let text = text_of(&compiled, language);
        assert!(text.contains(&table), "{language:?}:\n{}\nand not\n{table}", &text[..4000]);
    }
}

#[test]
fn what_nothing_uses_is_not_beside_it() {
    let text =
        r#"(textures: {"unused": Image(file: "tests/cases/patterns/photo.jpg")}, objects: [Sphere()])"#;
    let sources = Sources::on_disk(&common::root()).with("a.ron", text);
    let compiled = expect_compiled(raytoy::compile(&sources, "a.ron".as_ref(), Mode::Baked, None));
    assert!(takes_files(&compiled));
    for (language, wanted) in Language::ALL {
        let Export { shader, texels } =
            export(&compiled, wanted).unwrap_or_else(|e| panic!("{language}: {e}"));
        assert!(texels.is_empty(), "{language}");
        assert!(files::table(&String::from_utf8_lossy(&shader)).is_empty(), "{language}");
    }
}

#[test]
fn the_command_writes_texels_beside_the_shader() {
    let compiled = expect_compiled(outcome(WITH_FILES, Mode::Baked));
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (language, wanted) in Language::ALL.into_iter().filter(|(_, wanted)| *wanted != Language::Glsl) {
        let file = folder.path().join(format!("scene.{language}"));
        let beside = folder.path().join(format!("scene.{language}.texels"));
        let told = generate(&[WITH_FILES, "--lang", language, "-o", &file.to_string_lossy()]);
        let [shader, texels] = [&file, &beside].map(|file| std::fs::read(file).expect("the file is there"));
        let size = texels.len();
        assert!(export(&compiled, wanted) == Ok(Export { shader, texels }), "{language}");
        assert_eq!(
            String::from_utf8_lossy(&told.stderr),
            format!("{}: {size} bytes, the images and models of {}\n", beside.display(), file.display())
        );
    }
    for call in [&[WITH_FILES, "--standalone"][..], &[WITH_FILES, "--standalone", "-o", "/dev/null"]] {
        let told = generate(call);
        assert_eq!(told.status.code(), Some(2), "{call:?}");
        assert!(told.stdout.is_empty(), "{call:?}");
        assert_eq!(
            String::from_utf8_lossy(&told.stderr),
            "raytoy: the images and models of the scene go to a second file beside the shader; name a file for \
             the shader, as in `-o scene.wgsl`\n"
        );
    }
}

#[test]
fn the_command_writes_what_is_asked_for() {
    let standalone = generate(&[SCENE, "--standalone"]);
    let compiled = expect_compiled(outcome(SCENE, Mode::Baked));
    assert_eq!(String::from_utf8_lossy(&standalone.stdout), text_of(&compiled, Language::Wgsl));
    assert_eq!(standalone.stdout, generate(&[SCENE, "--lang", "wgsl"]).stdout);
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("scene.spv");
    let written = generate(&[SCENE, "--lang", "spirv", "-o", &file.to_string_lossy()]);
    assert!(written.status.success() && written.stdout.is_empty());
    let bytes = std::fs::read(&file).expect("the file is there");
    assert!(export(&compiled, Language::Spirv) == Ok(Export { shader: bytes, texels: vec![] }));
    for call in [&[SCENE, "--lang", "basic"][..], &[SCENE, "--standalone", "--live"]] {
        assert_eq!(generate(call).status.code(), Some(2), "{call:?}");
    }
}

/// `script` runs a command on a terminal.
#[test]
#[cfg(target_os = "linux")]
fn bytes_do_not_go_to_a_terminal() {
    let line = format!("'{}' generate {SCENE} --lang spirv", env!("CARGO_BIN_EXE_raytoy"));
    let mut script = Command::new("script");
    let script = script.args(["-qec", &line, "/dev/null"]).current_dir(common::root()).stdin(Stdio::null());
    let Ok(told) = script.output() else { return validators::skip("there is no `script`") };
    assert_eq!(told.status.code(), Some(2));
    let told = String::from_utf8_lossy(&told.stdout).into_owned();
    assert_eq!(
        told.trim_end(),
        "raytoy: SPIR-V is binary and cannot be shown in a terminal; name a file, as in `-o scene.spv`"
    );
}

/// What is wrong with an export.
fn judge(language: Language, bytes: &[u8]) -> Result<(), String> {
    let text = String::from_utf8_lossy(bytes);
    let lacks = |parts: &[&str]| match parts.iter().find(|part| !text.contains(**part)) {
        Some(part) => Err(format!("it lacks `{part}`")),
        None => Ok(()),
    };
    let code: Vec<&str> = text.lines().filter(|line| !line.starts_with("//")).collect();
    let is_bound = |place: &str| code.iter().any(|line| line.contains(place));
    if let Some(row) = files::table(&text).iter().find(|row| !is_bound(row.place)) {
        return Err(format!("nothing is bound to {}", row.place));
    }
    match language {
        Language::Wgsl => {
            lacks(&ENTRIES.map(|entry| format!("fn {entry}(")).each_ref().map(String::as_str))?;
            if text.contains("accumulated") || text.contains("VIEW_") {
                return Err("raytoy's own entry point or views are in it".into());
            }
            naga_accepts(&text)
        }
        Language::Glsl => {
            let foreign = ["#", "uniform ", "layout(", "void main(", "gl_"];
            if let Some(found) = foreign.iter().find(|word| code.iter().any(|line| line.contains(**word))) {
                return Err(format!("Shadertoy does not take `{found}`"));
            }
            lacks(&["\nvoid mainImage(out vec4 fragColor, in vec2 fragCoord) {\n"])?;
            validators::shadertoy_accepts(&text)
        }
        Language::Spirv => validators::vulkan_accepts(bytes),
        Language::Msl => {
            lacks(&ENTRIES.map(|entry| format!(" {entry}(")).each_ref().map(String::as_str))?;
            lacks(&["[[buffer(0)]]", "samples [[texture(0)]]"])
        }
        Language::Hlsl => {
            lacks(&ENTRIES.map(|entry| format!(" {entry}(")).each_ref().map(String::as_str))?;
            lacks(&[" : register(b0)", "samples : register(t1)"])?;
            match text.contains("nagaSamplerHeap") {
                true => Err("its sampler is in a heap".into()),
                false => Ok(()),
            }
        }
    }
}

fn naga_accepts(text: &str) -> Result<(), String> {
    raytoy::on_deep_stack(|| {
        let module = naga::front::wgsl::parse_str(text).map_err(|error| error.emit_to_string(text))?;
        let mut validator = Validator::new(ValidationFlags::all(), Capabilities::default());
        validator.validate(&module).map(|_| ()).map_err(|error| error.emit_to_string(text))
    })
}

fn takes_files(compiled: &Compiled) -> bool {
    !compiled.scene.images.is_empty() || !compiled.scene.models.is_empty()
}

fn text_of(compiled: &Compiled, language: Language) -> String {
    let export =
        export(compiled, language).unwrap_or_else(|error| panic!("{}: {error}", compiled.scene.name));
    String::from_utf8(export.shader).expect("it is text")
}

/// The WGSL, and the texels beside it.
fn standalone(compiled: &Compiled) -> (String, Vec<u8>) {
    let export = export(compiled, Language::Wgsl).expect("it stands alone");
    (String::from_utf8(export.shader).expect("it is text"), export.texels)
}

fn generate(arguments: &[&str]) -> std::process::Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_raytoy"));
    command.arg("generate").args(arguments).current_dir(common::root()).stdin(Stdio::null());
    command.output().expect("raytoy runs")
}
