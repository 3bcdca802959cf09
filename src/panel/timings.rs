//! How long a picture takes: the tab `Timings`.

use egui::{RichText, Ui};

use crate::engine::messages::Picture;

/// Names and figures of `picture`.
pub fn of(picture: &Picture) -> Vec<(&'static str, String)> {
    let ms = |time: std::time::Duration| format!("{:.1} ms", time.as_secs_f64() * 1e3);
    let times = picture.compiled.times;
    let per_second = 1.0 / picture.frame_time.as_secs_f64().max(1e-6);
    vec![
        ("frame", ms(picture.frame_time)),
        ("rate", format!("{per_second:.0} per second")),
        ("samples", format!("{}", picture.samples)),
        ("parse", ms(times.parse)),
        ("resolve", ms(times.resolve)),
        ("generate", ms(times.generate)),
        ("naga", ms(times.naga)),
        ("pipeline", ms(picture.pipeline_time)),
        ("objects", format!("{}", picture.compiled.scene.primitives.len())),
        ("shader", format!("{:.1} KB", picture.compiled.source.text().len() as f64 / 1e3)),
    ]
}

pub fn show(ui: &mut Ui, adapter: &str, timings: &[(&str, String)]) {
    ui.label(RichText::new(adapter).weak());
    ui.add_space(6.0);
    egui::Grid::new("timings").num_columns(2).spacing([16.0, 3.0]).show(ui, |ui| {
        for (name, value) in timings {
            ui.label(RichText::new(*name).weak());
            ui.label(RichText::new(value).monospace());
            ui.end_row();
        }
    });
}
