//! Primitives: their crossings as calls, and `surfaceAt`.

use super::Writer;
use super::answer::Answer;
use super::code::{Code, CodeLines};
use crate::ir::{Primitive, Space, Value};
use crate::library::Const;

/// The most primitives, or objects, that one function names: naga takes quadratic time over a function's
/// statements.
pub const MAX_PER_FUNCTION: usize = 32;

/// What is written about one primitive more than once, so that its numbers are slots once.
pub struct WrittenPrimitive {
    pub arguments: Vec<Code>,
    pub space: Option<Code>,
}

/// `ray` in `space`, the world's if there is none.
pub fn local(space: Option<&Code>, ray: &str) -> Code {
    match space {
        None => Code::atom(ray),
        Some(space) => Code::call("rayInto", [space.clone(), Code::atom(ray)]),
    }
}

impl Writer<'_> {
    pub fn primitive(&mut self, primitive: &Primitive) -> WrittenPrimitive {
        self.uses(&primitive.shape);
        let constants = primitive.arguments.iter().map(|argument| match argument {
            Value::Const(constant) => self.numbers.constant(*constant),
            Value::Model(index) => Code::atom(&self.model_names[*index]),
            // What varies is written where the distance is asked for. Bounds take it as 1.
            _ => Code::call("f32", [Code::atom("1.0")]),
        });
        let arguments = constants.collect();
        WrittenPrimitive { arguments, space: primitive.space.as_ref().map(|rows| self.space(rows)) }
    }

    pub fn space(&mut self, rows: &Space) -> Code {
        let rows: Vec<Code> =
            rows.iter().map(|row| self.numbers.constant(Const::Vec4((*row).into()))).collect();
        Code::call("Space", rows)
    }

    /// `function` of `first` and the primitive's arguments.
    pub fn on_shape(&self, index: usize, suffix: &str, first: Code, written: &WrittenPrimitive) -> Code {
        let object = &self.scene.primitives[index];
        if object.is_textured() {
            return Code::call(format!("{}{suffix}", self.field_names[index]), [first]);
        }
        let function = format!("{}{suffix}", object.shape.wgsl_name);
        Code::call(function, [first].into_iter().chain(written.arguments.iter().cloned()))
    }

    pub fn surfaces(&self, written: &[WrittenPrimitive]) -> CodeLines {
        let mut lines = CodeLines::default();
        let chunks = written.len().div_ceil(MAX_PER_FUNCTION);
        lines.push("");
        lines.push("/// The surface of `object` at the world point `p`.");
        lines.push("fn surfaceAt(object: u32, p: vec3f) -> Placed {");
        if chunks > 1 {
            let answer = Answer::new(written.len(), "its_surface", "Placed");
            let mut cases = CodeLines::default();
            for i in 0..chunks {
                let case = if i + 1 < chunks { format!("case {i}u") } else { "default".into() };
                let given = answer.given(&format!("surfacePart{i}(object, p)"));
                cases.push(format!("        {case}: {{ {given} }}"));
            }
            lines.extend(answer.switch(&format!("object / {MAX_PER_FUNCTION}u"), cases));
            lines.push("}");
            for (i, part) in written.chunks(MAX_PER_FUNCTION).enumerate() {
                lines.push("");
                lines.push(format!("fn surfacePart{i}(object: u32, p: vec3f) -> Placed {{"));
                lines.extend(self.surface_switch(i * MAX_PER_FUNCTION, part));
                lines.push("}");
            }
        } else {
            lines.extend(self.surface_switch(0, written));
            lines.push("}");
        }
        lines
    }

    fn surface_switch(&self, first: usize, written: &[WrittenPrimitive]) -> CodeLines {
        let answer = Answer::new(written.len(), "its_surface", "Placed");
        let mut lines = CodeLines::default();
        for (i, written) in written.iter().enumerate() {
            let index = first + i;
            let inverted = self.scene.primitives[index].inverted;
            let on_shape = |p: Code| {
                let seen = self.on_shape(index, "Surface", p, written);
                if inverted { Code::call("inverted", [seen]) } else { seen }
            };
            lines.push(format!("        case {}: {{", self.object_names[index]));
            let placed = match &written.space {
                None => Code::call("placed", [on_shape(Code::atom("p")), Code::atom("p")]),
                Some(space) => {
                    lines.statement(12, "let space = ", space, ";");
                    let local = Code::call("pointInto", [Code::atom("space"), Code::atom("p")]);
                    Code::call("placedFrom", [Code::atom("space"), on_shape(local), Code::atom("p")])
                }
            };
            lines.statement(12, &answer.give(), &placed, ";");
            lines.push("        }");
        }
        lines.push("        default: {");
        let nowhere = answer.given("placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p)");
        lines.push(format!("            {nowhere}"));
        lines.push("        }");
        answer.switch("object", lines)
    }
}
