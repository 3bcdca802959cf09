//! Objects and the solids that they are made of, counted as `ir::resolve` counts them.

use super::nodes::{items, name};
use super::slot::Slot;
use super::{Node, NodeKind, Writer};
use crate::ir::default_name;
use crate::ir::fields::{EVERY_OBJECT, EVERY_SOLID, OPERATIONS};
use crate::library::Family;
use crate::scene::{Kind, Path, Value};

impl Writer<'_> {
    pub fn objects(&self, written: Option<&Value>, path: &Path) -> Vec<Node> {
        let mut shapes = 0;
        let items = items(written).iter().enumerate();
        let nodes = items.map(|(i, item)| {
            let mut node = self.solid(item, path.item(i), "", i, &mut shapes);
            node.fields.extend(self.table(EVERY_OBJECT, Some(item), &path.item(i)));
            node.names = self.names.solids.clone();
            node
        });
        nodes.collect()
    }

    /// A primitive or a CSG solid, which is at `index` in what is called `around`; `shapes` are those before
    /// it.
    fn solid(&self, item: &Value, path: Path, around: &str, index: usize, shapes: &mut usize) -> Node {
        let shape = name(item).unwrap_or_default();
        let label = match item.at(&Path::default().field("name")).map(|name| &name.kind) {
            Some(Kind::Text(name)) if !name.is_empty() => name.clone(),
            _ => default_name(around, shape, index),
        };
        let operation = OPERATIONS.iter().find(|(group, _)| group.name == shape).map(|(group, _)| group);
        let kind = if operation.is_some() { NodeKind::Csg } else { NodeKind::Object };
        let mut node = Node::new(kind, path.clone(), label.clone(), Some(item));
        node.names = self.names.parts.clone();
        match operation {
            Some(group) => {
                node.doc = group.doc.to_owned();
                let path = path.field("parts");
                let parts = items(item.at(&Path::default().field("parts"))).iter().enumerate();
                let part = |(i, part)| self.solid(part, path.item(i), &label, i, shapes);
                node.nodes = parts.map(part).collect();
            }
            None => {
                node.object = Some(*shapes);
                *shapes += 1;
                if let Ok(function) = self.lookup.find(Family::Shape, shape) {
                    node.doc = function.caption.clone();
                    let varies = function.traits.is_distance;
                    let slots = function.parameters.iter().map(|p| Slot::of_parameter(p, varies));
                    node.fields = slots.map(|slot| self.member(&slot, Some(item), &path)).collect();
                }
            }
        }
        let every = self.table(EVERY_SOLID, Some(item), &path);
        // The name stands before all, as people write it.
        node.fields.splice(0..0, every.iter().filter(|field| field.label == "name").cloned());
        node.fields.extend(every.into_iter().filter(|field| field.label != "name"));
        node
    }
}
