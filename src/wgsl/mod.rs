//! From the resolved scene to WGSL that reads as if someone had written it for this scene.
//!
//! In: [`ir::Scene`], and a [`Target`]. Out: a [`Source`], the same bytes every time. Nothing here can fail.

mod alone;
mod answer;
mod code;
mod csg;
mod distances;
mod lights;
mod materials;
mod measures;
mod names;
mod numbers;
mod objects;
mod primitives;
mod sections;
mod sharing;
mod target;
mod values;

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::Arc;

use self::code::CodeLines;
use self::names::Names;
use self::numbers::Numbers;
use self::primitives::PrimitiveNames;
pub use self::sections::files;
pub use self::target::{Host, Mode, Target};
use crate::ir;
use crate::library::{Function, built_in};

/// A WGSL module in sections, each from one place.
#[derive(Clone, Debug, PartialEq)]
pub struct Source {
    pub target: Target,
    /// The scene's own section first, then those that it needs.
    pub sections: Vec<Section>,
    /// What the slots of the live mode hold, four to a `vec4f`; empty when baked.
    pub numbers: Vec<f32>,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// The file that it came from, or for the scene's own a name that is none.
    pub name: String,
    pub text: Arc<str>,
}

impl Section {
    /// Whether it is a file of raytoy's own, as that is: an author's may have the same name.
    pub fn ships(&self) -> bool {
        built_in(&self.name).is_some_and(|text| text == &*self.text)
    }
}

impl Source {
    /// The module, ready for naga.
    pub fn text(&self) -> String {
        self.sections.iter().map(|s| &*s.text).collect::<Vec<_>>().join("\n")
    }

    /// The scene's own section.
    pub fn generated(&self) -> &str {
        &self.sections[0].text
    }

    /// Whether it has shaders/guard.wgsl, and loops that have to ask it.
    pub fn is_guarded(&self) -> bool {
        self.sections.iter().any(|section| section.name == sections::GUARD)
    }

    /// Whether a picture of it depends on the time.
    pub fn reads_time(&self) -> bool {
        self.sections.iter().any(|section| section.text.contains("frame.time"))
    }

    /// The section and the byte in it that byte `at` of [`Source::text`] came from.
    pub fn origin(&self, at: usize) -> (&Section, usize) {
        let mut start = 0;
        for section in &self.sections {
            if at <= start + section.text.len() {
                return (section, at - start);
            }
            start += section.text.len() + 1;
        }
        let last = self.sections.last().expect("the scene's own section is always there");
        (last, last.text.len())
    }
}

/// The module for `scene` as `target` wants it.
pub fn generate(scene: &ir::Scene, target: &Target) -> Source {
    // Only a debug view shows what is measured.
    let scene = match scene.measure {
        Some(_) if !target.views => Cow::Owned(ir::Scene { measure: None, ..scene.clone() }),
        _ => Cow::Borrowed(scene),
    };
    let (mut writer, block) = Writer::with_text(&scene, target.mode);
    let mut text = CodeLines::default();
    match target.host {
        Host::Raytoy => text.extend(writer.title()),
        // An export opens with a head of its own.
        Host::Any | Host::Shadertoy { .. } => {}
    }
    text.extend(writer.contents());
    text.extend(block);
    text.extend(writer.without_raytoy(&target.host));
    writer.sections(text, target)
}

/// What is known while one scene is written.
struct Writer<'a> {
    scene: &'a ir::Scene,
    mode: Mode,
    numbers: Numbers,
    /// Constants of the objects: `OBJECT_FLOOR`.
    object_names: Vec<String>,
    /// Functions of the primitives.
    primitive_names: Vec<PrimitiveNames>,
    /// Functions that test the bounds of objects, where the author gave some.
    reach_names: Vec<String>,
    /// The images, in the order of their bindings.
    images_in_use: Vec<usize>,
    /// Constants of the models: `MODEL_KNOT`.
    model_names: Vec<String>,
    /// Functions of CSG solids, by their names.
    csg_names: BTreeMap<String, String>,
    /// Functions of the materials and textures.
    material_names: Vec<String>,
    texture_names: Vec<String>,
    /// Shapes, textures and mappings, in the order of first use.
    used: Vec<Arc<Function>>,
}

impl<'a> Writer<'a> {
    /// All of the scene's own section but its head. What it uses is known only afterwards, so a name that an
    /// author's file has, too, is found then, and all is written again.
    fn with_text(scene: &'a ir::Scene, mode: Mode) -> (Self, CodeLines) {
        let mut names = Names::beside([]);
        let mut writer = Self::new(scene, mode, &mut names);
        let text = writer.scene_text();
        let used = writer.used.clone();
        // No name is a function of raytoy's own files.
        let files = || used.iter().map(|function| &*function.text);
        if !files().any(|file| names.meet(file)) {
            return (writer, text);
        }
        let mut writer = Self::new(scene, mode, &mut Names::beside(files()));
        let text = writer.scene_text();
        (writer, text)
    }

    fn new(scene: &'a ir::Scene, mode: Mode, names: &mut Names<'_>) -> Self {
        let object_names = scene.primitives.iter().map(|o| names.constant("OBJECT", &o.name)).collect();
        let material_names = materials::function_names(scene, names);
        let texture_names = scene.textures.iter().map(|t| names.function(&t.name, "Texture")).collect();
        Self {
            scene,
            mode,
            numbers: Numbers::new(mode),
            object_names,
            images_in_use: scene.images_in_use(),
            model_names: scene.models.iter().map(|m| names.constant("MODEL", stem(&m.file))).collect(),
            primitive_names: scene.primitives.iter().map(|p| PrimitiveNames::of(p, names)).collect(),
            reach_names: scene.objects.iter().map(|o| names.function(o.name(scene), "InReach")).collect(),
            csg_names: csg::function_names(scene, names),
            material_names,
            texture_names,
            used: vec![],
        }
    }

    fn scene_text(&mut self) -> CodeLines {
        let objects = self.objects();
        let materials = self.materials();
        let measured = self.measured();
        let lights = self.lights();
        let mut text = self.constants();
        text.extend(objects);
        text.extend(self.images());
        text.extend(materials);
        text.extend(measured);
        text.extend(lights);
        text.extend(self.numbers.accessor());
        text
    }

    /// The module that opens with `text`.
    fn sections(self, text: CodeLines, target: &Target) -> Source {
        let own = Section { name: format!("generated from {}", self.scene.name), text: text.finish().into() };
        let needed = sections::needed(&own, &self.used, target, self.scene.measure.is_some());
        let sections = [own].into_iter().chain(needed).collect();
        Source { target: target.clone(), sections, numbers: self.numbers.into_data() }
    }

    fn uses(&mut self, function: &Arc<Function>) {
        if !self.used.iter().any(|f| f.file == function.file) {
            self.used.push(function.clone());
        }
    }

    /// `head` and the author's words on one line: in live mode not the numbers, which may change.
    fn caption(&self, head: &str, caption: &str) -> String {
        let name_only = caption.split('(').next().unwrap_or(caption);
        let words = if self.mode == Mode::Live { name_only } else { caption };
        let words = if words.is_empty() { String::new() } else { format!(": {words}") };
        code::one_line(&format!("{head}{words}"))
    }

    fn title(&self) -> CodeLines {
        let mut lines = CodeLines::default();
        lines.push(code::one_line(&format!("// Generated from {}", title_of(self.scene))));
        lines.push(
            "// Do not edit: change the scene, or a file in shapes/ or textures/, and this is written again.",
        );
        lines.push("//");
        lines
    }

    /// What the scene is made of.
    fn contents(&self) -> CodeLines {
        let mut lines = CodeLines::default();
        let names: Vec<&str> = self.scene.primitives.iter().map(|o| o.name.as_str()).collect();
        lines.extend(code::list("//   objects   ", &names));
        let kind = |shape: bool| {
            let functions =
                self.used.iter().filter(move |f| (f.kind == crate::library::Kind::Shape) == shape);
            functions.map(|f| f.name.as_str()).collect::<Vec<_>>()
        };
        lines.extend(code::list("//   shapes    ", &kind(true)));
        lines.extend(code::list("//   textures  ", &kind(false)));
        if self.mode == Mode::Live {
            lines.push("//   numbers   are data: live(i) is the i-th four of them");
        }
        lines
    }

    fn constants(&self) -> CodeLines {
        let mut lines = CodeLines::default();
        lines.push("");
        for (i, name) in self.object_names.iter().enumerate() {
            lines.push(format!("const {name}: u32 = {i}u;"));
        }
        let mut root = 0;
        for (name, model) in self.model_names.iter().zip(&self.scene.models) {
            lines.push(code::one_line(&format!("/// {}", model.file)));
            lines.push(format!("const {name}: Model = Model({root}u, {});", model.has_uv));
            root += model.texels();
        }
        lines.push(format!("const LIGHTS: u32 = {}u;", self.scene.lights.len()));
        let transmits = self.scene.transmits();
        lines.push("/// Whether any ray goes through a surface.");
        lines.push(format!("const TRANSMITS: bool = {transmits};"));
        lines
    }
}

/// The scene's name as its text has it: a path outside the folder that raytoy runs in differs from machine to
/// machine.
pub fn title_of(scene: &ir::Scene) -> &str {
    let name = scene.name.as_str();
    let is_absolute = name.starts_with('/') || name.contains(':');
    if is_absolute { name.rsplit('/').next().unwrap_or(name) } else { name }
}

/// The file's name without its folder and ending.
fn stem(file: &str) -> &str {
    let name = file.rsplit('/').next().unwrap_or(file);
    name.split('.').next().unwrap_or(name)
}
