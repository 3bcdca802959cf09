//! The groups of a scene, but for its objects: camera, background, lights, textures, materials, render.

use std::sync::Arc;

use super::slot::{Slot, Wants};
use super::{ColorStyle, Node, NodeKind, Writer};
use crate::ir::fields::{CAMERA, EVERY_LIGHT, LIGHTS, MATERIAL, RENDER, SCENE};
use crate::scene::{self, Kind, Path, Record, Value};

impl Writer<'_> {
    /// A node for each field of a scene.
    pub fn scene(&self, root: &Value) -> Vec<Node> {
        SCENE
            .iter()
            .map(|field| {
                let path = Path::default().field(field.name);
                let value = root.at(&path);
                let kind = match field.name {
                    "camera" => NodeKind::Camera,
                    "background" => NodeKind::Background,
                    "ambient" => NodeKind::Ambient,
                    "lights" => NodeKind::Lights,
                    "textures" => NodeKind::Textures,
                    "materials" => NodeKind::Materials,
                    "objects" => NodeKind::Objects,
                    "render" => NodeKind::Render,
                    other => unreachable!("no node shows the field `{other}` of a scene"),
                };
                let mut node = Node::new(kind, path.clone(), field.name.to_owned(), value);
                node.doc = field.doc.to_owned();
                match kind {
                    NodeKind::Camera => node.fields = self.table(CAMERA, value, &path),
                    NodeKind::Render => node.fields = self.table(RENDER, value, &path),
                    NodeKind::Lights => node.nodes = self.lights(value, &path),
                    NodeKind::Textures => node.nodes = self.entries(value, &path, NodeKind::Texture),
                    NodeKind::Materials => node.nodes = self.entries(value, &path, NodeKind::Material),
                    NodeKind::Objects => node.nodes = self.objects(value, &path),
                    _ => {
                        let slot = Slot::of_field(field);
                        node.fields.extend(slot.map(|slot| self.field(&slot, value, path)));
                    }
                }
                node
            })
            .collect()
    }

    fn lights(&self, written: Option<&Value>, path: &Path) -> Vec<Node> {
        let lights = items(written).iter().enumerate().map(|(i, item)| {
            let name = name(item);
            let known = LIGHTS.iter().map(|(light, _)| light).find(|light| Some(light.name) == name);
            let path = path.item(i);
            let label = format!("{} {i}", name.unwrap_or("light"));
            let mut node = Node::new(NodeKind::Light, path.clone(), label, Some(item));
            if let Some(known) = known {
                node.doc = known.doc.to_owned();
                node.fields = self.table(known.fields, Some(item), &path);
                node.fields.extend(self.table(EVERY_LIGHT, Some(item), &path));
            }
            node.names = self.names.lights.clone();
            node
        });
        lights.collect()
    }

    /// What a map declares.
    fn entries(&self, written: Option<&Value>, path: &Path, kind: NodeKind) -> Vec<Node> {
        let Some(Value { kind: Kind::Map(entries), .. }) = written else { return vec![] };
        let nodes = entries.iter().map(|scene::Field { name, value }| {
            let path = path.key(&name.text);
            let mut node = Node::new(kind, path.clone(), name.text.clone(), Some(value));
            node.span = Some(name.span.start..value.whole.end);
            node.fields = match kind {
                NodeKind::Material => self.table(MATERIAL, Some(value), &path),
                _ => {
                    let wants = Wants::Color { default: None, style: ColorStyle::Text, varies: true };
                    let slot = Slot {
                        label: &name.text,
                        doc: "",
                        unit: None,
                        is_required: true,
                        is_point: false,
                        wants,
                    };
                    vec![self.field(&slot, Some(value), path)]
                }
            };
            node
        });
        nodes.collect()
    }
}

impl Node {
    /// One without anything inside.
    pub(super) fn new(kind: NodeKind, path: Path, label: String, value: Option<&Value>) -> Self {
        Self {
            kind,
            path,
            label,
            doc: String::new(),
            name: value.and_then(name).map(str::to_owned),
            names: Arc::default(),
            span: value.map(|value| value.whole.clone()),
            object: None,
            fields: vec![],
            nodes: vec![],
        }
    }
}

/// What a list holds.
pub fn items(written: Option<&Value>) -> &[Value] {
    match written {
        Some(Value { kind: Kind::List(items), .. }) => items,
        _ => &[],
    }
}

/// The `Name` of `Name(…)`.
pub fn name(value: &Value) -> Option<&str> {
    match &value.kind {
        Kind::Record(Record { name: Some(name), .. }) => Some(&name.text),
        _ => None,
    }
}
