//! Lights, one case each.

use super::Writer;
use super::answer::Answer;
use super::code::{Code, CodeLines};
use crate::ir::{Light, LightKind};
use crate::library::Const;

impl Writer<'_> {
    pub fn lights(&mut self) -> CodeLines {
        let scene = self.scene;
        let mut lines = CodeLines::default();
        lines.push("");
        lines.push("/// The light `index` as the world point `p` sees it.");
        lines.push("fn lightAt(index: u32, p: vec3f) -> Light {");
        let answer = Answer::new(scene.lights.len(), "its_light", "Light");
        let mut cases = CodeLines::default();
        for (index, light) in scene.lights.iter().enumerate() {
            let code = self.light(light);
            cases.push(self.caption(&format!("        // lights[{index}]"), &light.caption));
            cases.statement(8, &format!("case {index}u: {{ {}", answer.give()), &code, "; }");
        }
        let none = answer.given("pointLight(p, p, 0.0, vec3f(0.0))");
        cases.push(format!("        default: {{ {none} }}"));
        lines.extend(answer.switch("index", cases));
        lines.push("}");
        lines
    }

    fn light(&mut self, light: &Light) -> Code {
        let vector = |v| Const::Vec3(v);
        let (name, numbers) = match light.kind {
            LightKind::Point { position, radius } => {
                ("pointLight", vec![vector(position), Const::F32(radius)])
            }
            LightKind::Directional { direction, spread } => {
                ("directionalLight", vec![vector(direction), Const::F32(spread)])
            }
            LightKind::Spot { position, radius, axis, inner, outer } => {
                let numbers = [radius, inner, outer].map(Const::F32);
                ("spotLight", vec![vector(position), numbers[0], vector(axis), numbers[1], numbers[2]])
            }
            LightKind::Rect { corner, u, v } => ("rectLight", vec![vector(corner), vector(u), vector(v)]),
        };
        let point = (name != "directionalLight").then(|| Code::atom("p"));
        let numbers: Vec<Code> =
            numbers.into_iter().chain([vector(light.emitted)]).map(|n| self.numbers.constant(n)).collect();
        let code = Code::call(name, point.into_iter().chain(numbers));
        if light.inverse_square { Code::call("inverseSquare", [code]) } else { code }
    }
}
