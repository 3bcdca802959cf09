//! The dialog by which a picture or a movie goes to a file.

use std::path::PathBuf;

use egui::{DragValue, ProgressBar, RichText, TextEdit, Ui};

use super::Panel;
use crate::capture::{Frames, MovieFormat};
use crate::engine::album;
use crate::frame::Moment;

/// What the author asked for last.
pub struct Dialog {
    is_open: bool,
    size: [u32; 2],
    samples: u32,
    seconds: f64,
    rate: f64,
    file: String,
    /// The share done of what is being taken.
    pub progress: Option<f32>,
    /// What came of the last one.
    pub result: Option<Result<String, String>>,
}

/// The wish of the person at the dialog.
pub enum Action {
    Take(Box<album::CaptureRequest>),
    Stop,
}

impl Dialog {
    /// For the scene whose file's name has this stem.
    pub fn new(stem: &str) -> Self {
        let file = format!("{stem}.png");
        let (size, samples, seconds, rate) = ([1920, 1080], 64, 4.0, 30.0);
        Self { is_open: false, size, samples, seconds, rate, file, progress: None, result: None }
    }

    pub fn toggle(&mut self) {
        self.is_open = !self.is_open;
        self.result = None;
    }
}

impl Panel {
    /// Asks `album` how far it is.
    pub fn follow(&mut self, album: &mut album::Album) {
        self.dialog.result = album.result().or(self.dialog.result.take());
        self.dialog.progress = album.progress();
    }

    pub(super) fn capture_dialog(&mut self, ui: &mut Ui) -> Option<Action> {
        let mut is_open = self.dialog.is_open;
        let mut action = None;
        egui::Window::new("Save a picture")
            .open(&mut is_open)
            .resizable(false)
            .default_pos(egui::pos2(390.0, 60.0))
            .show(ui.ctx(), |ui| action = self.capture_fields(ui));
        self.dialog.is_open = is_open;
        action
    }

    fn capture_fields(&mut self, ui: &mut Ui) -> Option<Action> {
        let is_movie = MovieFormat::of(self.dialog.file.as_ref()).is_some();
        let Dialog { size, samples, seconds, rate, file, progress, result, .. } = &mut self.dialog;
        egui::Grid::new("capture").num_columns(2).spacing([12.0, 6.0]).show(ui, |ui| {
            let name = ui.label("file");
            let hint = ".png, .exr, .mp4, .webm or .gif";
            let field = ui.add(TextEdit::singleline(file).desired_width(220.0)).on_hover_text(hint);
            field.labelled_by(name.id);
            ui.end_row();
            ui.label("pixels");
            ui.horizontal(|ui| {
                for (side, name) in size.iter_mut().zip(["width in pixels", "height in pixels"]) {
                    ui.add(DragValue::new(side).range(1..=16384)).accessible_name(name);
                }
            });
            ui.end_row();
            let name = ui.label("samples");
            ui.add(DragValue::new(samples).range(1..=65536)).labelled_by(name.id);
            ui.end_row();
            if is_movie {
                let name = ui.label("seconds");
                let number = DragValue::new(seconds).range(0.1..=600.0).speed(0.1);
                ui.add(number).labelled_by(name.id);
                ui.end_row();
                let name = ui.label("frames per second");
                ui.add(DragValue::new(rate).range(1.0..=120.0)).labelled_by(name.id);
                ui.end_row();
            }
        });
        if let Some(share) = *progress {
            let bar = ui.add(ProgressBar::new(share).desired_width(280.0).show_percentage());
            bar.accessible_name("progress");
            return ui.button("Stop").clicked().then_some(Action::Stop);
        }
        let takes = ui.button(if is_movie { "Save the movie" } else { "Save the picture" }).clicked();
        match result {
            Some(Ok(told)) => drop(ui.label(RichText::new(told.as_str()).weak())),
            Some(Err(why)) => drop(ui.colored_label(ui.visuals().error_fg_color, why.as_str())),
            None => {}
        }
        let compiled = self.compiled.clone().filter(|_| takes)?;
        let camera = self.camera.unwrap_or(compiled.scene.camera);
        let Dialog { size, samples, seconds, rate, file, .. } = &self.dialog;
        let (split, reach) = (self.divider.split(), self.gauge.reach());
        let own = Moment::of(&compiled.scene);
        let moment = Moment { camera, view: self.view, split, reach, time: self.clock.time(), ..own };
        let frames = Frames { numbers: 0..(seconds * rate).round().max(1.0) as u32, rate: *rate };
        let path = PathBuf::from(file);
        let (size, samples) = (*size, *samples);
        let moment = if self.moves { moment } else { Moment { time: 0.0, ..moment } };
        Some(Action::Take(Box::new(album::CaptureRequest { compiled, moment, size, samples, frames, path })))
    }
}
