//! Exports: each scene in each language, judged by those who read it; drawn without raytoy; two as their goldens say.

mod common;
#[path = "export/host.rs"]
mod host;
#[path = "export/validators.rs"]
mod validators;

use std::path::Path;
use std::process::{Command, Stdio};

use common::{check_text, expect_compiled, expect_none, good_scenes, outcome, outcome_of};
use naga::valid::{Capabilities, ValidationFlags, Validator};
use raytoy::Compiled;
use raytoy::export::{ExportError, Language, export};
use raytoy::gpu::View;
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;

const SCENE: &str = "tests/cases/export/stands_alone.ron";

/// The entry points of shaders/standalone.wgsl.
const ENTRIES: [&str; 4] = ["coverPicture", "drawPicture", "drawLight", "showSamples"];

#[test]
fn each_scene_stands_alone_in_each_language() {
    expect_none(good_scenes().iter().flat_map(|name| {
        let compiled = expect_compiled(outcome(name, Mode::Baked));
        let wrong = Language::ALL.map(|(language, wanted)| {
            let told = |why: String| format!("{name} as {language}: {why}");
            match export(&compiled, wanted) {
                Err(ExportError::NeedsFiles(files)) if takes_files(&compiled) && !files.is_empty() => None,
                Err(error) => Some(told(error.to_string())),
                Ok(_) if takes_files(&compiled) => Some(told("it has no files with it".into())),
                Ok(bytes) => judge(wanted, &bytes).err().map(told),
            }
        });
        wrong.into_iter().flatten().collect::<Vec<_>>()
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

#[test]
fn exports_are_as_their_goldens_say() {
    let compiled = expect_compiled(outcome(SCENE, Mode::Baked));
    let goldens = [(Language::Wgsl, "standalone.wgsl"), (Language::Glsl, "glsl")];
    expect_none(goldens.into_iter().filter_map(|(language, ending)| {
        let golden = Path::new(SCENE).with_extension(ending);
        check_text(&golden.to_string_lossy(), &text_of(&compiled, language)).err()
    }));
}

#[test]
fn a_plain_host_draws_what_raytoy_draws() {
    let Some(gpu) = common::gpu() else { return };
    let scenes =
        common::scenes("scenes").into_iter().map(|name| expect_compiled(outcome(&name, Mode::Baked)));
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
    let scenes = scenes.chain(with_settings).filter(|compiled| !takes_files(compiled));
    expect_none(scenes.filter_map(|compiled| {
        let size = [96, 54];
        let drawn = host::one_sample(gpu, &text_of(&compiled, Language::Wgsl), size);
        let raytoy = common::picture(gpu, &compiled, size, View::Color).rgba;
        host::difference(&drawn, &raytoy).map(|why| format!("{}: {why}", compiled.scene.name))
    }));
}

#[test]
fn a_plain_host_gathers_samples_as_raytoy_does() {
    let Some(gpu) = common::gpu() else { return };
    let compiled = expect_compiled(outcome(SCENE, Mode::Baked));
    let (size, samples) = ([96, 54], 5);
    let drawn = host::many_samples(gpu, &text_of(&compiled, Language::Wgsl), size, samples);
    let moment = raytoy::gpu::Moment::of(&compiled.scene);
    let raytoy = raytoy::gpu::render(gpu, &compiled, &moment, size, samples, &mut |_| ()).expect("it draws");
    assert_eq!(host::difference(&drawn, &raytoy.rgba), None);
    let one = host::one_sample(gpu, &text_of(&compiled, Language::Wgsl), size);
    assert_ne!(host::difference(&one, &raytoy.rgba), None, "edges of many samples are smooth");
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
        error("shown", "return 1.0;", Language::Wgsl),
        "the scene cannot stand on its own: redefinition of `shown` (in textures/shown.wgsl)"
    );
    let local = "var iTime = frame.time; return iTime * iTime;";
    assert_eq!(
        error("waves", local, Language::Glsl),
        "the scene cannot stand on its own: one of its textures or shapes uses a name that Shadertoy has taken, \
         such as `iTime`"
    );
    let unknown = "return f32(select(vec2u(1u), vec2u(2u), at.uv > vec2f(0.0)).x);";
    assert_eq!(
        error("waves", unknown, Language::Glsl),
        "the scene cannot stand on its own: Shadertoy has no `select` for vectors of whole numbers, which `waves` \
         uses; write one for each component"
    );
}

#[test]
fn files_that_a_scene_needs_are_told() {
    let told = generate(&["scenes/models.ron", "--lang", "glsl"]);
    assert_eq!(told.status.code(), Some(2));
    assert_eq!(
        String::from_utf8_lossy(&told.stderr),
        "raytoy: a shader on its own cannot hold images and models from files: leave out what uses \
         `scenes/models/knot.obj`, `scenes/models/gem.glb`\n"
    );
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
    assert_eq!(Ok(bytes), export(&compiled, Language::Spirv));
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
        "raytoy: SPIR-V is no text for a terminal; name a file, as in `-o scene.spv`"
    );
}

/// What is wrong with an export.
fn judge(language: Language, bytes: &[u8]) -> Result<(), String> {
    let text = String::from_utf8_lossy(bytes);
    let lacks = |parts: &[&str]| match parts.iter().find(|part| !text.contains(**part)) {
        Some(part) => Err(format!("it lacks `{part}`")),
        None => Ok(()),
    };
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
            let code = text.lines().filter(|line| !line.starts_with("//")).collect::<Vec<_>>().join("\n");
            if let Some(found) = foreign.iter().find(|word| code.contains(**word)) {
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
            lacks(&[" : register(b0)", "samples : register(t1)"])
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
    let bytes = export(compiled, language).unwrap_or_else(|error| panic!("{}: {error}", compiled.scene.name));
    String::from_utf8(bytes).expect("it is text")
}

fn generate(arguments: &[&str]) -> std::process::Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_raytoy"));
    command.arg("generate").args(arguments).current_dir(common::root()).stdin(Stdio::null());
    command.output().expect("raytoy runs")
}
