//! The scene as a tree of things that a person can change, with what the author left out and its defaults.
//!
//! In: a [`Value`], its text, and the [`Library`]. Out: an [`Outline`], whose paths [`crate::edit`] takes.

mod becoming;
mod controls;
mod names;
mod nodes;
mod objects;
mod slot;

use std::ops::Range;
use std::sync::Arc;

use glam::Vec3;

pub use becoming::{Becoming, becoming};
pub use names::{Names, Needed, Role, example, needed_file};

use crate::library::Library;
use crate::scene::{Path, Value};

/// What a scene says and what it could say.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    /// The groups of a scene, in the order of LANGUAGE.md, those too that the author left out.
    pub nodes: Vec<Node>,
    pub names: Names,
}

/// A group of fields, or a list of such groups.
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    pub kind: NodeKind,
    pub path: Path,
    /// What to call it: `camera`, `"tiles"`, an object's name.
    pub label: String,
    pub doc: String,
    /// What its `Name(…)` says: `Sphere`, `Point`.
    pub name: Option<String>,
    /// What the name could be instead.
    pub names: Arc<[String]>,
    /// Where the author wrote it, in bytes; None where it is left out.
    pub span: Option<Range<usize>>,
    /// Of a shape: its index in `ir::Scene::primitives`.
    pub object: Option<usize>,
    pub fields: Vec<Field>,
    pub nodes: Vec<Node>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NodeKind {
    Camera,
    Background,
    Ambient,
    Lights,
    Light,
    Textures,
    /// One of `textures:`, whose only field is the texture.
    Texture,
    Materials,
    Material,
    Objects,
    /// A shape.
    Object,
    /// A solid made of its nodes.
    Csg,
    Render,
}

/// A value that can be set, written or not.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    pub path: Path,
    pub label: String,
    pub doc: String,
    /// `degrees`, `stops`; none for scene units and shares.
    pub unit: Option<&'static str>,
    /// Where the author wrote the value, in bytes; None where it is left out.
    pub span: Option<Range<usize>>,
    /// Whether it cannot be left out.
    pub is_required: bool,
    /// Whether the thing moves where this and its other points move by the same way, in its own space.
    pub is_point: bool,
    pub control: Control,
    /// Textures or mappings that could stand here as `Name()`.
    pub calls: Arc<[String]>,
    /// Declared textures or materials that could stand here as `"name"`.
    pub declared: Arc<[String]>,
}

/// What a value is set with, and what it is now. Where nothing is written it shows the default; None is where
/// there is none.
#[derive(Clone, Debug, PartialEq)]
pub enum Control {
    Number {
        value: Option<f32>,
        default: Option<f32>,
        range: Option<(f32, f32)>,
        is_whole: bool,
    },
    /// Two to four numbers, as `size` says.
    Vector {
        size: usize,
        value: Option<Vec<f32>>,
        default: Option<Vec<f32>>,
        /// Of each number.
        range: Option<(f32, f32)>,
    },
    /// Linear RGB.
    Color {
        value: Option<Vec3>,
        default: Option<Vec3>,
        style: ColorStyle,
    },
    /// One of `words`, as RON has them; what the current one carries, as in `Gamma(2.0)`, is in `fields`.
    Choice {
        words: Vec<String>,
        current: Option<usize>,
        default: Option<usize>,
        fields: Vec<Field>,
    },
    Flag {
        value: bool,
        default: Option<bool>,
    },
    /// A name; empty where it is left out.
    Text {
        value: String,
    },
    /// A file beside the scene; empty where it is left out.
    File {
        value: String,
        /// In which such files end.
        extensions: &'static [&'static str],
    },
    /// One of [`Field::declared`], unless it is a mistake.
    Reference {
        name: String,
    },
    /// A texture or mapping of [`Field::calls`] and its fields; no name where a mapping is left out.
    Texture {
        name: Option<String>,
        doc: String,
        fields: Vec<Field>,
    },
    /// Fields that belong together: a material, `bump`, `bounds`. Where it is left out and some of them are
    /// required, those come first.
    Group {
        fields: Vec<Field>,
    },
    /// Items of two or more fields each: the stops of a ramp.
    List {
        items: Vec<Vec<Field>>,
        /// RON text of one more.
        example: &'static str,
    },
    /// The author's words, which are no value for this field.
    Unclear {
        words: String,
    },
}

/// How the author wrote a color; of one that is left out, how its default is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColorStyle {
    /// `"#8c3b2a"` or a CSS name: sRGB.
    Text,
    /// `(0.5, 0.1, 0.0)`: linear RGB.
    Linear,
    /// `0.5`, linear.
    Grey,
}

/// The outline of the scene `root`, parsed from `text`.
///
/// It holds for scenes with mistakes too: names that nobody knows have no fields, values that fit nowhere are
/// [`Control::Unclear`]. The library reports a broken file to the first who asks only, and that is this
/// outline: give it a library of its own.
pub fn outline(root: &Value, text: &str, library: &Library<'_>) -> Outline {
    let names = Names::new(root, library);
    let nodes = Writer { text, lookup: library, names: &names }.scene(root);
    Outline { nodes, names }
}

/// What all parts of the outline are made with.
struct Writer<'a> {
    text: &'a str,
    /// What a scene may name.
    lookup: &'a Library<'a>,
    names: &'a Names,
}

impl Outline {
    /// The shape that is `ir::Scene::primitives[index]`.
    pub fn object(&self, index: usize) -> Option<&Node> {
        self.all_nodes().into_iter().find(|node| node.object == Some(index))
    }

    /// The names, in the order of the signature, among which stands what must be written for there to be a
    /// value at `path`; none where there is one.
    pub fn order_at(&self, path: &Path) -> Vec<String> {
        let leads = |own: &Path| path.0.starts_with(&own.0);
        let (mut nodes, mut fields) = (&self.nodes, vec![]);
        while let Some(node) = nodes.iter().find(|node| leads(&node.path)) {
            if node.span.is_none() {
                return nodes.iter().map(|node| node.label.clone()).collect();
            }
            fields = node.fields.iter().collect();
            nodes = &node.nodes;
        }
        while let Some(field) = fields.iter().find(|field| leads(&field.path)) {
            if field.span.is_none() {
                return fields.iter().map(|field| field.label.clone()).collect();
            }
            fields = field.fields();
        }
        vec![]
    }

    /// The fields that say the name of `node`, which declares a texture or a material.
    pub fn uses(&self, node: &Node) -> Vec<&Field> {
        fn collect<'f>(field: &'f Field, is_use: &dyn Fn(&Field) -> bool, found: &mut Vec<&'f Field>) {
            found.extend(is_use(field).then_some(field));
            field.fields().into_iter().for_each(|inner| collect(inner, is_use, found));
        }
        let declared = match node.kind {
            NodeKind::Material => &self.names.declared_materials,
            _ => &self.names.declared_textures,
        };
        let says =
            |field: &Field| matches!(&field.control, Control::Reference { name } if *name == node.label);
        // A texture and a material may share a name.
        let is_use = |field: &Field| says(field) && Arc::ptr_eq(&field.declared, declared);
        let mut found = vec![];
        for field in self.all_nodes().into_iter().flat_map(|node| &node.fields) {
            collect(field, &is_use, &mut found);
        }
        found
    }

    /// The node to remove so that `node` is gone: a solid cannot be without parts, so its last part takes it
    /// along.
    pub fn to_remove<'n>(&'n self, node: &'n Node) -> &'n Node {
        let is_last = |csg: &&Node| {
            csg.kind == NodeKind::Csg && matches!(csg.nodes.as_slice(), [part] if part.path == node.path)
        };
        self.all_nodes().into_iter().find(is_last).map_or(node, |csg| self.to_remove(csg))
    }

    /// The innermost node that the byte `at` of the text is in.
    pub fn node_at(&self, at: usize) -> Option<&Node> {
        let around = |node: &&Node| node.span.as_ref().is_some_and(|span| span.contains(&at));
        self.all_nodes().into_iter().rfind(around)
    }

    /// All nodes, each before those inside of it.
    pub fn all_nodes(&self) -> Vec<&Node> {
        fn collect<'n>(nodes: &'n [Node], all: &mut Vec<&'n Node>) {
            for node in nodes {
                all.push(node);
                collect(&node.nodes, all);
            }
        }
        let mut all = vec![];
        collect(&self.nodes, &mut all);
        all
    }
}

impl Field {
    /// The fields inside of this one: of a texture, a group, a list or a choice.
    pub fn fields(&self) -> Vec<&Field> {
        match &self.control {
            Control::Choice { fields, .. } | Control::Texture { fields, .. } | Control::Group { fields } => {
                fields.iter().collect()
            }
            Control::List { items, .. } => items.iter().flatten().collect(),
            _ => vec![],
        }
    }
}
