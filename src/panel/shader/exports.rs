//! The scene's shader in other languages: as a file beside the captures, or as text to paste.
//!
//! naga takes its time, so a thread writes them.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::time::Duration;

use egui::{Button, RichText, Ui};

use super::super::Panel;
use super::super::scenes::stem;
use super::listing;
use crate::compile::Compiled;
use crate::export::{Export, Language, export};
use crate::files::write_file;

/// How often it is looked for what a thread has made.
const BEAT: Duration = Duration::from_millis(50);

/// What can be had; without a language the scene's own section.
struct Offer {
    name: &'static str,
    /// How its file's name ends. x.wgsl beside x.ron would be the golden of a test.
    ending: &'static str,
    language: Option<Language>,
}

const OFFERS: [Offer; 6] = [
    Offer { name: "This section, WGSL", ending: "section.wgsl", language: None },
    Offer { name: "Standalone WGSL", ending: "standalone.wgsl", language: Some(Language::Wgsl) },
    Offer { name: "GLSL for Shadertoy", ending: "glsl", language: Some(Language::Glsl) },
    Offer { name: "SPIR-V for Vulkan", ending: "spv", language: Some(Language::Spirv) },
    Offer { name: "MSL for Metal", ending: "metal", language: Some(Language::Msl) },
    Offer { name: "HLSL for Direct3D", ending: "hlsl", language: Some(Language::Hlsl) },
];

/// Where an export goes.
#[derive(Clone)]
enum Place {
    File(PathBuf),
    Clipboard,
}

/// The export that is being written, and what came of the last one.
#[derive(Default)]
pub struct Exports {
    running: Option<Receiver<Result<Done, String>>>,
    told: Option<Result<String, String>>,
}

enum Done {
    Written(PathBuf),
    Text(String),
}

impl Exports {
    fn start(&mut self, compiled: Arc<Compiled>, language: Option<Language>, place: Place) {
        let (sender, receiver) = channel();
        self.running = Some(receiver);
        // A window that was closed wants to know nothing.
        std::thread::spawn(move || drop(sender.send(carry_out(&compiled, language, place))));
    }

    /// Takes the result of a thread, and returns a message about it.
    pub fn follow(&mut self, ui: &mut Ui) {
        if let Some(running) = &self.running {
            let told = match running.try_recv() {
                Err(TryRecvError::Empty) => return ui.ctx().request_repaint_after(BEAT),
                Err(TryRecvError::Disconnected) => Err("the export has failed".into()),
                Ok(done) => done.map(|done| match done {
                    Done::Written(path) => format!("wrote {}", path.display()),
                    Done::Text(text) => {
                        let told = format!("copied {} lines", text.lines().count());
                        ui.ctx().copy_text(text);
                        told
                    }
                }),
            };
            self.running = None;
            self.told = Some(told);
        }
        match &self.told {
            Some(Ok(told)) => drop(ui.label(RichText::new(told).weak())),
            Some(Err(why)) => drop(ui.colored_label(ui.visuals().error_fg_color, why)),
            None => {}
        }
    }
}

fn carry_out(compiled: &Compiled, language: Option<Language>, place: Place) -> Result<Done, String> {
    let Export { shader, texels } = match language {
        None => Export { shader: listing::baked(compiled).into_bytes(), texels: vec![] },
        Some(language) => export(compiled, language).map_err(|error| error.to_string())?,
    };
    match place {
        Place::File(path) => {
            if !texels.is_empty() {
                written(&Export::texels_file(&path), &texels)?;
            }
            written(&path, &shader)?;
            Ok(Done::Written(path))
        }
        Place::Clipboard if !texels.is_empty() => {
            Err("its images and models need a second file: save the shader instead".to_owned())
        }
        Place::Clipboard => String::from_utf8(shader)
            .map(Done::Text)
            .map_err(|_| "it is binary, so it cannot be copied as text".to_owned()),
    }
}

fn written(path: &Path, bytes: &[u8]) -> Result<(), String> {
    write_file(path, bytes).map_err(|error| format!("cannot write `{}`: {error}", path.display()))
}

impl Panel {
    pub(super) fn export_menu(&mut self, ui: &mut Ui) {
        let Some(compiled) = self.compiled.clone() else { return };
        let stem = stem(&self.scene);
        let mut chosen = None;
        ui.menu_button("Export", |ui| {
            egui::Grid::new("exports").num_columns(3).spacing([10.0, 4.0]).show(ui, |ui| {
                for offer in &OFFERS {
                    ui.label(offer.name);
                    let is_text = offer.language != Some(Language::Spirv);
                    let copy = ui.add_enabled(is_text, Button::new("Copy"));
                    let copy = copy.accessible_name(format!("copy {}", offer.name));
                    let copies =
                        copy.on_disabled_hover_text("it is binary, so it cannot be copied as text").clicked();
                    let file = format!("{stem}.{}", offer.ending);
                    let save = ui.button("Save").accessible_name(format!("save {}", offer.name));
                    let saves = save.on_hover_text(format!("to {file}")).clicked();
                    let place = if saves { Place::File(file.into()) } else { Place::Clipboard };
                    if saves || copies {
                        chosen = Some((offer.language, place));
                        ui.close();
                    }
                    ui.end_row();
                }
            });
        });
        if let Some((language, place)) = chosen {
            self.shader.exports.start(compiled, language, place);
        }
    }
}
