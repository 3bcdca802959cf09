//! What to write in a scene to see a texture or a shape, if nothing else is known of it.

use super::{Function, Kind, Parameter, Type, knot};

/// `Name(…)` with what the author must give.
pub fn call(function: &Function) -> String {
    let required = function.parameters.iter().filter(|p| p.default.is_none());
    let arguments: Vec<String> =
        required.enumerate().map(|(i, p)| format!("{}: {}", p.name, stand_in(p, i))).collect();
    format!("{}({})", function.name, arguments.join(", "))
}

/// What the library's functions call the textures that they work on, and one that shows their work.
const INPUTS: [(&str, &str); 4] =
    [("a", "Checker()"), ("b", "Marble()"), ("by", "Noise(scale: 2)"), ("of", "WarpedNoise()")];

/// A texture that shows what `function` does: a mapping needs a pattern to move, others need some to mix.
pub fn texture(function: &Function) -> String {
    let inputs = function.parameters.iter().filter_map(|p| {
        let (name, texture) = INPUTS.iter().find(|(name, _)| *name == p.name)?;
        Some(format!("{name}: {texture}"))
    });
    let inputs = inputs.collect::<Vec<_>>().join(", ");
    let call = if inputs.is_empty() { call(function) } else { format!("{}({inputs})", function.name) };
    match function.kind {
        Kind::Mapping => format!("Checker(at: {call})"),
        _ => call,
    }
}

/// A shape to be looked at: one that a texture can shape has one.
pub fn shape(function: &Function) -> String {
    let takes_height = function.traits.places_textures && function.parameter("height").is_some();
    if takes_height { format!("{}(height: Fbm())", function.name) } else { call(function) }
}

/// A value in RON that `parameter` takes: the points of the first three make a triangle.
pub fn stand_in(parameter: &Parameter, index: usize) -> String {
    let points = [[-1.0, -0.6, 0.0, 1.0], [1.0, -0.6, 0.1, 1.0], [0.2, 0.9, -0.3, 1.0]];
    let (low, high) = parameter.range.unwrap_or((f32::MIN, f32::MAX));
    match parameter.ty {
        Type::Bool => "true".into(),
        Type::Model => format!("{:?}", knot::FILE),
        ty if ty.size() == 1 => ((index + 1) as f32).clamp(low, high).to_string(),
        ty => {
            let point = points[index % points.len()];
            let numbers = point[..ty.size()].iter().map(|x: &f32| x.clamp(low, high).to_string());
            format!("({})", numbers.collect::<Vec<_>>().join(", "))
        }
    }
}
