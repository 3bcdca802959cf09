//! What is known of the tile that is marked: caption, signature, parameters, and what to do with it.

use egui::{Button, Frame, Label, RichText, ScrollArea, Ui};

use super::{Action, TileImage};
use crate::engine::thumbnails::{Definition, Item, Subject};
use crate::library::{Function, Kind, Parameter};

/// Lays it out. `copied` is the text that was copied last.
pub fn show(
    ui: &mut Ui,
    item: Option<&Item>,
    image_of: Option<&TileImage>,
    copied: &mut Option<String>,
) -> Option<Action> {
    let Some(item) = item else {
        let hint = "Click a scene to open it. Click a texture or a shape to see its parameters.";
        ui.label(RichText::new(hint).weak());
        return None;
    };
    ui.label(RichText::new(&item.name).strong().size(16.0));
    let mut action = None;
    match (&item.subject, &item.definition) {
        (Subject::Scene(path), _) => {
            ui.add(Label::new(RichText::new(path.display().to_string()).weak().size(11.0)).truncate());
            ui.label(&item.caption);
            ui.add_space(6.0);
            if ui.button("Open").clicked() {
                action = Some(Action::Open(path.clone()));
            }
        }
        (_, Some(definition)) => {
            let function = &definition.function;
            let origin = format!("{}, from {}", kind(function), function.file);
            ui.add(Label::new(RichText::new(&origin).weak().size(11.0)).truncate()).on_hover_text(origin);
            ui.label(&function.caption);
            ui.add_space(6.0);
            action = buttons(ui, definition, copied);
            ui.add_space(6.0);
        }
        (_, None) => {}
    }
    ScrollArea::vertical().id_salt("details").auto_shrink([false, false]).show(ui, |ui| {
        if let Some(TileImage::Failure(why)) = image_of {
            ui.label(RichText::new(why).monospace().size(11.0));
        }
        if let Some(definition) = &item.definition {
            Frame::NONE.fill(ui.visuals().faint_bg_color).corner_radius(6).inner_margin(8.0).show(ui, |ui| {
                ui.set_width(ui.available_width());
                ui.label(RichText::new(&definition.full_call).monospace().size(11.5));
            });
            ui.add_space(4.0);
            definition.function.parameters.iter().for_each(|given| parameter(ui, given));
        }
    });
    action
}

fn buttons(ui: &mut Ui, definition: &Definition, copied: &mut Option<String>) -> Option<Action> {
    let Definition { function, call, full_call } = definition;
    let mut adds = false;
    ui.horizontal_wrapped(|ui| {
        for (name, text) in [("Copy", call), ("Copy all", full_call)] {
            if ui.button(name).on_hover_text(text).clicked() {
                ui.ctx().copy_text(text.clone());
                *copied = Some(text.clone());
            }
        }
        if function.kind == Kind::Shape {
            adds = ui.add(Button::new("Add")).on_hover_text("add one to the scene").clicked();
        }
        if copied.as_ref().is_some_and(|text| text == call || text == full_call) {
            ui.label(RichText::new("copied").weak().size(11.0));
        }
    });
    adds.then(|| Action::Add(function.name.clone()))
}

fn kind(function: &Function) -> String {
    let noun = function.kind.noun();
    let more = match function.traits {
        _ if function.kind != Kind::Shape => "",
        traits if traits.is_distance => " found by ray marching",
        traits if traits.is_open => " without an inside",
        _ => "",
    };
    format!("a {noun}{more}")
}

fn parameter(ui: &mut Ui, parameter: &Parameter) {
    ui.add_space(6.0);
    ui.horizontal_wrapped(|ui| {
        ui.label(RichText::new(&parameter.name).strong().monospace().size(12.0));
        let limits = match (&parameter.range, parameter.choices.as_slice()) {
            (_, [_, ..]) => format!("one of {}", parameter.choices.join(", ")),
            _ if parameter.is_color => "a color".to_owned(),
            (Some((low, high)), _) => format!("{low} to {high}"),
            (None, _) => parameter.ty.describe().to_owned(),
        };
        ui.label(RichText::new(limits).weak().size(11.0));
    });
    ui.label(RichText::new(&parameter.doc).weak());
}
