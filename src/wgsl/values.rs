//! Values that vary over a surface, as calls.

use std::collections::{BTreeMap, BTreeSet};

use super::Writer;
use super::code::{self, Code, CodeLines};
use super::sharing::{Sharing, called};
use crate::bindings::{Binding, IMAGES};
use crate::ir::points::Point;
use crate::ir::{Call, Fit, ImageTexture, Interpolation, Measure, Ramp, Scene, Triplanar, Value};
use crate::library::{Const, Type};

/// The statements before the expression that a function returns.
pub struct Block {
    pub lines: CodeLines,
    count: usize,
    /// For each point, by its name, which named textures are evaluated once.
    shared: BTreeMap<String, Sharing>,
    /// The local of such a texture at such a point.
    known: BTreeMap<(usize, String), String>,
}

impl Block {
    /// The start of a function that evaluates `values` at its parameter `at`.
    pub fn of<'v>(values: impl IntoIterator<Item = &'v Value>, scene: &Scene) -> Self {
        let shared = [("at".to_owned(), Sharing::at(&Point::of(values), scene))].into();
        Self { lines: CodeLines::default(), count: 0, shared, known: BTreeMap::new() }
    }

    /// A new local, defined by `keyword name = code;`.
    fn bind(&mut self, keyword: &str, stem: &str, code: &Code, indent: usize) -> String {
        self.count += 1;
        let name = format!("{stem}{}", self.count);
        self.lines.statement(indent, &format!("{keyword} {name} = "), code, ";");
        name
    }
}

impl Writer<'_> {
    /// `value` at the point `at`; what must be computed first goes to `block`, `indent` columns in.
    pub fn value(&mut self, value: &Value, at: &str, block: &mut Block, indent: usize) -> Code {
        match value {
            Value::Const(constant) => self.numbers.constant(*constant),
            Value::Model(index) => Code::atom(&self.model_names[*index]),
            Value::Texture(index) => self.named(*index, at, block, indent),
            Value::Grey(number) => Code::call("vec3f", [self.value(number, at, block, indent)]),
            Value::Luminance(color) => Code::call("luminance", [self.value(color, at, block, indent)]),
            Value::Call(call) => self.call(call, at, block, indent),
            Value::Ramp(ramp) => self.ramp(ramp, at, block, indent),
            Value::Triplanar(form) => self.triplanar(form, at, block, indent),
            Value::Image(picture) => self.picture(picture, at, block, indent),
        }
    }

    /// A named texture: where it is named again at the same point, it is a local.
    fn named(&mut self, index: usize, at: &str, block: &mut Block, indent: usize) -> Code {
        let key = (index, at.to_owned());
        if let Some(local) = block.known.get(&key) {
            return Code::atom(local);
        }
        let scene = self.scene;
        let sharing = &block.shared[at];
        let is_local = sharing.locals.contains(&index);
        let code = match sharing.opened.contains(&index) {
            true => self.value(&scene.textures[index].value, at, block, indent),
            false => Code::call(&self.texture_names[index], [Code::atom(at)]),
        };
        if !is_local {
            return code;
        }
        let local = block.bind("let", "shared", &code, indent);
        block.known.insert(key, local.clone());
        Code::atom(local)
    }

    fn call(&mut self, call: &Call, at: &str, block: &mut Block, indent: usize) -> Code {
        let at = &self.moved(call.at.as_deref(), at, &call.arguments, block, indent);
        self.uses(&call.function);
        let mut arguments = vec![Code::atom(at)];
        for argument in &call.arguments {
            arguments.push(self.value(argument, at, block, indent));
        }
        Code::call(&call.function.wgsl_name, arguments)
    }

    /// The point that `mapping` makes of the point `at`, where `values` are evaluated next.
    pub fn moved<'v>(
        &mut self,
        mapping: Option<&Call>,
        at: &str,
        values: impl IntoIterator<Item = &'v Value>,
        block: &mut Block,
        indent: usize,
    ) -> String {
        let Some(mapping) = mapping else { return at.to_owned() };
        let code = self.call(mapping, at, block, indent);
        let place = block.bind("let", "at", &code, indent);
        block.shared.insert(place.clone(), Sharing::at(&Point::of(values), self.scene));
        place
    }

    /// One stop is mixed over the other: below its start a step is 0, above its end 1.
    fn ramp(&mut self, ramp: &Ramp, at: &str, block: &mut Block, indent: usize) -> Code {
        let values = ramp.stops.iter().map(|(_, stop)| stop).chain([&ramp.by]);
        let at = &self.moved(ramp.at.as_deref(), at, values, block, indent);
        let by = self.value(&ramp.by, at, block, indent);
        let by = block.bind("let", "by", &by, indent);
        let (first_at, first) = &ramp.stops[0];
        let first = self.value(first, at, block, indent);
        let color = block.bind("var", "ramp", &first, indent);
        let mut low = *first_at;
        for (high, stop) in &ramp.stops[1..] {
            let ends = [low, *high].map(|x| self.numbers.constant(Const::F32(x)));
            let step = match ramp.interpolation {
                Interpolation::Linear => "rampStep",
                Interpolation::Smooth => "rampSmooth",
                Interpolation::Constant => "rampConstant",
            };
            let step = Code::call(step, ends.into_iter().chain([Code::atom(&by)]));
            let stop = self.value(stop, at, block, indent);
            let mixed = Code::call("mix", [Code::atom(&color), stop, step]);
            block.lines.statement(indent, &format!("{color} = "), &mixed, ";");
            low = *high;
        }
        Code::atom(color)
    }

    /// The texture is written once, in a loop over the three sides.
    fn triplanar(&mut self, form: &Triplanar, at: &str, block: &mut Block, indent: usize) -> Code {
        let at = &self.moved(form.at.as_deref(), at, [], block, indent);
        let sum = block.bind("var", "sides", &Code::call("vec3f", [Code::atom("0.0")]), indent);
        let sharpness = self.numbers.constant(Const::F32(form.sharpness));
        block.lines.push(format!("{:indent$}for (var side = 0u; side < 3u; side++) {{", ""));
        let project = Code::call("sideOf", [Code::atom(at), Code::atom("side")]);
        let flat = block.bind("let", "at", &project, indent + 4);
        block.shared.insert(flat.clone(), Sharing::at(&Point::of([&form.of]), self.scene));
        let color = self.value(&form.of, &flat, block, indent + 4);
        let seen = block.bind("let", "side_color", &color, indent + 4);
        let weight = Code::call("sideShare", [Code::atom(at), Code::atom("side"), sharpness]);
        block.lines.statement(indent + 4, &format!("{sum} += {seen} * "), &weight, ";");
        block.lines.push(format!("{:indent$}}}", ""));
        Code::atom(sum)
    }

    fn picture(&mut self, picture: &ImageTexture, at: &str, block: &mut Block, indent: usize) -> Code {
        let under = picture.under.as_ref().map(|under| self.value(under, at, block, indent));
        let whole = match picture.fit {
            Fit::Surface => None,
            Fit::Mapping | Fit::Plane => Some("unfitted"),
            Fit::Whole => Some("wholly"),
        };
        let fitted = |at: &str, whole: &str| Code::call(whole, [Code::atom(at)]);
        let before = match picture.fit {
            Fit::Mapping => {
                let place = block.bind("let", "at", &fitted(at, "unfitted"), indent);
                let values = picture.at.iter().flat_map(|mapping| &mapping.innermost().arguments);
                block.shared.insert(place.clone(), Sharing::at(&Point::of(values), self.scene));
                place
            }
            _ => at.to_owned(),
        };
        let moved = self.moved(picture.at.as_deref(), &before, [], block, indent);
        let at = match whole {
            Some(whole) if picture.fit != Fit::Mapping => fitted(&moved, whole),
            _ => Code::atom(moved),
        };
        // No width is the whole's.
        let width = picture.width.filter(|_| picture.fit != Fit::Whole).unwrap_or(0.0);
        let numbers = [Const::F32(width), Const::Bool(picture.repeat)];
        let numbers = numbers.map(|number| self.numbers.constant(number));
        let function = match (picture.ty, &under) {
            (Type::F32, None) => "imageNumber",
            (Type::F32, Some(_)) => "imageNumberOver",
            (_, None) => "imageColor",
            (_, Some(_)) => "imageColorOver",
        };
        let place = self.images_in_use.iter().position(|image| *image == picture.image);
        let place = place.expect("what is written is in use");
        let arguments = [Code::atom(format!("image{place}")), at];
        Code::call(function, arguments.into_iter().chain(numbers).chain(under))
    }

    /// What the images are bound to.
    pub fn images(&self) -> CodeLines {
        let mut lines = CodeLines::default();
        for (i, index) in self.images_in_use.iter().enumerate() {
            lines.push("");
            lines.push(code::one_line(&format!("/// {}", self.scene.images[*index].file)));
            let (attributes, name) = (Binding::image(i as u32).attributes(), IMAGES.name);
            lines.push(format!("{attributes} var {name}{i}: texture_2d<f32>;"));
        }
        lines
    }

    /// The functions of the declared textures that something uses, in the author's order.
    pub fn textures(&mut self) -> CodeLines {
        let scene = self.scene;
        let mut reached = BTreeSet::new();
        let mut reach = |values: &[&Value]| called(&Point::of(values.iter().copied()), scene, &mut reached);
        scene.primitives.iter().for_each(|object| reach(&object.arguments.iter().collect::<Vec<_>>()));
        reach(&[&scene.background]);
        if let Some(Measure::Texture(index)) = scene.measure {
            reach(&[&Value::Texture(index)]);
        }
        for material in scene.materials_in_use() {
            reach(&material.properties.iter().map(|(_, value)| value).collect::<Vec<_>>());
            material.bump.iter().for_each(|bump| reach(&[&bump.height]));
        }
        let mut lines = CodeLines::default();
        for index in reached {
            let texture = &scene.textures[index];
            let mut block = Block::of([&texture.value], scene);
            let value = self.value(&texture.value, "at", &mut block, 4);
            let ty = if texture.ty == Type::F32 { "f32" } else { "vec3f" };
            lines.push("");
            lines.push(self.caption(&format!("/// texture \"{}\"", texture.name), &texture.caption));
            lines.push(format!("fn {}(at: Surface) -> {ty} {{", self.texture_names[index]));
            lines.extend(block.lines);
            lines.statement(4, "return ", &value, ";");
            lines.push("}");
        }
        lines
    }
}
