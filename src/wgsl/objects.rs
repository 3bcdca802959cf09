//! `rayTraceScene`, and its sibling for shadows.

use super::Writer;
use super::code::{self, Code, CodeLines};
use super::primitives::{MAX_PER_FUNCTION, WrittenPrimitive};
use crate::ir::{Object, Solid};
use crate::library::Const;

/// What is written about one object more than once.
struct WrittenObject {
    /// How a ray's nearest crossing with it is called.
    crossing: Code,
    /// What picks its t out of that.
    t: &'static str,
    /// Its crossing and its primitive become a hit.
    step: Code,
    /// The test that a ray comes through the author's bounds.
    guard: Option<Code>,
}

/// One of the two functions that ask all objects about a ray.
struct Question {
    doc: &'static str,
    /// The head of the function for all objects, and its last statement.
    head: &'static str,
    end: &'static str,
    /// The head for a part of them, by its number.
    part_head: fn(usize) -> String,
    /// Asks so many parts, and ends the function.
    ask_parts: fn(&mut CodeLines, usize),
    before: &'static [&'static str],
    part_before: &'static [&'static str],
    ask: fn(&mut CodeLines, usize, &WrittenObject),
}

const CLOSEST: Question = Question {
    doc: "/// The nearest object that `ray` meets.",
    head: "fn rayTraceScene(ray: Ray) -> Hit {",
    end: "    return hit;",
    part_head: |i| format!("fn rayTracePart{i}(ray: Ray, before: Hit) -> Hit {{"),
    ask_parts: |lines, parts| {
        (0..parts).for_each(|i| lines.push(format!("    hit = rayTracePart{i}(ray, hit);")));
        lines.push("    return hit;");
    },
    before: &["    var hit = noHit(ray);"],
    part_before: &["    var hit = before;"],
    ask: |lines, indent, object| lines.statement(indent, "hit = ", &object.step, ";"),
};

const BLOCKED: Question = Question {
    doc: "/// Whether anything that casts a shadow lies on `ray`.",
    head: "fn sceneBlocks(ray: Ray) -> bool {",
    end: "    return false;",
    part_head: |i| format!("fn partBlocks{i}(ray: Ray) -> bool {{"),
    // Returns would put each part into a branch of the one before.
    ask_parts: |lines, parts| {
        let calls: Vec<String> = (0..parts).map(|i| format!("partBlocks{i}(ray)")).collect();
        lines.chain(4, "return ", "||", &calls, ";");
    },
    before: &[],
    part_before: &[],
    ask: |lines, indent, object| {
        let after = format!("{} < NO_HIT {{ return true; }}", object.t);
        lines.statement(indent, "if ", &object.crossing, &after);
    },
};

impl Writer<'_> {
    pub fn objects(&mut self) -> CodeLines {
        let scene = self.scene;
        let primitives: Vec<WrittenPrimitive> =
            scene.primitives.iter().map(|primitive| self.primitive(primitive)).collect();
        let written: Vec<WrittenObject> = (0..scene.objects.len()).map(|i| self.written(i)).collect();
        let select = |wanted: fn(&Object) -> bool| {
            let objects = scene.objects.iter().zip(&written);
            objects.filter(|(object, _)| wanted(object)).map(|(_, written)| written).collect::<Vec<_>>()
        };
        let mut lines = asked(&CLOSEST, &select(|object| object.visible));
        lines.extend(asked(&BLOCKED, &select(|object| object.casts_shadow)));
        lines.extend(self.primitive_functions(&primitives));
        for object in &scene.objects {
            lines.extend(self.csg_functions(&object.solid, &primitives));
        }
        lines.extend(self.reaches());
        lines.extend(self.surfaces());
        lines.extend(self.marches(&primitives));
        lines
    }

    fn written(&self, index: usize) -> WrittenObject {
        let object = &self.scene.objects[index];
        let (crossing, t, step) = match &object.solid {
            Solid::Primitive(primitive) => {
                let crossing = self.crossing(*primitive, self.local(*primitive, "ray"));
                let name = Code::atom(&self.object_names[*primitive]);
                (crossing.clone(), "", Code::call("nearer", [Code::atom("hit"), crossing, name]))
            }
            Solid::Csg(csg) => {
                let called = Code::call(&self.csg_names[&csg.name], [Code::atom("ray")]);
                (called.clone(), ".t", Code::call("nearerCrossing", [Code::atom("hit"), called]))
            }
        };
        let guard = object.bounds.map(|_| Code::call(&self.reach_names[index], [Code::atom("ray")]));
        WrittenObject { crossing, t, step, guard }
    }

    /// The tests of the bounds that the author gave.
    fn reaches(&mut self) -> CodeLines {
        let scene = self.scene;
        let mut lines = CodeLines::default();
        for (index, object) in scene.objects.iter().enumerate() {
            let Some((low, high)) = object.bounds else { continue };
            let ray = match (&object.solid, &object.space) {
                (Solid::Primitive(primitive), _) => self.local(*primitive, "ray"),
                (Solid::Csg(_), Some(rows)) => Code::call("rayInto", [self.space(rows), Code::atom("ray")]),
                (Solid::Csg(_), None) => Code::atom("ray"),
            };
            let corners = [low, high].map(|corner| self.numbers.constant(Const::Vec3(corner)));
            lines.push("");
            lines.push(code::one_line(&format!(
                "/// Whether `ray` meets the bounds of \"{}\".",
                object.name(scene)
            )));
            let head = format!("{}(ray: Ray) -> bool", self.reach_names[index]);
            lines.function(&head, &Code::call("meetsBounds", [ray].into_iter().chain(corners)));
        }
        lines
    }
}

fn asked(question: &Question, objects: &[&WrittenObject]) -> CodeLines {
    let parts: Vec<&[&WrittenObject]> = objects.chunks(MAX_PER_FUNCTION).collect();
    let mut lines = CodeLines::default();
    lines.push("");
    lines.push(question.doc);
    lines.push(question.head);
    question.before.iter().for_each(|line| lines.push(*line));
    if parts.len() > 1 {
        (question.ask_parts)(&mut lines, parts.len());
    } else {
        objects.iter().for_each(|object| ask(question, object, &mut lines));
        lines.push(question.end);
    }
    lines.push("}");
    for (i, part) in parts.iter().enumerate().filter(|_| parts.len() > 1) {
        lines.push("");
        lines.push((question.part_head)(i));
        question.part_before.iter().for_each(|line| lines.push(*line));
        part.iter().for_each(|object| ask(question, object, &mut lines));
        lines.push(question.end);
        lines.push("}");
    }
    lines
}

/// Asks `object`, inside a test of its bounds where the author gave some.
fn ask(question: &Question, object: &WrittenObject, lines: &mut CodeLines) {
    let Some(guard) = &object.guard else { return (question.ask)(lines, 4, object) };
    lines.statement(4, "if ", guard, " {");
    (question.ask)(lines, 8, object);
    lines.push("    }");
}
