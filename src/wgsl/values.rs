//! Values that vary over a surface, as calls.

use std::collections::BTreeSet;

use super::Writer;
use super::code::{self, Code, Lines};
use crate::ir::{Call, Fit, Interpolation, Measure, Picture, Ramp, Triplanar, Value};
use crate::library::{Const, Type};

/// The statements before the expression that a function returns.
#[derive(Default)]
pub struct Body {
    pub lines: Lines,
    count: usize,
}

impl Body {
    /// A new local, defined by `keyword name = code;`.
    fn bind(&mut self, keyword: &str, stem: &str, code: &Code, indent: usize) -> String {
        self.count += 1;
        let name = format!("{stem}{}", self.count);
        self.lines.statement(indent, &format!("{keyword} {name} = "), code, ";");
        name
    }
}

impl Writer<'_> {
    /// `value` at the point `at`; what must be computed first goes to `body`, `indent` columns in.
    pub fn value(&mut self, value: &Value, at: &str, body: &mut Body, indent: usize) -> Code {
        match value {
            Value::Const(constant) => self.numbers.constant(*constant),
            Value::Model(index) => Code::atom(&self.model_names[*index]),
            Value::Texture(index) => Code::call(&self.texture_names[*index], [Code::atom(at)]),
            Value::Grey(number) => Code::call("vec3f", [self.value(number, at, body, indent)]),
            Value::Luminance(color) => Code::call("luminance", [self.value(color, at, body, indent)]),
            Value::Call(call) => self.call(call, at, body, indent),
            Value::Ramp(ramp) => self.ramp(ramp, at, body, indent),
            Value::Triplanar(form) => self.triplanar(form, at, body, indent),
            Value::Picture(picture) => self.picture(picture, at, body, indent),
        }
    }

    fn call(&mut self, call: &Call, at: &str, body: &mut Body, indent: usize) -> Code {
        let at = &self.moved(call.at.as_deref(), at, body, indent);
        self.uses(&call.function);
        let mut arguments = vec![Code::atom(at)];
        for argument in &call.arguments {
            arguments.push(self.value(argument, at, body, indent));
        }
        Code::call(&call.function.wgsl_name, arguments)
    }

    /// The point that `mapping` makes of the point `at`.
    pub fn moved(&mut self, mapping: Option<&Call>, at: &str, body: &mut Body, indent: usize) -> String {
        let Some(mapping) = mapping else { return at.to_owned() };
        let code = self.call(mapping, at, body, indent);
        body.bind("let", "at", &code, indent)
    }

    /// One stop is mixed over the other: below its start a step is 0, above its end 1.
    fn ramp(&mut self, ramp: &Ramp, at: &str, body: &mut Body, indent: usize) -> Code {
        let at = &self.moved(ramp.at.as_deref(), at, body, indent);
        let by = self.value(&ramp.by, at, body, indent);
        let by = body.bind("let", "by", &by, indent);
        let (first_at, first) = &ramp.stops[0];
        let first = self.value(first, at, body, indent);
        let color = body.bind("var", "ramp", &first, indent);
        let mut low = *first_at;
        for (high, stop) in &ramp.stops[1..] {
            let ends = [low, *high].map(|x| self.numbers.constant(Const::F32(x)));
            let step = match ramp.interpolation {
                Interpolation::Linear => "rampStep",
                Interpolation::Smooth => "rampSmooth",
                Interpolation::Constant => "rampConstant",
            };
            let step = Code::call(step, ends.into_iter().chain([Code::atom(&by)]));
            let stop = self.value(stop, at, body, indent);
            let mixed = Code::call("mix", [Code::atom(&color), stop, step]);
            body.lines.statement(indent, &format!("{color} = "), &mixed, ";");
            low = *high;
        }
        Code::atom(color)
    }

    /// The texture is written once, in a loop over the three sides.
    fn triplanar(&mut self, form: &Triplanar, at: &str, body: &mut Body, indent: usize) -> Code {
        let at = &self.moved(form.at.as_deref(), at, body, indent);
        let sum = body.bind("var", "sides", &Code::call("vec3f", [Code::atom("0.0")]), indent);
        let sharpness = self.numbers.constant(Const::F32(form.sharpness));
        body.lines.push(format!("{:indent$}for (var side = 0u; side < 3u; side++) {{", ""));
        let project = Code::call("sideOf", [Code::atom(at), Code::atom("side")]);
        let flat = body.bind("let", "at", &project, indent + 4);
        let color = self.value(&form.of, &flat, body, indent + 4);
        let seen = body.bind("let", "side_color", &color, indent + 4);
        let weight = Code::call("sideShare", [Code::atom(at), Code::atom("side"), sharpness]);
        body.lines.statement(indent + 4, &format!("{sum} += {seen} * "), &weight, ";");
        body.lines.push(format!("{:indent$}}}", ""));
        Code::atom(sum)
    }

    fn picture(&mut self, picture: &Picture, at: &str, body: &mut Body, indent: usize) -> Code {
        let under = picture.under.as_ref().map(|under| self.value(under, at, body, indent));
        let whole = match picture.fit {
            Fit::Surface => None,
            Fit::Mapping | Fit::Plane => Some("unfitted"),
            Fit::Whole => Some("wholly"),
        };
        let fitted = |at: &str, whole: &str| Code::call(whole, [Code::atom(at)]);
        let before = match picture.fit {
            Fit::Mapping => body.bind("let", "at", &fitted(at, "unfitted"), indent),
            _ => at.to_owned(),
        };
        let moved = self.moved(picture.at.as_deref(), &before, body, indent);
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
        let arguments = [Code::atom(format!("image{}", picture.image)), at];
        Code::call(function, arguments.into_iter().chain(numbers).chain(under))
    }

    /// What the images are bound to.
    pub fn images(&self) -> Lines {
        let mut lines = Lines::default();
        for (i, image) in self.scene.images.iter().enumerate() {
            lines.push("");
            lines.push(code::one_line(&format!("/// {}", image.file)));
            lines.push(format!("@group(1) @binding({}) var image{i}: texture_2d<f32>;", i + 1));
        }
        lines
    }

    /// The functions of the declared textures that something uses, in the author's order.
    pub fn textures(&mut self) -> Lines {
        let scene = self.scene;
        let mut reached = BTreeSet::new();
        let shaping = scene.objects.iter().flat_map(|object| &object.arguments);
        shaping.for_each(|value| reach(value, scene, &mut reached));
        reach(&scene.background, scene, &mut reached);
        if let Some(Measure::Texture(index)) = scene.measure {
            reach(&Value::Texture(index), scene, &mut reached);
        }
        for material in &scene.materials {
            let heights = material.bump.iter().map(|bump| &bump.height);
            for value in material.properties.iter().map(|(_, value)| value).chain(heights) {
                reach(value, scene, &mut reached);
            }
        }
        let mut lines = Lines::default();
        for index in reached {
            let texture = &scene.textures[index];
            let mut body = Body::default();
            let value = self.value(&texture.value, "at", &mut body, 4);
            let ty = if texture.ty == Type::F32 { "f32" } else { "vec3f" };
            lines.push("");
            lines.push(code::one_line(&format!("/// textures: \"{}\"", texture.name)));
            lines.push(format!("fn {}(at: Surface) -> {ty} {{", self.texture_names[index]));
            lines.extend(body.lines);
            lines.statement(4, "return ", &value, ";");
            lines.push("}");
        }
        lines
    }
}

/// Adds the declared textures that `value` needs.
fn reach(value: &Value, scene: &crate::ir::Scene, reached: &mut BTreeSet<usize>) {
    match value {
        Value::Const(_) | Value::Model(_) => {}
        Value::Texture(index) => {
            if reached.insert(*index) {
                reach(&scene.textures[*index].value, scene, reached);
            }
        }
        Value::Grey(inner) | Value::Luminance(inner) => reach(inner, scene, reached),
        Value::Call(call) => reach_call(call, scene, reached),
        Value::Ramp(ramp) => {
            ramp.at.iter().for_each(|mapping| reach_call(mapping, scene, reached));
            reach(&ramp.by, scene, reached);
            ramp.stops.iter().for_each(|(_, stop)| reach(stop, scene, reached));
        }
        Value::Picture(picture) => {
            picture.at.iter().for_each(|mapping| reach_call(mapping, scene, reached));
            picture.under.iter().for_each(|under| reach(under, scene, reached));
        }
        Value::Triplanar(form) => {
            form.at.iter().for_each(|mapping| reach_call(mapping, scene, reached));
            reach(&form.of, scene, reached);
        }
    }
}

fn reach_call(call: &Call, scene: &crate::ir::Scene, reached: &mut BTreeSet<usize>) {
    call.at.iter().for_each(|mapping| reach_call(mapping, scene, reached));
    call.arguments.iter().for_each(|argument| reach(argument, scene, reached));
}
