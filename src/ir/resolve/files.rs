//! Files that a scene names: images and models, each read once.

use super::Resolver;
use crate::assets::Reading;
use crate::diagnostic::Diagnostic;
use crate::ir::{Scene, Value};
use crate::library::{Parameter, Type};
use crate::scene::{self, Kind};

impl Resolver<'_> {
    /// The index of the image in the file `path`, read as `reading` says.
    pub fn image(&mut self, path: &str, written: &scene::Value, reading: Reading) -> Option<usize> {
        let place = self.place(&written.span);
        match self.lookup.image(path, reading) {
            Ok(image) => {
                let known = self.images.iter().position(|(known, _)| *known == image);
                Some(known.unwrap_or_else(|| {
                    if let Some(warning) = &image.warning {
                        let message = format!("`{}` {warning}", image.file);
                        self.push(Diagnostic::warning(message).at(place.clone(), ""));
                    }
                    self.images.push((image, place));
                    self.images.len() - 1
                }))
            }
            Err(problem) => {
                let advice =
                    "raytoy looks in the scene's folder for PNG, JPEG, Radiance HDR and OpenEXR files";
                self.refuse_file(problem, written, advice);
                None
            }
        }
    }

    /// Refuses more images than a shader can look up.
    pub fn check_images(&mut self, scene: &Scene) {
        if let Some(index) = scene.images_in_use().get(Scene::MAX_IMAGES) {
            let message = format!("more than {} images in one scene", Scene::MAX_IMAGES);
            let place = self.images[*index].1.clone();
            self.push(Diagnostic::error(message).at(place, ""));
        }
    }

    /// Tells at the file's name in the scene why it cannot be had.
    fn refuse_file(&mut self, problem: Diagnostic, written: &scene::Value, advice: &str) {
        let problem = if problem.help.is_empty() { problem.help(advice) } else { problem };
        let place = self.place(&written.span);
        self.push(problem.at(place, ""));
    }

    /// The value of a parameter that is the same everywhere.
    pub fn fixed(&mut self, parameter: &Parameter, written: &scene::Value) -> Option<Value> {
        match (parameter.ty, &written.kind) {
            (Type::Model, Kind::Text(path)) => self.model(path, written).map(Value::Model),
            (Type::Model, _) => {
                self.mismatch(written, Type::Model.describe());
                None
            }
            _ => self.constant(parameter, written).map(Value::Const),
        }
    }

    /// The index of the model in the file `path`.
    fn model(&mut self, path: &str, written: &scene::Value) -> Option<usize> {
        match self.lookup.model(path) {
            Ok(model) => {
                let known = self.models.iter().position(|m| m.file == model.file);
                Some(known.unwrap_or_else(|| {
                    for warning in &model.warnings {
                        let place = self.place(&written.span);
                        self.push(Diagnostic::warning(format!("`{}` {warning}", model.file)).at(place, ""));
                    }
                    self.models.push(model);
                    self.models.len() - 1
                }))
            }
            Err(problem) => {
                let advice = "raytoy looks in the scene's folder for Wavefront OBJ and glTF files";
                self.refuse_file(problem, written, advice);
                None
            }
        }
    }
}
