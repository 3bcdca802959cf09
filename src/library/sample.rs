//! What to write in a scene to see a texture or a shape, if nothing else is known of it.

use std::path::{Path, PathBuf};

use super::{Function, Kind, Parameter, Type, function, knot};
use crate::sources::Sources;

/// `Name(…)` with what the author must give.
pub fn call(function: &Function) -> String {
    let required = function.parameters.iter().filter(|p| p.default.is_none());
    let arguments: Vec<String> =
        required.enumerate().map(|(i, p)| format!("{}: {}", p.name, stand_in(p, i))).collect();
    format!("{}({})", function.name, arguments.join(", "))
}

/// `Name(…)` with all that the author may give, at its default.
pub fn full_call(function: &Function) -> String {
    let value = |(i, p): (usize, &Parameter)| match p.default {
        None => format!("{}: {}", p.name, stand_in(p, i)),
        Some(_) if !p.choices.is_empty() => format!("{}: {}", p.name, function::name_of(&p.default_text)),
        Some(_) => format!("{}: {}", p.name, p.default_text),
    };
    let arguments: Vec<String> = function.parameters.iter().enumerate().map(value).collect();
    format!("{}({})", function.name, arguments.join(", "))
}

/// `sources` with a scene in `folder` that shows `function`, and the scene's path.
pub fn shown(function: &Function, sources: Sources, folder: &Path) -> (Sources, PathBuf) {
    // No file of an author's is called that.
    let path = folder.join("-");
    (sources.with(&path, &scene(function)).with(folder.join(knot::FILE), &knot::obj()), path)
}

/// A digest of `function`'s file and of the scene that shows it: 64 bits of FNV-1a, equal on all machines.
pub fn digest(function: &Function) -> u64 {
    let text = scene(function) + &function.text.replace('\r', "");
    let add = |sum: u64, byte: u8| (sum ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
    text.bytes().fold(0xcbf2_9ce4_8422_2325, add)
}

/// A texture on a ball, a block and a floor; a shape on a floor.
fn scene(function: &Function) -> String {
    let stage = r##"
        background: Gradient(zenith: "#5d88c9", horizon: "#dfe9f5"), ambient: 0.2,
        lights: [Point(position: (4, 6, 5), radius: 0.4)],"##;
    if function.kind == Kind::Shape {
        let shape = shape(function);
        let shape = shape.strip_suffix(')').unwrap_or(&shape);
        let comma = if shape.ends_with('(') { "" } else { ", " };
        return format!(
            r##"(camera: (eye: (2.6, 2.2, 4.4), target: (0, 0.1, 0), fov_deg: 34), {stage}
                objects: [
                    Plane(name: "floor", offset: -1.02, material: (color: Checker(even: 0.75, odd: 0.6))),
                    {shape}{comma}name: "shape", material: (color: "#c96f4a", specular: 0.3)),
                ])"##
        );
    }
    let texture = texture(function);
    format!(
        r#"(camera: (eye: (0.5, 2.8, 6), target: (0.1, 0.75, 0), fov_deg: 34), {stage}
            materials: {{ "shown": (color: {texture}) }},
            objects: [
                Plane(material: "shown"),
                Sphere(center: (-1.1, 1, 0), radius: 1, material: "shown"),
                RoundedBox(min: (0.35, 0, -0.75), max: (1.85, 1.5, 0.75), radius: 0.03,
                    rotate_deg: (0, 25, 0), material: "shown"),
            ])"#
    )
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
