//! `rayTraceScene`, and its sibling for shadows.

use super::Writer;
use super::code::{Code, Lines};
use super::objects::{OBJECTS_PER_FUNCTION, WrittenObject, local};
use crate::ir::{Body, Solid};
use crate::library::Const;

/// What is written about one body more than once.
struct WrittenBody {
    caption: String,
    /// How a ray's nearest crossing with it is called.
    crossing: Code,
    /// What picks its t out of that.
    t: &'static str,
    /// Its crossing and its object become a hit.
    step: Code,
    /// The test that a ray comes through the author's bounds.
    guard: Option<Code>,
}

/// One of the two functions that ask all bodies about a ray.
struct Question {
    doc: &'static str,
    /// Whether the author's words stand before each body.
    is_captioned: bool,
    /// The head of the function for all bodies, and its last statement.
    head: &'static str,
    end: &'static str,
    /// The head for a part of them, by its number.
    part_head: fn(usize) -> String,
    /// Asks so many parts, and ends the function.
    ask_parts: fn(&mut Lines, usize),
    before: &'static [&'static str],
    part_before: &'static [&'static str],
    ask: fn(&mut Lines, usize, &WrittenBody),
}

const CLOSEST: Question = Question {
    doc: "/// The nearest object that `ray` meets.",
    is_captioned: true,
    head: "fn rayTraceScene(ray: Ray) -> Hit {",
    end: "    return hit;",
    part_head: |i| format!("fn rayTracePart{i}(ray: Ray, before: Hit) -> Hit {{"),
    ask_parts: |lines, parts| {
        (0..parts).for_each(|i| lines.push(format!("    hit = rayTracePart{i}(ray, hit);")));
        lines.push("    return hit;");
    },
    before: &["    var hit = noHit(ray);"],
    part_before: &["    var hit = before;"],
    ask: |lines, indent, body| lines.statement(indent, "hit = ", &body.step, ";"),
};

const BLOCKED: Question = Question {
    doc: "/// Whether anything that casts a shadow lies on `ray`.",
    is_captioned: false,
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
    ask: |lines, indent, body| {
        let after = format!("{} < NO_HIT {{ return true; }}", body.t);
        lines.statement(indent, "if ", &body.crossing, &after);
    },
};

impl Writer<'_> {
    pub fn bodies(&mut self) -> Lines {
        let scene = self.scene;
        let objects: Vec<WrittenObject> = scene.objects.iter().map(|object| self.object(object)).collect();
        let written: Vec<WrittenBody> = scene.bodies.iter().map(|body| self.body(body, &objects)).collect();
        let select = |wanted: fn(&Body) -> bool| {
            let bodies = scene.bodies.iter().zip(&written);
            bodies.filter(|(body, _)| wanted(body)).map(|(_, written)| written).collect::<Vec<_>>()
        };
        let mut lines = asked(&CLOSEST, &select(|body| body.visible));
        lines.extend(asked(&BLOCKED, &select(|body| body.casts_shadow)));
        for body in &scene.bodies {
            lines.extend(self.combinations(&body.solid, &objects));
        }
        lines.extend(self.surfaces(&objects));
        lines.extend(self.marches(&objects));
        lines
    }

    fn body(&mut self, body: &Body, objects: &[WrittenObject]) -> WrittenBody {
        let (caption, crossing, t, step, ray) = match &body.solid {
            Solid::Object(index) => {
                let object = &self.scene.objects[*index];
                let ray = local(objects[*index].space.as_ref(), "ray");
                let crossing = self.on_shape(*index, "", ray.clone(), &objects[*index]);
                let name = Code::atom(&self.object_names[*index]);
                let step = Code::call("nearer", [Code::atom("hit"), crossing.clone(), name]);
                let head = format!("objects[{index}] \"{}\": ", object.name);
                (self.caption(4, &head, &object.caption), crossing, "", step, ray)
            }
            Solid::Combination(combination) => {
                let space = body.space.as_ref().filter(|_| body.bounds.is_some());
                let space = space.map(|rows| self.space(rows));
                let called = Code::call(&self.combination_names[&combination.name], [Code::atom("ray")]);
                let step = Code::call("nearerCrossing", [Code::atom("hit"), called.clone()]);
                let head = format!("\"{}\": ", combination.name);
                let caption = self.caption(4, &head, &combination.caption);
                (caption, called, ".t", step, local(space.as_ref(), "ray"))
            }
        };
        let guard = body.bounds.map(|(low, high)| {
            let corners = [low, high].map(|c| self.numbers.constant(Const::Vec3(c)));
            Code::call("meetsBounds", [ray].into_iter().chain(corners))
        });
        WrittenBody { caption, crossing, t, step, guard }
    }
}

fn asked(question: &Question, bodies: &[&WrittenBody]) -> Lines {
    let parts: Vec<&[&WrittenBody]> = bodies.chunks(OBJECTS_PER_FUNCTION).collect();
    let mut lines = Lines::default();
    lines.push("");
    lines.push(question.doc);
    lines.push(question.head);
    question.before.iter().for_each(|line| lines.push(*line));
    if parts.len() > 1 {
        (question.ask_parts)(&mut lines, parts.len());
    } else {
        bodies.iter().for_each(|body| ask(question, body, &mut lines));
        lines.push(question.end);
    }
    lines.push("}");
    for (i, part) in parts.iter().enumerate().filter(|_| parts.len() > 1) {
        lines.push("");
        lines.push((question.part_head)(i));
        question.part_before.iter().for_each(|line| lines.push(*line));
        part.iter().for_each(|body| ask(question, body, &mut lines));
        lines.push(question.end);
        lines.push("}");
    }
    lines
}

/// Asks `body`, inside a test of its bounds where the author gave some.
fn ask(question: &Question, body: &WrittenBody, lines: &mut Lines) {
    if question.is_captioned {
        lines.push(body.caption.as_str());
    }
    let Some(guard) = &body.guard else { return (question.ask)(lines, 4, body) };
    lines.statement(4, "if ", guard, " {");
    (question.ask)(lines, 8, body);
    lines.push("    }");
}
