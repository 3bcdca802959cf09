//! The generated shader, as `raytoy generate` shows it: colored, with the lines of what is chosen marked.

use std::sync::Arc;

use egui::text::{LayoutJob, TextFormat};
use egui::{Color32, FontId, RichText, Ui};

use super::Panel;
use crate::Compiled;
use crate::wgsl::{Mode, generate};

/// The scene's own section, with its numbers baked in.
#[derive(Default)]
pub struct Listing {
    compiled: Option<Arc<Compiled>>,
    /// None until somebody looks.
    text: Option<String>,
}

impl Listing {
    /// Another version of the scene is shown.
    pub fn take(&mut self, compiled: &Arc<Compiled>) {
        self.compiled = Some(compiled.clone());
        self.text = None;
    }

    fn text(&mut self) -> &str {
        let compiled = self.compiled.as_ref();
        self.text.get_or_insert_with(|| {
            compiled.map_or(String::new(), |c| generate(&c.scene, Mode::Baked).generated().to_owned())
        })
    }
}

impl Panel {
    pub(super) fn shader(&mut self, ui: &mut Ui) {
        let marked = self.selected_object().map(|name| name.to_owned());
        let text = self.listing.text().to_owned();
        ui.horizontal(|ui| {
            ui.label(RichText::new(format!("{} lines", text.lines().count())).weak());
            if ui.small_button("Copy").clicked() {
                ui.ctx().copy_text(text.clone());
            }
        });
        let job = colored(&text, marked.as_deref(), ui.visuals().dark_mode);
        egui::ScrollArea::both().auto_shrink([false, false]).show(ui, |ui| {
            ui.add(egui::Label::new(job).wrap_mode(egui::TextWrapMode::Extend).selectable(true));
        });
    }

    /// The name by which the shader calls the chosen object.
    fn selected_object(&self) -> Option<String> {
        let index = self.chosen()?.object?;
        let line =
            self.listing.text.as_ref()?.lines().find(|line| {
                line.starts_with("const OBJECT_") && line.ends_with(&format!("u32 = {index}u;"))
            })?;
        line.split([' ', ':']).nth(1).map(str::to_owned)
    }
}

/// `text` as WGSL is colored; lines that name `marked` have another background.
fn colored(text: &str, marked: Option<&str>, is_dark: bool) -> LayoutJob {
    let ink = |dark: [u8; 3], light: [u8; 3]| {
        let [r, g, b] = if is_dark { dark } else { light };
        Color32::from_rgb(r, g, b)
    };
    let plain = ink([212, 212, 212], [40, 40, 40]);
    let comment = ink([110, 140, 110], [80, 120, 80]);
    let keyword = ink([130, 170, 255], [20, 60, 180]);
    let number = ink([230, 170, 110], [160, 80, 0]);
    let kind = ink([100, 200, 200], [0, 110, 120]);
    let mark = ink([58, 62, 82], [222, 228, 255]);
    let mut job = LayoutJob::default();
    for line in text.split_inclusive('\n') {
        let background = match marked {
            Some(name) if line.contains(name) => mark,
            _ => Color32::TRANSPARENT,
        };
        let mut put = |word: &str, color: Color32| {
            let font_id = FontId::monospace(11.5);
            job.append(word, 0.0, TextFormat { font_id, color, background, ..Default::default() });
        };
        let (code, remark) = line.find("//").map_or((line, ""), |at| line.split_at(at));
        for word in words(code) {
            put(
                word,
                match word {
                    "fn" | "let" | "var" | "const" | "return" | "if" | "else" | "for" | "switch" | "case"
                    | "default" | "break" | "struct" | "true" | "false" => keyword,
                    _ if word.starts_with(|c: char| c.is_ascii_digit()) => number,
                    "f32" | "u32" | "i32" | "bool" | "vec2f" | "vec3f" | "vec4f" => kind,
                    _ if word.starts_with(|c: char| c.is_ascii_uppercase()) => kind,
                    _ => plain,
                },
            );
        }
        put(remark, comment);
    }
    job
}

/// Stretches of letters and digits, and what lies between them.
fn words(code: &str) -> Vec<&str> {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '.';
    let mut words = vec![];
    let mut rest = code;
    while let Some(first) = rest.chars().next() {
        let end = rest.find(|c| is_word(c) != is_word(first)).unwrap_or(rest.len());
        let (word, after) = rest.split_at(end);
        words.push(word);
        rest = after;
    }
    words
}
