//! What textures and shapes are given when a law is asked of them: defaults, and what their docs allow.

use super::Random;
use crate::library::{Const, Function, Parameter, Type, knot};

/// `Name(argument: value, …)`; `value` gives None where the default is to stay.
pub fn call(function: &Function, mut value: impl FnMut(&Parameter) -> Option<String>) -> String {
    let argument = |p: &Parameter| value(p).map(|value| format!("{}: {value}", p.name));
    let arguments: Vec<String> = function.parameters.iter().filter_map(argument).collect();
    format!("{}({})", function.name, arguments.join(", "))
}

/// What stands for a texture's parameter that has no default.
pub fn stand_in(parameter: &Parameter) -> String {
    let (low, high) = parameter.range.unwrap_or((0.0, 1.0));
    match parameter.ty {
        // Patterns and colors are what such parameters are there for, as in combinations of textures.
        Type::F32 if low <= 0.0 && high >= 1.0 => "Noise(scale: 1.3)".into(),
        Type::Vec3 if !parameter.nonzero => "Checker(scale: 0.7)".into(),
        Type::F32 => (0.5 * (low + high)).to_string(),
        Type::I32 | Type::U32 => format!("{}", 1.0_f32.clamp(low, high.max(1.0))),
        Type::Bool => "true".into(),
        Type::Vec2 => "(0.4, 0.7)".into(),
        Type::Vec3 => "(0.3, 0.8, -0.5)".into(),
        Type::Vec4 => "(0.4, 0.7, 0.2, 0.9)".into(),
        Type::Model => format!("{:?}", knot::FILE),
    }
}

/// An argument within the parameter's documented range, now and then at an end of it.
pub fn random_argument(parameter: &Parameter, random: &mut Random) -> String {
    if !parameter.choices.is_empty() {
        return parameter.choices[random.below(parameter.choices.len())].clone();
    }
    let mut number = || random_number(parameter, random);
    match parameter.ty {
        Type::Bool => (number() < 0.5).to_string(),
        Type::I32 | Type::U32 => number().round().to_string(),
        Type::F32 => number().to_string(),
        Type::Vec2 => format!("({}, {})", number(), number()),
        Type::Vec3 => format!("({}, {}, {})", number(), number(), number()),
        Type::Vec4 => format!("({}, {}, {}, {})", number(), number(), number(), number()),
        Type::Model => stand_in(parameter),
    }
}

/// Another texture for a color, or for a number from 0 to 1.
pub fn texture_argument(parameter: &Parameter, random: &mut Random) -> Option<String> {
    let scale = 0.3 + 3.0 * random.unit();
    match parameter.ty {
        Type::F32 if parameter.range == Some((0.0, 1.0)) => Some(format!("Noise(scale: {scale})")),
        Type::Vec3 if parameter.is_color => Some(format!("Checker(scale: {scale})")),
        _ => None,
    }
}

/// About the default: a shape must keep its proportions. None where there is nothing to vary.
pub fn nearby_argument(parameter: &Parameter, random: &mut Random) -> Option<String> {
    let (low, high) = parameter.range.unwrap_or((f32::MIN, f32::MAX));
    // What is 0 stays so: it may be the radius of a hole.
    let mut near = |x: f32| (x * (0.75 + 0.5 * random.unit())).clamp(low, high);
    match parameter.default? {
        Const::F32(x) => Some(near(x).to_string()),
        Const::Vec3(v) => Some(format!("({}, {}, {})", near(v.x), near(v.y), near(v.z))),
        _ => None,
    }
}

fn random_number(parameter: &Parameter, random: &mut Random) -> f32 {
    let default = parameter.default.map_or(1.0, |value| value.numbers()[0]);
    let (low, high) = parameter.range.unwrap_or(match parameter.ty {
        _ if parameter.is_color || parameter.ty == Type::Bool => (0.0, 1.0),
        Type::U32 | Type::I32 => (0.0, 2.0 * default.max(2.0)),
        _ if parameter.nonzero => (-2.0, 2.0),
        _ => (default - default.abs().max(1.0), default + default.abs().max(1.0)),
    });
    let place = random.unit();
    match place {
        _ if place < 0.06 && !parameter.nonzero => low,
        _ if place > 0.94 => high,
        // A scale from 0.01 to 100 is as likely below 1 as above.
        _ if low > 0.0 && high / low > 50.0 => low * (high / low).powf(random.unit()),
        _ => low + (high - low) * random.unit(),
    }
}
