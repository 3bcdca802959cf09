//! From what the author wrote to a scene without open questions: the only file that refuses a scene.

mod colors;
mod conditions;
mod declared;
mod files;
mod forms;
mod lights;
mod limits;
mod materials;
mod objects;
mod options;
mod pictures;
mod placement;
mod reader;
mod remote;
mod textures;
mod usage;
mod values;

use std::collections::{BTreeMap, BTreeSet};

pub use self::objects::default_name;
pub use self::placement::placed;
use self::reader::Fields;
use self::usage::Usage;
use super::{Camera, Material, Scene, Texture, Value, fields};
use crate::assets::{Image, Model};
use crate::diagnostic::{Diagnostic, Place, Severity};
use crate::library::{Const, Library};
use crate::scene;

/// The scene that `root` describes, and warnings; `file` and `text` are where it was written.
///
/// # Errors
/// Everything that is wrong with it, in the order of the text.
pub fn resolve(
    file: &str,
    text: &str,
    root: &scene::Value,
    library: &Library<'_>,
) -> Result<(Scene, Vec<Diagnostic>), Vec<Diagnostic>> {
    let mut resolver = Resolver::new(file, text, library);
    let scene = resolver.scene(root);
    resolver.check_images(&scene);
    let mut problems = resolver.problems;
    problems.extend(library.take_warnings());
    problems.sort_by_key(|p| {
        p.labels.first().map(|(place, _)| (place.file != file, place.file.clone(), place.span.start))
    });
    problems.dedup();
    let failed = problems.iter().any(|p| p.severity == Severity::Error);
    if failed { Err(problems) } else { Ok((scene, problems)) }
}

/// What is known so far. A mistake adds a problem and leaves a stand-in, so that the next one is found too.
struct Resolver<'a> {
    file: &'a str,
    text: &'a str,
    /// What a scene may name.
    lookup: &'a Library<'a>,
    problems: Vec<Diagnostic>,
    /// What `textures:` declares, by name.
    declared: BTreeMap<&'a str, &'a scene::Value>,
    /// Names of the textures that are being resolved, outermost first.
    pending: Vec<String>,
    /// Names of the textures that are made of themselves, and reported.
    circular: BTreeSet<String>,
    /// Names of the textures that are wrong, and reported.
    broken: BTreeSet<String>,
    /// What the value is wanted for that is being resolved.
    usage: Usage,
    /// Whether it would be another one, or a warning, for another use.
    depends_on_usage: bool,
    /// Each with the place that first names it.
    images: Vec<(Image, Place)>,
    models: Vec<Model>,
    textures: Vec<Texture>,
    /// Those of them that depend on what they are wanted for.
    usage_dependent: BTreeSet<usize>,
    /// What each of these is for other uses than light, and whether as a number.
    variants: BTreeMap<(usize, Usage, bool), usize>,
    /// What textures cost.
    cost: limits::Cost,
    /// Where the objects stand.
    stands: Vec<remote::Stand>,
    materials: Vec<Material>,
    /// Indices of the materials that have a name.
    named_materials: BTreeMap<String, usize>,
}

impl<'a> Resolver<'a> {
    fn new(file: &'a str, text: &'a str, lookup: &'a Library<'a>) -> Self {
        Self {
            file,
            text,
            lookup,
            problems: vec![],
            declared: BTreeMap::new(),
            pending: vec![],
            circular: BTreeSet::new(),
            broken: BTreeSet::new(),
            usage: Usage::Light,
            depends_on_usage: false,
            images: vec![],
            models: vec![],
            textures: vec![],
            usage_dependent: BTreeSet::new(),
            variants: BTreeMap::new(),
            cost: limits::Cost::default(),
            stands: vec![],
            materials: vec![],
            named_materials: BTreeMap::new(),
        }
    }

    fn place(&self, span: &std::ops::Range<usize>) -> Place {
        Place { file: self.file.to_owned(), span: span.clone() }
    }

    /// An error at `span`, to which advice may be added.
    fn error(&mut self, span: &std::ops::Range<usize>, message: impl Into<String>) -> &mut Diagnostic {
        let place = self.place(span);
        self.push(Diagnostic::error(message).at(place, ""))
    }

    fn push(&mut self, problem: Diagnostic) -> &mut Diagnostic {
        self.problems.push(problem);
        self.problems.last_mut().expect("it was just pushed")
    }

    fn scene(&mut self, root: &'a scene::Value) -> Scene {
        let mut fields = Fields::of(self, root, "the scene", &[fields::SCENE]);
        let textures = fields.get("textures");
        let materials = fields.get("materials");
        let camera = fields.get("camera");
        let background = fields.get("background");
        let ambient = fields.get("ambient");
        let lights = fields.get("lights");
        let objects = fields.get("objects");
        let render = fields.get("render");
        let default_background = fields.default_color("background");
        let default_ambient = fields.default_color("ambient");
        fields.finish(self);

        self.resolve_textures(textures);
        self.resolve_materials(materials);
        let camera = self.camera(camera);
        let background = match background {
            Some(value) => {
                let color = self.color(value);
                self.check_evaluations(&[&color], &value.span);
                color
            }
            None => Value::Const(Const::Vec3(default_background)),
        };
        let ambient = ambient.map_or(default_ambient, |value| self.constant_color(value));
        let lights = self.lights(lights);
        let (primitives, objects) = self.objects(objects, root);
        self.check_remote(&camera);
        let render = self.render(render);
        Scene {
            name: self.file.to_owned(),
            camera,
            background,
            ambient,
            lights,
            images: self.images.iter().map(|(image, _)| image.clone()).collect(),
            models: std::mem::take(&mut self.models),
            textures: std::mem::take(&mut self.textures),
            materials: std::mem::take(&mut self.materials),
            primitives,
            objects,
            render,
            measure: None,
        }
    }

    fn camera(&mut self, written: Option<&scene::Value>) -> Camera {
        let left_out = scene::Value::left_out();
        let written = written.unwrap_or(&left_out);
        let mut fields = Fields::of(self, written, "`camera`", &[fields::CAMERA]);
        let eye = fields.vector(self, "eye");
        let target = fields.vector(self, "target");
        let up = fields.vector(self, "up");
        let fov = fields.number(self, "fov_deg").to_radians();
        fields.finish(self);
        let forward = target - eye;
        if forward.length() < 1e-9 {
            self.error(&written.span, "`eye` and `target` are the same point");
        } else if forward.normalize().cross(up.normalize_or_zero()).length() < 1e-5 {
            let problem = self.error(&written.span, "`up` points along the view");
            problem.help.push("turn `up` away from `target` - `eye`: `up: (0, 0, 1)`".into());
        }
        Camera { eye, target, up, fov }
    }

    /// A group in the author's words, on one line, without comments and without the fields in `but`.
    fn words(&self, value: &scene::Value, but: &[&str]) -> String {
        let scene::Kind::Record(record) = &value.kind else { return String::new() };
        let words = |span: &std::ops::Range<usize>| {
            let lines = self.text[span.clone()].lines().map(|line| line.split("//").next().unwrap_or(line));
            lines.flat_map(str::split_whitespace).collect::<Vec<_>>().join(" ").replace("( ", "(")
        };
        let kept = record.fields.iter().filter(|f| !but.contains(&f.name.text.as_str()));
        let fields: Vec<String> =
            kept.map(|f| format!("{}: {}", f.name.text, words(&f.value.span))).collect();
        let name = record.name.as_ref().map_or("", |n| n.text.as_str());
        format!("{name}({})", fields.join(", "))
    }
}
