//! Solids made of solids: a function that follows a ray through the surfaces of the parts.

use std::collections::BTreeMap;

use super::Writer;
use super::code::{Code, CodeLines};
use super::names::Names;
use super::primitives::WrittenPrimitive;
use crate::ir::{Csg, CsgOperation, Scene, Solid};

/// A part as the function's local variable.
struct Part {
    /// Its next crossing.
    name: String,
    /// Whether that is the crossing in question.
    turns: String,
    /// The ray as the part sees it.
    ray: String,
}

/// The functions of CSG solids, by the author's names for them.
pub fn function_names(scene: &Scene, names: &mut Names<'_>) -> BTreeMap<String, String> {
    let mut found = BTreeMap::new();
    let mut open: Vec<&Solid> = scene.objects.iter().rev().map(|object| &object.solid).collect();
    while let Some(solid) = open.pop() {
        let Solid::Csg(csg) = solid else { continue };
        found.insert(csg.name.clone(), names.function(&csg.name, "Solid"));
        open.extend(csg.parts.iter().rev());
    }
    found
}

impl Writer<'_> {
    /// The functions of `solid` and of all its parts; nothing for a shape.
    pub fn csg_functions(&self, solid: &Solid, primitives: &[WrittenPrimitive]) -> CodeLines {
        let mut lines = CodeLines::default();
        let Solid::Csg(csg) = solid else { return lines };
        lines.extend(self.csg(csg, primitives));
        csg.parts.iter().for_each(|part| lines.extend(self.csg_functions(part, primitives)));
        lines
    }

    fn csg(&self, csg: &Csg, primitives: &[WrittenPrimitive]) -> CodeLines {
        // A ray keeps its t in every space, so it is moved once.
        let mut spaces: Vec<usize> = vec![];
        let parts = self.parts(csg, primitives, &mut spaces);
        let mut lines = CodeLines::default();
        lines.push("");
        let object = self
            .scene
            .objects
            .iter()
            .position(|object| matches!(&object.solid, Solid::Csg(own) if own.name == csg.name));
        let place = object.map_or_else(String::new, |object| format!("objects[{object}] "));
        let head = format!("/// {place}\"{}\"", csg.name);
        lines.push(self.caption(&head, &csg.caption));
        lines.push(format!("fn {}(ray: Ray) -> Crossing {{", self.csg_names[&csg.name]));
        lines.push("    var rest = ray;");
        for (i, primitive) in spaces.iter().enumerate() {
            lines.statement(4, &format!("var moved{i} = "), &self.local(*primitive, "ray"), ";");
        }
        parts.iter().for_each(|part| lines.push(format!("    var {} = notAsked();", part.name)));
        lines.push("    for (var i = 0u; i < MAX_CROSSINGS; i++) {");
        for (part, solid) in parts.iter().zip(&csg.parts) {
            lines.push(format!("        if {}.t <= rest.t_min {{", part.name));
            lines.extend(self.ask_part(part, solid));
            lines.push("        }");
        }
        let nearest = parts.iter().map(|part| Code::atom(format!("{}.t", part.name)));
        let nearest = nearest.reduce(|a, b| Code::call("min", [a, b])).expect("a csg has parts");
        lines.statement(8, "let t = ", &nearest, ";");
        lines.push("        if t >= NO_HIT { break; }");
        lines.push("        rest.t_min = sameUpTo(rest, t);");
        (0..spaces.len()).for_each(|i| lines.push(format!("        moved{i}.t_min = rest.t_min;")));
        for part in &parts {
            lines.push(format!("        let {} = {}.t <= rest.t_min;", part.turns, part.name));
        }
        let operation = csg.operation;
        let leaves = |p: &Part| format!("{}.leaves", p.name);
        let outside = |p: &Part| format!("!{}.leaves", p.name);
        lines.extend(inside("before", operation, &parts, leaves, outside));
        let leaves = |p: &Part| format!("{}.leaves != {}", p.name, p.turns);
        let outside = |p: &Part| format!("{}.leaves == {}", p.name, p.turns);
        lines.extend(inside("behind", operation, &parts, leaves, outside));
        lines.push("        if before != behind {");
        let object = parts.iter().rev().map(|p| (Code::atom(format!("{}.object", p.name)), &p.turns));
        let object = object.reduce(|(other, _), (own, turns)| {
            (Code::call("select", [other, own, Code::atom(turns)]), turns)
        });
        let object = object.expect("a csg has parts").0;
        let crossing = Code::call("Crossing", [Code::atom("t"), object, Code::atom("before")]);
        lines.statement(12, "return ", &crossing, ";");
        lines.push("        }");
        lines.push("    }");
        lines.push("    return Crossing(NO_HIT, NO_OBJECT, false);");
        lines.push("}");
        lines
    }

    /// The parts, and the primitives that stand in other spaces than those before.
    fn parts(&self, csg: &Csg, primitives: &[WrittenPrimitive], spaces: &mut Vec<usize>) -> Vec<Part> {
        let mut names = Names::beside([]);
        let space = |index: usize| primitives[index].space.as_ref();
        let part = |solid: &Solid| {
            let (name, moved) = match solid {
                Solid::Primitive(index) => {
                    (&self.scene.primitives[*index].name, space(*index).map(|_| *index))
                }
                Solid::Csg(inner) => (&inner.name, None),
            };
            let ray = moved.map(|primitive| {
                let known = spaces.iter().position(|other| space(*other) == space(primitive));
                let index = known.unwrap_or_else(|| {
                    spaces.push(primitive);
                    spaces.len() - 1
                });
                format!("moved{index}")
            });
            let own = name.strip_prefix(&csg.name).unwrap_or(name);
            Part {
                name: names.variable(own, "part"),
                turns: names.variable(own, "turns"),
                ray: ray.unwrap_or_else(|| "rest".into()),
            }
        };
        csg.parts.iter().map(part).collect()
    }

    /// The next crossing of a part with the rest of the ray.
    fn ask_part(&self, part: &Part, solid: &Solid) -> CodeLines {
        let mut lines = CodeLines::default();
        let Part { name, ray, .. } = part;
        let index = match solid {
            Solid::Csg(inner) => {
                lines.push(format!("            {name} = {}(rest);", self.csg_names[&inner.name]));
                return lines;
            }
            Solid::Primitive(index) => *index,
        };
        lines.statement(12, "let t = ", &self.crossing(index, Code::atom(ray)), ";");
        let surface = self.surface(index, Code::atom(format!("pointAt({ray}, t)")));
        lines.statement(12, "let on = ", &surface, ";");
        let arguments = [ray.as_str(), "t", &self.object_names[index], "on.geometric_normal"];
        let crossing = Code::call("crossing", arguments.map(Code::atom));
        lines.statement(12, &format!("{name} = "), &crossing, ";");
        if self.scene.primitives[index].shape.traits.is_endless {
            let contains = self.contains(index, Code::atom(format!("pointBeyond({ray})")));
            lines.statement(12, &format!("if t >= NO_HIT {{ {name}.leaves = "), &contains, "; }");
        }
        lines
    }
}

/// `let name = …`: whether a point is in the whole, by what is said of each part: `yes`, or `no` of those
/// that are cut away.
fn inside(
    name: &str,
    operation: CsgOperation,
    parts: &[Part],
    yes: impl Fn(&Part) -> String,
    no: impl Fn(&Part) -> String,
) -> CodeLines {
    let cut = |i: usize| operation == CsgOperation::Difference && i > 0;
    let terms = parts.iter().enumerate().map(|(i, part)| if cut(i) { no(part) } else { yes(part) });
    let operator = if operation == CsgOperation::Union { "||" } else { "&&" };
    let mut lines = CodeLines::default();
    lines.chain(8, &format!("let {name} = "), operator, &terms.collect::<Vec<_>>(), ";");
    lines
}
