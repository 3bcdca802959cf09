//! Crossings and surfaces of shapes that give only a distance.

use super::Writer;
use super::code::{Code, Lines};
use crate::library::Function;

impl Writer<'_> {
    /// For each such shape what the others bring along: a function of a ray, and one of a point.
    pub fn marches(&self) -> Lines {
        let mut lines = Lines::default();
        for shape in self.used.iter().filter(|f| f.traits.is_distance) {
            lines.extend(crossing(shape));
            if !shape.traits.has_surface {
                lines.extend(surface(shape));
            }
        }
        lines
    }
}

fn crossing(shape: &Function) -> Lines {
    let name = &shape.wgsl_name;
    let mut lines = Lines::default();
    lines.push("");
    lines.push(format!("/// Where `ray` first changes sides of {name}Distance."));
    lines.statement(0, "fn ", &Code::call(name, parameters("ray: Ray", shape)), " -> f32 {");
    let bounds = Code::call(format!("{name}Bounds"), arguments(shape));
    lines.statement(4, "var march = ", &Code::call("marchFrom", [Code::atom("ray"), bounds]), ";");
    lines.push("    for (var i = 0u; march.t < march.end && i < MARCH_STEPS; i++) {");
    lines.push("        let p = ray.origin + march.t * ray.direction;");
    let distance =
        Code::call(format!("{name}Distance"), [Code::atom("p")].into_iter().chain(arguments(shape)));
    lines.statement(8, "if !", &Code::call("marches", [Code::atom("&march"), distance]), " { break; }");
    lines.push("    }");
    lines.push("    return marched(ray, march);");
    lines.push("}");
    lines
}

fn surface(shape: &Function) -> Lines {
    let name = &shape.wgsl_name;
    let mut lines = Lines::default();
    lines.push("");
    let head = Code::call(format!("{name}Surface"), parameters("p: vec3f", shape));
    lines.statement(0, "fn ", &head, " -> Surface {");
    let bounds = Code::call(format!("{name}Bounds"), arguments(shape));
    lines.statement(4, "let step = ", &Code::call("normalStep", [bounds]), ";");
    lines.push("    var slope = vec3f(0.0, 1e-20, 0.0);");
    lines.push("    for (var i = 0u; i < 4u; i++) {");
    lines.push("        let corner = tetrahedronCorner(i);");
    let beside = [Code::atom("p + step * corner")];
    let distance = Code::call(format!("{name}Distance"), beside.into_iter().chain(arguments(shape)));
    lines.statement(8, "slope += corner * ", &distance, ";");
    lines.push("    }");
    lines.push("    let normal = normalize(slope);");
    lines.push("    return surface(p, normal, p * flatTangents(normal));");
    lines.push("}");
    lines
}

/// The parameters as the shape's own file declares them.
fn parameters(first: &str, shape: &Function) -> Vec<Code> {
    let own = shape.parameters.iter().map(|p| Code::atom(format!("{}: {}", p.wgsl_name, p.ty.wgsl())));
    [Code::atom(first)].into_iter().chain(own).collect()
}

fn arguments(shape: &Function) -> Vec<Code> {
    shape.parameters.iter().map(|p| Code::atom(&p.wgsl_name)).collect()
}
