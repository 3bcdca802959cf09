//! The scenes to go on with: those of the folder, and those that were open before.

use std::path::{Path, PathBuf};

use egui::{RichText, Ui};

use super::{Leaving, Panel};
use crate::engine::builder_messages::BuilderCommand;

impl Panel {
    /// Goes on with another scene.
    pub(super) fn open(&mut self, scene: &Path) -> BuilderCommand {
        let (adapter, settings) = (std::mem::take(&mut self.adapter), std::mem::take(&mut self.settings));
        let known = Self::new(scene, adapter, settings);
        let (view, gizmos, tab, magnifies) = (self.view, self.gizmos, self.tab, self.magnifies);
        let (gallery, divider) = (std::mem::take(&mut self.gallery), std::mem::take(&mut self.divider));
        *self = Self { view, gizmos, tab, magnifies, divider, gallery, ..known };
        BuilderCommand::Open(scene.to_owned())
    }

    pub(super) fn scene_menu(&mut self, ui: &mut Ui) {
        let mut chosen = None;
        let shown = egui::ComboBox::from_id_salt("scene")
            .width(150.0)
            .truncate()
            .height(480.0)
            .selected_text(stem(&self.scene))
            .show_ui(ui, |ui| {
                let mut offer = |ui: &mut Ui, scene: &PathBuf, name: String| {
                    let label = ui.selectable_label(*scene == self.scene, name);
                    let label = label.on_hover_text(scene.display().to_string());
                    if label.clicked() && *scene != self.scene {
                        chosen = Some(scene.clone());
                    }
                };
                for scene in &self.scenes {
                    offer(ui, scene, stem(scene));
                }
                if !self.recent.is_empty() {
                    ui.separator();
                    ui.label(RichText::new("recent scenes").weak().small());
                }
                for scene in &self.recent {
                    offer(ui, scene, full_name(scene));
                }
            });
        shown.response.accessible_name("scene");
        if let Some(scene) = chosen {
            self.leave(Leaving::Open(scene));
        }
    }
}

/// The scenes in the folder of `scene`, sorted; settings of tests are none.
pub fn neighbours(scene: &Path) -> Vec<PathBuf> {
    let folder = scene.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let mut scenes: Vec<PathBuf> = entries
        .map(|entry| scene.with_file_name(entry.file_name()))
        .filter(|path| path.extension().is_some_and(|e| e == "ron"))
        .filter(|path| !path.to_string_lossy().ends_with(".test.ron"))
        .collect();
    scenes.sort();
    scenes
}

/// Those of `recent` that are still there and not in the folder of `scene`.
pub fn elsewhere(recent: &[PathBuf], scene: &Path) -> Vec<PathBuf> {
    let here = std::path::absolute(scene).unwrap_or_default();
    let is_elsewhere = |path: &&PathBuf| path.parent() != here.parent() && path.is_file();
    recent.iter().filter(is_elsewhere).cloned().collect()
}

pub fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

/// With the folder, for scenes that may share a name.
pub fn full_name(path: &Path) -> String {
    let folder = path.parent().and_then(Path::file_name).unwrap_or_default().to_string_lossy();
    format!("{} in {folder}", stem(path))
}
