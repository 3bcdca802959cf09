//! Materials and textures: what the surface of an object looks like.

use super::Writer;
use super::answer::Answer;
use super::code::{Code, CodeLines};
use super::names::Names;
use super::values::Block;
use crate::ir::{Material, Property, Scene, Value};
use crate::library::Const;

/// The function of each material. Those of objects without one share theirs.
pub fn function_names(scene: &Scene, names: &mut Names<'_>) -> Vec<String> {
    let mut unset = None;
    let name = |material: &Material| match material.is_unset() {
        true => unset.get_or_insert_with(|| names.function("default", "Material")).clone(),
        false => names.function(&material.name, "Material"),
    };
    scene.materials.iter().map(name).collect()
}

impl Writer<'_> {
    pub fn materials(&mut self) -> CodeLines {
        let mut lines = self.material_of_object();
        for (index, material) in self.scene.materials.iter().enumerate() {
            if self.is_first_of_its_name(index) && self.cases(|m| self.is_written_as(m, index)).is_some() {
                lines.extend(self.material(index, material));
            }
        }
        lines.extend(self.variation());
        lines.extend(self.bumps());
        lines.extend(self.background());
        lines.extend(self.textures());
        lines
    }

    fn material_of_object(&self) -> CodeLines {
        let mut lines = CodeLines::default();
        lines.push("");
        lines.push("/// The material of `object` at its surface point `at`.");
        lines.push("fn materialAt(object: u32, at: Surface) -> Material {");
        let answer = Answer::new(self.scene.materials.len(), "its_material", "Material");
        let mut cases = CodeLines::default();
        for (index, name) in self.material_names.iter().enumerate() {
            let objects = self.cases(|material| self.is_written_as(material, index));
            if let Some(objects) = objects.filter(|_| self.is_first_of_its_name(index)) {
                cases.case(&objects, &answer.give(), &Code::call(name, [Code::atom("at")]));
            }
        }
        cases.push(format!("        default: {{ {} }}", answer.given("matte(vec3f(0.0))")));
        lines.extend(answer.switch("object", cases));
        lines.push("}");
        lines
    }

    /// Whether one function is written for both materials.
    fn is_written_as(&self, material: usize, other: usize) -> bool {
        self.material_names[material] == self.material_names[other]
    }

    fn is_first_of_its_name(&self, material: usize) -> bool {
        self.material_names.iter().position(|name| *name == self.material_names[material]) == Some(material)
    }

    /// The objects whose material `is` the wanted one, as the selector of a `case`.
    pub fn cases(&self, is: impl Fn(usize) -> bool) -> Option<Code> {
        let objects = self.scene.primitives.iter().zip(&self.object_names);
        let mut names: Vec<Code> =
            objects.filter(|(o, _)| is(o.material)).map(|(_, name)| Code::atom(name)).collect();
        match names.len() {
            0 => None,
            1 => names.pop(),
            _ => Some(Code::Cases(names)),
        }
    }

    fn material(&mut self, index: usize, material: &Material) -> CodeLines {
        let mut block = Block::of(material.properties.iter().map(|(_, value)| value), self.scene);
        let mut settings = vec![];
        let mut color = Code::call("vec3f", [Code::atom("0.8")]);
        for (property, value) in &material.properties {
            let code = self.value(value, "at", &mut block, 4);
            match property {
                Property::Color => color = code,
                other => settings.push((field(*other), code)),
            }
        }
        let mut lines = CodeLines::default();
        lines.push("");
        lines.push(match material.is_unset() {
            true => "/// The material of objects that have none in the scene.".into(),
            false => self.caption(&format!("/// material \"{}\"", material.name), &material.caption),
        });
        lines.push(format!("fn {}(at: Surface) -> Material {{", self.material_names[index]));
        lines.extend(block.lines);
        let matte = Code::call("matte", [color]);
        if settings.is_empty() {
            lines.statement(4, "return ", &matte, ";");
        } else {
            lines.statement(4, "var material = ", &matte, ";");
            for (field, code) in settings {
                lines.statement(4, &format!("material.{field} = "), &code, ";");
            }
            lines.push("    return material;");
        }
        lines.push("}");
        lines
    }

    fn variation(&self) -> CodeLines {
        let varies = |material: usize| self.scene.materials[material].is_textured();
        let mut lines = CodeLines::default();
        lines.push("");
        lines.push("/// Whether the material of `object` varies over its surface.");
        lines.push("fn isTextured(object: u32) -> bool {");
        match self.cases(varies) {
            Some(cases) if self.cases(|material| !varies(material)).is_some() => {
                lines.push("    switch object {");
                lines.statement(8, "case ", &cases, ": { return true; }");
                lines.push("        default: { return false; }");
                lines.push("    }");
            }
            all => lines.push(format!("    return {};", all.is_some())),
        }
        lines.push("}");
        lines
    }

    fn bumps(&mut self) -> CodeLines {
        let scene = self.scene;
        let bumped = |material: usize| scene.materials[material].bump.is_some();
        let mut lines = CodeLines::default();
        lines.push("");
        lines.push("/// The world normal of `object` at `met`.");
        lines.push("fn normalAt(object: u32, met: Placed) -> vec3f {");
        let Some(cases) = self.cases(bumped) else {
            lines.push("    return met.normal;");
            lines.push("}");
            return lines;
        };
        lines.push("    switch object {");
        lines.statement(8, "case ", &cases, ": { return bumpedNormal(object, met); }");
        lines.push("        default: { return met.normal; }");
        lines.push("    }");
        lines.push("}");
        lines.push("");
        lines.push("/// The height of `object` over its surface at `at`, scene units.");
        lines.push("fn heightAt(object: u32, at: Surface) -> f32 {");
        let answer = Answer::new(scene.materials.len(), "its_height", "f32");
        let mut cases = CodeLines::default();
        for (index, material) in scene.materials.iter().enumerate() {
            let Some(bump) = &material.bump else { continue };
            let Some(objects) = self.cases(|m| m == index) else { continue };
            let mut block = Block::of([&bump.height], scene);
            let strength = self.numbers.constant(Const::F32(bump.strength));
            let height = self.value(&bump.height, "at", &mut block, 12);
            cases.statement(8, "case ", &objects, ": {");
            cases.extend(block.lines);
            cases.statement(12, "let height = ", &height, ";");
            cases.statement(12, &format!("{}height * ", answer.give()), &strength, ";");
            cases.push("        }");
        }
        cases.push(format!("        default: {{ {} }}", answer.given("0.0")));
        lines.extend(answer.switch("object", cases));
        lines.push("}");
        lines
    }

    fn background(&mut self) -> CodeLines {
        let scene = self.scene;
        let mut block = Block::of([&scene.background], scene);
        let color = self.value(&scene.background, "at", &mut block, 4);
        let ambient = self.numbers.constant(Const::Vec3(scene.ambient));
        let mut lines = CodeLines::default();
        lines.push("");
        lines.push("/// What a ray sees that leaves the scene in `direction`.");
        lines.push("fn background(direction: vec3f) -> vec3f {");
        if !matches!(scene.background, Value::Const(_)) {
            lines.push("    let at = skyPoint(direction);");
        }
        lines.extend(block.lines);
        lines.statement(4, "return ", &color, ";");
        lines.push("}");
        lines.push("");
        lines.push("fn ambientLight() -> vec3f {");
        lines.statement(4, "return ", &ambient, ";");
        lines.push("}");
        lines
    }
}

/// The field of WGSL's `Material`.
fn field(property: Property) -> &'static str {
    match property {
        Property::Color => "color",
        Property::Specular => "specular",
        Property::Shininess => "shininess",
        Property::Reflectivity => "reflectivity",
        Property::Fresnel => "fresnel",
        Property::Transmission => "transmission",
        Property::Ior => "ior",
        Property::Emission => "emission",
    }
}
