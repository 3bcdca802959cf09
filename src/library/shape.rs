//! A shape's file: either crossings with a ray and the surface there, or a distance and bounds.

use std::ops::Range;

use super::declarations::{Declared, Signature};
use super::function::Traits;
use super::header::Header;
use super::{Family, Parameter, Type};
use crate::diagnostic::Diagnostic;

/// A shape whose docs have a line that starts so cannot be a part of another.
const OPEN: &str = "encloses nothing";
/// A doc line that starts so names the shape's points: it moves as they move together.
const POINTS: &str = "moves with ";

impl<'a> Header<'a> {
    /// Whether the file gives a distance to the shape and leaves its crossings to raytoy.
    pub fn is_distance(&self) -> bool {
        self.signature(&self.wgsl_name).is_none() && self.distance_signature().is_some()
    }

    pub fn distance_signature(&self) -> Option<Signature<'a>> {
        let is_shape = self.family == Family::Shape;
        self.signature(&format!("{}Distance", self.wgsl_name)).filter(|_| is_shape)
    }

    /// What the file's other functions and its docs say of the shape, whose parameters are `own`.
    pub fn shape_traits(
        &self,
        own: &[Declared<'_>],
        docs: &[(&str, Range<usize>)],
        problems: &mut Vec<Diagnostic>,
    ) -> Traits {
        let is_distance = self.is_distance();
        let is_open = docs.iter().any(|(line, _)| line.starts_with(OPEN));
        if is_distance {
            self.sibling(
                "Bounds",
                &[],
                own,
                "Bounds",
                "it returns a box around the shape: rays march inside the box",
                problems,
            );
        }
        let has_surface = !is_distance || self.signature(&format!("{}Surface", self.wgsl_name)).is_some();
        if has_surface {
            let gives = "it returns the outward normal and uv at a point of the surface";
            self.sibling("Surface", &["p: vec3f"], own, "Surface", gives, problems);
        }
        let is_endless = self.signature(&format!("{}Contains", self.wgsl_name)).is_some();
        if is_endless {
            self.sibling(
                "Contains",
                &["p: vec3f"],
                own,
                "bool",
                "it returns true for points inside the shape",
                problems,
            );
        }
        let places_textures = self.signature(&format!("{}TexturePoint", self.wgsl_name)).is_some();
        if places_textures {
            let gives = "it returns the point at which the shape evaluates its textures";
            self.sibling("TexturePoint", &["p: vec3f"], &[], "vec3f", gives, problems);
        }
        Traits { is_open, is_endless, is_distance, places_textures, has_surface }
    }

    /// Marks the parameters that the docs call points of the shape.
    pub fn mark_points(
        &self,
        parameters: &mut [Parameter],
        docs: &[(&str, Range<usize>)],
        problems: &mut Vec<Diagnostic>,
    ) {
        let lines = docs.iter().filter_map(|(line, span)| Some((line.strip_prefix(POINTS)?, span)));
        for (names, span) in lines {
            let mut at = span.start + POINTS.len();
            for part in names.split(',') {
                let (name, start) = (part.trim(), at + part.len() - part.trim_start().len());
                at += part.len() + 1;
                let place = self.place(start..start + name.len());
                let wrong = |message: String| Diagnostic::error(message).at(place, "");
                match parameters.iter_mut().find(|parameter| parameter.name == name) {
                    Some(found) if found.ty == Type::Vec3 && !found.is_color && !found.nonzero => {
                        found.is_point = true;
                    }
                    Some(_) => {
                        let message = format!("`{name}` is not a point parameter of `{}`", self.wgsl_name);
                        problems.push(
                            wrong(message)
                                .help("points have the type `vec3f`, and are neither colors nor directions"),
                        );
                    }
                    None => {
                        let message = format!("`{}` has no parameter `{name}`", self.wgsl_name);
                        let known = parameters.iter().map(|parameter| parameter.name.as_str());
                        problems.push(wrong(message).suggest(name, known));
                    }
                }
            }
        }
    }

    /// Reports that `nameSUFFIX` is missing, or takes something else than `first` and the shape's parameters.
    fn sibling(
        &self,
        suffix: &str,
        first: &[&str],
        own: &[Declared<'_>],
        returns: &str,
        gives: &str,
        problems: &mut Vec<Diagnostic>,
    ) {
        let name = format!("{}{suffix}", self.wgsl_name);
        let expected: Vec<String> = own.iter().map(|d| format!("{}: {}", d.name, d.ty)).collect();
        let signature = self.signature(&name);
        let agrees = signature.as_ref().is_some_and(|found| {
            let given = &found.declared;
            let point = given.iter().take(first.len()).all(|d| d.ty == "vec3f");
            let rest = given.iter().skip(first.len()).map(|d| format!("{}: {}", d.name, d.ty));
            found.returns == returns && point && rest.eq(expected.iter().cloned())
        });
        if !agrees {
            let parameters: Vec<&str> =
                first.iter().copied().chain(expected.iter().map(String::as_str)).collect();
            let message =
                format!("the shape needs a function `fn {name}({}) -> {returns}`", parameters.join(", "));
            let at = signature.map_or(0..0, |found| found.head);
            problems.push(Diagnostic::error(message).at(self.place(at), "").help(gives));
        }
    }
}
