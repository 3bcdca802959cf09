//! Primitives: functions of each in its own space, and `surfaceAt`.

use std::ops::Range;

use super::Writer;
use super::answer::Answer;
use super::code::{Code, CodeLines};
use super::names::Names;
use crate::ir::{Primitive, Solid, Space, Value};
use crate::library::Const;

/// The most primitives, or objects, that one function names: naga takes quadratic time over a function's
/// statements.
pub const MAX_PER_FUNCTION: usize = 32;

/// The functions of one primitive, by name.
pub struct PrimitiveNames {
    /// Of a shape that takes textures, what its distance and bounds are called, too.
    pub crossing: String,
    surface: String,
    contains: String,
    space: String,
}

/// The numbers of one primitive, so that they are slots once.
pub struct WrittenPrimitive {
    pub arguments: Vec<Code>,
    pub space: Option<Code>,
}

impl PrimitiveNames {
    pub fn of(primitive: &Primitive, names: &mut Names<'_>) -> Self {
        let mut name = |suffix| names.function(&primitive.name, suffix);
        if primitive.is_textured() {
            let field = name("Field");
            let [surface, contains] = ["Surface", "Contains"].map(|suffix| format!("{field}{suffix}"));
            return Self { crossing: field, surface, contains, space: name("Space") };
        }
        let [crossing, surface] = ["Crossing", "SurfaceAt"].map(&mut name);
        let [contains, space] = ["Holds", "Space"].map(name);
        Self { crossing, surface, contains, space }
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

    /// Where a ray first meets primitive `index`, in that one's space.
    pub fn crossing(&self, index: usize, ray: Code) -> Code {
        Code::call(&self.primitive_names[index].crossing, [ray])
    }

    /// The surface of primitive `index` at `p`, in that one's space.
    pub fn surface(&self, index: usize, p: Code) -> Code {
        Code::call(&self.primitive_names[index].surface, [p])
    }

    /// Whether primitive `index`, which is endless, holds `p`, in that one's space.
    pub fn contains(&self, index: usize, p: Code) -> Code {
        Code::call(&self.primitive_names[index].contains, [p])
    }

    /// The space of primitive `index`, if it is not the world's.
    pub fn space_of(&self, index: usize) -> Option<Code> {
        let has_space = self.scene.primitives[index].space.is_some();
        has_space.then(|| Code::call(&self.primitive_names[index].space, []))
    }

    /// `ray` in the space of primitive `index`.
    pub fn local(&self, index: usize, ray: &str) -> Code {
        match self.space_of(index) {
            None => Code::atom(ray),
            Some(space) => Code::call("rayInto", [space, Code::atom(ray)]),
        }
    }

    /// The functions of all primitives that have their numbers, under the author's words.
    pub fn primitive_functions(&self, written: &[WrittenPrimitive]) -> CodeLines {
        let mut lines = CodeLines::default();
        for (index, written) in written.iter().enumerate() {
            let (primitive, names) = (&self.scene.primitives[index], &self.primitive_names[index]);
            let of_shape = |suffix: &str, first: &str| {
                let arguments = [Code::atom(first)].into_iter().chain(written.arguments.iter().cloned());
                Code::call(format!("{}{suffix}", primitive.shape.wgsl_name), arguments)
            };
            lines.push("");
            lines.push(self.primitive_caption(index));
            if !primitive.is_textured() {
                lines.function(&format!("{}(ray: Ray) -> f32", names.crossing), &of_shape("", "ray"));
                lines.push("");
                let head = format!("{}(p: vec3f) -> Surface", names.surface);
                lines.function(&head, &of_shape("Surface", "p"));
            }
            if self.asks_for_inside(index) {
                lines.push("");
                let head = format!("{}(p: vec3f) -> bool", names.contains);
                lines.function(&head, &of_shape("Contains", "p"));
            }
            if let Some(space) = &written.space {
                lines.push("");
                lines.function(&format!("{}() -> Space", names.space), space);
            }
        }
        lines
    }

    /// Whether a solid asks what primitive `index` holds: without an end, it may hold a ray that never
    /// crosses it.
    pub fn asks_for_inside(&self, index: usize) -> bool {
        let is_whole = |solid: &Solid| matches!(solid, Solid::Primitive(own) if *own == index);
        let is_part = !self.scene.objects.iter().any(|object| is_whole(&object.solid));
        is_part && self.scene.primitives[index].shape.traits.is_endless
    }

    fn primitive_caption(&self, index: usize) -> String {
        let primitive = &self.scene.primitives[index];
        let is_own = |solid: &Solid| matches!(solid, Solid::Primitive(own) if *own == index);
        let object = self.scene.objects.iter().position(|object| is_own(&object.solid));
        let head = object.map_or_else(String::new, |object| format!("objects[{object}] "));
        self.caption(&format!("/// {head}\"{}\"", primitive.name), &primitive.caption)
    }

    pub fn surfaces(&self) -> CodeLines {
        let mut lines = CodeLines::default();
        let count = self.scene.primitives.len();
        let chunks = count.div_ceil(MAX_PER_FUNCTION);
        lines.push("");
        lines.push("/// The surface of `object` at the world point `p`.");
        lines.push("fn surfaceAt(object: u32, p: vec3f) -> Placed {");
        if chunks > 1 {
            let answer = Answer::new(count, "its_surface", "Placed");
            let mut cases = CodeLines::default();
            for i in 0..chunks {
                let case = if i + 1 < chunks { format!("case {i}u") } else { "default".into() };
                let given = answer.given(&format!("surfacePart{i}(object, p)"));
                cases.push(format!("        {case}: {{ {given} }}"));
            }
            lines.extend(answer.switch(&format!("object / {MAX_PER_FUNCTION}u"), cases));
            lines.push("}");
            for i in 0..chunks {
                let first = i * MAX_PER_FUNCTION;
                lines.push("");
                lines.push(format!("fn surfacePart{i}(object: u32, p: vec3f) -> Placed {{"));
                lines.extend(self.surface_switch(first..count.min(first + MAX_PER_FUNCTION)));
                lines.push("}");
            }
        } else {
            lines.extend(self.surface_switch(0..count));
            lines.push("}");
        }
        lines
    }

    fn surface_switch(&self, indices: Range<usize>) -> CodeLines {
        let answer = Answer::new(indices.len(), "its_surface", "Placed");
        let mut lines = CodeLines::default();
        for index in indices {
            let inverted = self.scene.primitives[index].inverted;
            let on_shape = |p: Code| {
                let seen = self.surface(index, p);
                if inverted { Code::call("inverted", [seen]) } else { seen }
            };
            let p = || Code::atom("p");
            let name = Code::atom(&self.object_names[index]);
            let placed = match self.space_of(index) {
                None => Code::call("placed", [on_shape(p()), p()]),
                Some(space) => {
                    let local = Code::call("pointInto", [space.clone(), p()]);
                    Code::call("placedFrom", [space, on_shape(local), p()])
                }
            };
            lines.case(&name, &answer.give(), &placed);
        }
        let nowhere = answer.given("placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)), p)");
        lines.push(format!("        default: {{ {nowhere} }}"));
        answer.switch("object", lines)
    }
}
