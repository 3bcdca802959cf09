//! The number that the debug view `value` shows, as a function of the scene's own section.

use super::Writer;
use super::answer::Answer;
use super::code::{Code, CodeLines};
use super::values::Block;
use crate::ir::{Measure, Property, Value};
use crate::library::{Const, Type};

impl Writer<'_> {
    /// `measuredAt`, in place of shaders/unmeasured.wgsl; nothing where the scene measures nothing.
    pub fn measured(&mut self) -> CodeLines {
        let mut lines = CodeLines::default();
        let Some(measure) = self.scene.measure else { return lines };
        lines.push("");
        lines.push("/// The number that is measured where `hit` meets the surface point `at`.");
        lines.push("fn measuredAt(hit: Hit, at: Surface, facing: f32) -> f32 {");
        match measure {
            Measure::Pattern => lines.extend(self.patterns()),
            Measure::Distance => lines.push("    return hit.t;"),
            Measure::Facing => lines.push("    return facing;"),
            Measure::U => lines.push("    return at.uv.x;"),
            Measure::V => lines.push("    return at.uv.y;"),
            Measure::Footprint => lines.push("    return at.footprint;"),
            Measure::Texture(index) => {
                let mut block = Block::of([&Value::Texture(index)], self.scene);
                let number = self.number(&Value::Texture(index), "at", &mut block, 4);
                lines.extend(block.lines);
                lines.statement(4, "return ", &number, ";");
            }
        }
        lines.push("}");
        lines
    }

    /// A case for each material.
    fn patterns(&mut self) -> CodeLines {
        let scene = self.scene;
        let answer = Answer::new(scene.materials.len(), "its_number", "f32");
        let mut cases = CodeLines::default();
        for (index, material) in scene.materials.iter().enumerate() {
            let Some(objects) = self.cases(|m| m == index) else { continue };
            let color = material.properties.iter().find(|(property, _)| *property == Property::Color);
            let mut block = Block::of(color.map(|(_, color)| color), scene);
            let number = match color {
                Some((_, color)) => self.number(color, "at", &mut block, 12),
                None => self.numbers.constant(Const::F32(0.8)),
            };
            cases.statement(8, "case ", &objects, ": {");
            cases.extend(block.lines);
            cases.statement(12, &answer.give(), &number, ";");
            cases.push("        }");
        }
        cases.push(format!("        default: {{ {} }}", answer.given("0.0")));
        answer.switch("hit.object", cases)
    }

    /// What `value` is made of, before it is a color.
    fn number(&mut self, value: &Value, at: &str, block: &mut Block, indent: usize) -> Code {
        let scene = self.scene;
        match value {
            Value::Texture(index) if scene.textures[*index].ty == Type::F32 => {
                self.value(value, at, block, indent)
            }
            Value::Texture(index) => self.number(&scene.textures[*index].value, at, block, indent),
            Value::Ramp(ramp) => {
                let at = self.moved(ramp.at.as_deref(), at, [&ramp.by], block, indent);
                self.value(&ramp.by, &at, block, indent)
            }
            Value::Grey(number) => self.value(number, at, block, indent),
            color => Code::call("luminance", [self.value(color, at, block, indent)]),
        }
    }
}
