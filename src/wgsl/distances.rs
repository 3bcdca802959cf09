//! Crossings and surfaces of shapes that give only a distance.

use super::Writer;
use super::code::{self, Code, CodeLines};
use super::primitives::WrittenPrimitive;
use super::values::Block;
use crate::ir::Value;
use crate::library::Function;

/// What has a distance: a shape with its parameters, or an object whose shape takes textures.
struct Field {
    name: String,
    /// As functions declare them, and as they pass them on.
    parameters: Vec<Code>,
    arguments: Vec<Code>,
    has_surface: bool,
}

impl Writer<'_> {
    /// For each such shape what the others bring along: a function of a ray, and one of a point.
    pub fn marches(&mut self, primitives: &[WrittenPrimitive]) -> CodeLines {
        let mut lines = CodeLines::default();
        let mut fields: Vec<Field> = vec![];
        for (index, primitive) in self.scene.primitives.iter().enumerate() {
            if primitive.is_textured() {
                let name = self.primitive_names[index].crossing.clone();
                lines.extend(self.textured(index, &name, &primitives[index]));
                fields.push(Field { name, parameters: vec![], arguments: vec![], has_surface: false });
            } else if primitive.shape.traits.is_distance {
                let field = Field::of(&primitive.shape);
                if fields.iter().all(|known| known.name != field.name) {
                    fields.push(field);
                }
            }
        }
        for field in &fields {
            lines.extend(field.crossing());
            if !field.has_surface {
                lines.extend(field.surface());
            }
        }
        lines
    }

    /// The distance to an object, with the textures that it takes, and the box that holds it.
    fn textured(&mut self, index: usize, name: &str, written: &WrittenPrimitive) -> CodeLines {
        let scene = self.scene;
        let primitive = &scene.primitives[index];
        let mut block = Block::of(&primitive.arguments, scene);
        let mut arguments = vec![Code::atom("p")];
        for (argument, constant) in primitive.arguments.iter().zip(&written.arguments) {
            arguments.push(match argument {
                Value::Const(_) | Value::Model(_) => constant.clone(),
                varying => self.value(varying, "at", &mut block, 4),
            });
        }
        let shape = &primitive.shape.wgsl_name;
        let mut lines = CodeLines::default();
        lines.push("");
        let doc = format!("/// The distance to \"{}\", with the textures that shape it.", primitive.name);
        lines.push(code::one_line(&doc));
        lines.push(format!("fn {name}Distance(p: vec3f) -> f32 {{"));
        let place = match primitive.shape.traits.places_textures {
            true => format!("{shape}TexturePoint(p)"),
            false => "p".into(),
        };
        lines.push(format!("    let place = {place};"));
        lines.push("    let at = surface(place, vec3f(0.0, 1.0, 0.0), place.xz);");
        lines.extend(block.lines);
        lines.statement(4, "return ", &Code::call(format!("{shape}Distance"), arguments), ";");
        lines.push("}");
        lines.push("");
        lines.push(format!("fn {name}Bounds() -> Bounds {{"));
        let bounds = Code::call(format!("{shape}Bounds"), written.arguments.iter().cloned());
        lines.statement(4, "return ", &bounds, ";");
        lines.push("}");
        lines
    }
}

impl Field {
    fn of(shape: &Function) -> Self {
        let parameters = shape.parameters.iter();
        // An author's names must not meet those of the locals.
        let given = |name: &str| format!("given_{name}");
        let declared = parameters.clone().map(|p| format!("{}: {}", given(&p.name), p.ty.wgsl()));
        Self {
            name: shape.wgsl_name.clone(),
            parameters: declared.map(Code::atom).collect(),
            arguments: parameters.map(|p| Code::atom(given(&p.name))).collect(),
            has_surface: shape.traits.has_surface,
        }
    }

    /// `nameSUFFIX` with `first` before the other arguments.
    fn call(&self, suffix: &str, first: Option<&str>) -> Code {
        let first = first.map(Code::atom).into_iter();
        Code::call(format!("{}{suffix}", self.name), first.chain(self.arguments.iter().cloned()))
    }

    /// The same as functions are declared.
    fn declared(&self, suffix: &str, first: &str) -> Code {
        let parameters = [Code::atom(first)].into_iter().chain(self.parameters.iter().cloned());
        Code::call(format!("{}{suffix}", self.name), parameters)
    }

    fn crossing(&self) -> CodeLines {
        let mut lines = CodeLines::default();
        lines.push("");
        lines.push(format!("/// Where `ray` first changes sides of {}Distance.", self.name));
        lines.statement(0, "fn ", &self.declared("", "ray: Ray"), " -> f32 {");
        let start = Code::call("marchFrom", [Code::atom("ray"), self.call("Bounds", None)]);
        lines.statement(4, "var march = ", &start, ";");
        lines.push("    for (var i = 0u; march.t < march.end && i < MARCH_STEPS; i++) {");
        lines.push("        let p = ray.origin + march.t * ray.direction;");
        let step = Code::call("marches", [Code::atom("&march"), self.call("Distance", Some("p"))]);
        lines.statement(8, "if !", &step, " { break; }");
        lines.push("    }");
        lines.push("    return marched(ray, march);");
        lines.push("}");
        lines
    }

    fn surface(&self) -> CodeLines {
        let mut lines = CodeLines::default();
        lines.push("");
        lines.statement(0, "fn ", &self.declared("Surface", "p: vec3f"), " -> Surface {");
        let step = Code::call("normalStep", [self.call("Bounds", None)]);
        lines.statement(4, "let step = ", &step, ";");
        lines.push("    var slope = vec3f(0.0, 1e-20, 0.0);");
        lines.push("    for (var i = 0u; i < 4u; i++) {");
        lines.push("        let corner = tetrahedronCorner(i);");
        let distance = self.call("Distance", Some("p + step * corner"));
        lines.statement(8, "slope += corner * ", &distance, ";");
        lines.push("    }");
        lines.push("    let normal = normalize(slope);");
        lines.push("    return surface(p, normal, p * flatTangents(normal));");
        lines.push("}");
        lines
    }
}
