//! `rayTraceScene`, its sibling for shadows, and the surface of each object.

use super::Writer;
use super::code::{Code, Lines};
use crate::ir::Object;
use crate::library::Const;

/// The most objects that one function names: naga takes quadratic time over a function's statements.
const OBJECTS_PER_FUNCTION: usize = 32;

/// What is written about one object more than once, so that its numbers are slots once.
struct Written {
    arguments: Vec<Code>,
    space: Option<Code>,
    bounds: Option<[Code; 2]>,
}

impl Writer<'_> {
    pub fn objects(&mut self) -> Lines {
        let scene = self.scene;
        let written: Vec<Written> = scene.objects.iter().map(|object| self.object(object)).collect();
        let mut lines = Lines::default();
        lines.extend(self.closest(&written));
        lines.extend(self.blocked(&written));
        lines.extend(self.surfaces(&written));
        lines
    }

    fn object(&mut self, object: &Object) -> Written {
        self.uses(&object.shape);
        let arguments = object.arguments.iter().map(|a| self.numbers.constant(*a)).collect();
        let row = |numbers: &mut super::Numbers, row: &[f32; 4]| numbers.constant(Const::Vec4((*row).into()));
        let space = object.space.as_ref().map(|rows| {
            Code::call("Space", rows.iter().map(|r| row(&mut self.numbers, r)).collect::<Vec<_>>())
        });
        let bounds =
            object.bounds.map(|(low, high)| [low, high].map(|c| self.numbers.constant(Const::Vec3(c))));
        Written { arguments, space, bounds }
    }

    /// The t at which `ray` meets the object.
    fn crossing(&self, index: usize, written: &Written) -> Code {
        let shape = &self.scene.objects[index].shape.wgsl_name;
        Code::call(shape, [local_ray(written)].into_iter().chain(written.arguments.iter().cloned()))
    }

    fn object_caption(&self, index: usize) -> String {
        let object = &self.scene.objects[index];
        self.caption(4, &format!("objects[{index}] \"{}\": ", object.name), &object.caption)
    }

    fn closest(&self, written: &[Written]) -> Lines {
        let seen = |index: &usize| self.scene.objects[*index].visible;
        let indices: Vec<usize> = (0..written.len()).filter(seen).collect();
        let chunks: Vec<&[usize]> = indices.chunks(OBJECTS_PER_FUNCTION).collect();
        let mut lines = Lines::default();
        lines.push("");
        lines.push("/// The nearest object that `ray` meets.");
        lines.push("fn rayTraceScene(ray: Ray) -> Hit {");
        lines.push("    var hit = Hit(ray.t_max, NO_OBJECT);");
        if chunks.len() > 1 {
            (0..chunks.len()).for_each(|i| lines.push(format!("    hit = rayTracePart{i}(ray, hit);")));
        } else {
            indices.iter().for_each(|index| lines.extend(self.closest_step(*index, &written[*index])));
        }
        lines.push("    return hit;");
        lines.push("}");
        for (i, chunk) in chunks.iter().enumerate().filter(|_| chunks.len() > 1) {
            lines.push("");
            lines.push(format!("fn rayTracePart{i}(ray: Ray, before: Hit) -> Hit {{"));
            lines.push("    var hit = before;");
            chunk.iter().for_each(|index| lines.extend(self.closest_step(*index, &written[*index])));
            lines.push("    return hit;");
            lines.push("}");
        }
        lines
    }

    fn closest_step(&self, index: usize, written: &Written) -> Lines {
        let name = Code::atom(&self.object_names[index]);
        let step = Code::call("nearer", [Code::atom("hit"), self.crossing(index, written), name]);
        let mut lines = Lines::default();
        lines.push(self.object_caption(index));
        self.guarded(&mut lines, written, |lines, indent| lines.statement(indent, "hit = ", &step, ";"));
        lines
    }

    fn blocked(&self, written: &[Written]) -> Lines {
        let casts = |index: &usize| self.scene.objects[*index].casts_shadow;
        let indices: Vec<usize> = (0..written.len()).filter(casts).collect();
        let chunks: Vec<&[usize]> = indices.chunks(OBJECTS_PER_FUNCTION).collect();
        let mut lines = Lines::default();
        lines.push("");
        lines.push("/// Whether anything that casts a shadow lies on `ray`.");
        lines.push("fn sceneBlocks(ray: Ray) -> bool {");
        if chunks.len() > 1 {
            for i in 0..chunks.len() {
                lines.push(format!("    if partBlocks{i}(ray) {{ return true; }}"));
            }
        } else {
            indices.iter().for_each(|index| lines.extend(self.blocked_step(*index, &written[*index])));
        }
        lines.push("    return false;");
        lines.push("}");
        for (i, chunk) in chunks.iter().enumerate().filter(|_| chunks.len() > 1) {
            lines.push("");
            lines.push(format!("fn partBlocks{i}(ray: Ray) -> bool {{"));
            chunk.iter().for_each(|index| lines.extend(self.blocked_step(*index, &written[*index])));
            lines.push("    return false;");
            lines.push("}");
        }
        lines
    }

    fn blocked_step(&self, index: usize, written: &Written) -> Lines {
        let crossing = self.crossing(index, written);
        let mut lines = Lines::default();
        self.guarded(&mut lines, written, |lines, indent| {
            lines.statement(indent, "if ", &crossing, " < NO_HIT { return true; }");
        });
        lines
    }

    /// What `step` writes, inside a test of the object's bounds where the author gave some.
    fn guarded(&self, lines: &mut Lines, written: &Written, step: impl FnOnce(&mut Lines, usize)) {
        let Some(bounds) = &written.bounds else { return step(lines, 4) };
        let test = Code::call("meetsBounds", [local_ray(written)].into_iter().chain(bounds.clone()));
        lines.statement(4, "if ", &test, " {");
        step(lines, 8);
        lines.push("    }");
    }

    fn surfaces(&self, written: &[Written]) -> Lines {
        let mut lines = Lines::default();
        let chunks = written.len().div_ceil(OBJECTS_PER_FUNCTION);
        lines.push("");
        lines.push("/// The surface of `object` at the world point `p`.");
        lines.push("fn surfaceAt(object: u32, p: vec3f) -> Placed {");
        if chunks > 1 {
            for i in 1..chunks {
                let below = i * OBJECTS_PER_FUNCTION;
                lines.push(format!("    if object < {below}u {{ return surfacePart{}(object, p); }}", i - 1));
            }
            lines.push(format!("    return surfacePart{}(object, p);", chunks - 1));
            lines.push("}");
            for (i, part) in written.chunks(OBJECTS_PER_FUNCTION).enumerate() {
                lines.push("");
                lines.push(format!("fn surfacePart{i}(object: u32, p: vec3f) -> Placed {{"));
                lines.extend(self.surface_switch(i * OBJECTS_PER_FUNCTION, part));
                lines.push("}");
            }
        } else {
            lines.extend(self.surface_switch(0, written));
            lines.push("}");
        }
        lines
    }

    fn surface_switch(&self, first: usize, written: &[Written]) -> Lines {
        let mut lines = Lines::default();
        lines.push("    switch object {");
        for (i, written) in written.iter().enumerate() {
            let index = first + i;
            let surface = format!("{}Surface", self.scene.objects[index].shape.wgsl_name);
            let arguments = written.arguments.iter().cloned();
            let on_shape = |p: Code| Code::call(&surface, [p].into_iter().chain(arguments));
            lines.push(format!("        case {}: {{", self.object_names[index]));
            let placed = match &written.space {
                None => Code::call("placed", [on_shape(Code::atom("p"))]),
                Some(space) => {
                    lines.statement(12, "let space = ", space, ";");
                    let local = Code::call("pointInto", [Code::atom("space"), Code::atom("p")]);
                    Code::call("placedFrom", [Code::atom("space"), on_shape(local), Code::atom("p")])
                }
            };
            lines.statement(12, "return ", &placed, ";");
            lines.push("        }");
        }
        lines.push("        default: {");
        lines.push("            return placed(surface(p, vec3f(0.0, 1.0, 0.0), vec2f(0.0)));");
        lines.push("        }");
        lines.push("    }");
        lines
    }
}

/// The ray in the object's space.
fn local_ray(written: &Written) -> Code {
    match &written.space {
        None => Code::atom("ray"),
        Some(space) => Code::call("rayInto", [space.clone(), Code::atom("ray")]),
    }
}
