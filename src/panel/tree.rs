//! The scene as a tree: what there is, what is chosen, and what can be added or taken away.

use std::sync::Arc;

use egui::accesskit::Role as WidgetRole;
use egui::{Align, Color32, Layout, Rect, RichText, Sense, Ui, Vec2, WidgetInfo};

use crate::edit::{Edit, NewValue};
use crate::outline::{Node, NodeKind, Outline, Role};
use crate::scene::{Path, parse};

/// Lays out the nodes of an outline.
pub struct Tree<'a> {
    pub edits: &'a mut Vec<Edit>,
    pub selected: &'a mut Option<Path>,
    /// Only nodes with this in their name, if it is not empty.
    pub wanted: &'a str,
    /// RON text of something new with no more than it must be given; None where a file for it is missing.
    pub example: &'a dyn Fn(Role, &str) -> Option<String>,
    /// Of the scene.
    pub text: &'a str,
}

impl Tree<'_> {
    pub fn show(&mut self, ui: &mut Ui, outline: &Outline) {
        ui.spacing_mut().item_spacing.y = 1.0;
        for node in &outline.nodes {
            self.node(ui, node, outline, 0);
        }
    }

    fn node(&mut self, ui: &mut Ui, node: &Node, outline: &Outline, depth: usize) {
        if !self.is_wanted(node) {
            return;
        }
        let holds = matches!(
            node.kind,
            NodeKind::Lights | NodeKind::Textures | NodeKind::Materials | NodeKind::Objects
        );
        let id = ui.make_persistent_id(node.path.to_string());
        let is_open = ui.data_mut(|data| *data.get_persisted_mut_or(id, true));
        let is_open = is_open || !self.wanted.is_empty();
        self.line(ui, node, outline, depth, holds, is_open, id);
        if is_open {
            for inner in &node.nodes {
                self.node(ui, inner, outline, depth + 1);
            }
        }
    }

    fn is_wanted(&self, node: &Node) -> bool {
        let wanted = self.wanted.to_lowercase();
        let names = [Some(&node.label), node.name.as_ref()];
        let fits = names.into_iter().flatten().any(|name| name.to_lowercase().contains(&wanted));
        fits || node.nodes.iter().any(|inner| self.is_wanted(inner))
    }

    #[expect(clippy::too_many_arguments, reason = "all of a line's timings, used once")]
    fn line(
        &mut self,
        ui: &mut Ui,
        node: &Node,
        outline: &Outline,
        depth: usize,
        holds: bool,
        is_open: bool,
        id: egui::Id,
    ) {
        let size = Vec2::new(ui.available_width(), 20.0);
        let (area, response) = ui.allocate_exact_size(size, Sense::click());
        let is_selected = self.selected.as_ref() == Some(&node.path);
        response.widget_info(|| WidgetInfo::labeled(WidgetRole::TreeItem, true, &node.label));
        ui.ctx().accesskit_node_builder(response.id, |line| {
            line.set_level(depth + 1);
            line.set_selected(is_selected);
            if !node.nodes.is_empty() {
                line.set_expanded(is_open);
            }
        });
        let visuals = ui.visuals();
        if is_selected || response.hovered() {
            let fill = if is_selected { visuals.selection.bg_fill } else { visuals.faint_bg_color };
            ui.painter().rect_filled(area, 4.0, fill);
        }
        if is_selected {
            reveal(ui, area, &node.path);
        }
        let mut ui = ui.new_child(
            egui::UiBuilder::new()
                .max_rect(area.shrink2(Vec2::new(4.0, 0.0)))
                .layout(Layout::left_to_right(Align::Center)),
        );
        ui.add_space(12.0 * depth as f32);
        if node.nodes.is_empty() {
            ui.add_space(14.0);
        } else {
            let (area, response) = ui.allocate_exact_size(Vec2::splat(14.0), Sense::click());
            let (openness, does) = if is_open { (1.0, "close") } else { (0.0, "open") };
            let name = format!("{does} {}", node.label);
            response.widget_info(|| WidgetInfo::labeled(WidgetRole::DisclosureTriangle, true, &name));
            egui::collapsing_header::paint_default_icon(
                &mut ui,
                openness,
                &response.clone().with_new_rect(area.shrink(3.0)),
            );
            if response.clicked() {
                ui.data_mut(|data| data.insert_persisted(id, !is_open));
            }
        }
        dot(&mut ui, color(node.kind));
        let label = RichText::new(&node.label);
        let label = match node.span {
            _ if is_selected => label.strong(),
            Some(_) => label,
            None => label.weak(),
        };
        ui.add(egui::Label::new(label).truncate().selectable(false));
        if let Some(name) = node.name.as_ref().filter(|name| !node.label.starts_with(name.as_str())) {
            ui.add(egui::Label::new(RichText::new(name).weak().small()).truncate().selectable(false));
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if holds {
                self.add_menu(ui, node, outline);
            }
        });
        let response = response.on_hover_text(&node.doc);
        if response.clicked() {
            *self.selected = Some(node.path.clone());
        }
        let is_item = matches!(node.kind, NodeKind::Light | NodeKind::Object | NodeKind::Csg)
            || matches!(node.kind, NodeKind::Texture | NodeKind::Material);
        if is_item {
            response.context_menu(|ui| self.item_menu(ui, node, outline));
        }
    }

    fn item_menu(&mut self, ui: &mut Ui, node: &Node, outline: &Outline) {
        if ui.button("Duplicate").clicked() {
            self.edits.push(Edit::Duplicate { path: node.path.clone() });
            ui.close();
        }
        let uses = match node.kind {
            NodeKind::Texture | NodeKind::Material => outline.uses(node),
            _ => vec![],
        };
        let paths: Vec<String> = uses.iter().map(|field| field.path.to_string()).collect();
        let removed = outline.to_remove(node);
        let remove = ui.button(match paths.len() {
            0 if removed.path != node.path => {
                format!("Remove, with \"{}\", which has no other part", removed.label)
            }
            0 => "Remove".to_owned(),
            1 => "Remove, and write its value where it is used".to_owned(),
            count => format!("Remove, and write its value in {count} places"),
        });
        let remove = if paths.is_empty() { remove } else { remove.on_hover_text(paths.join("\n")) };
        if remove.clicked() {
            if let Some(words) = self.words(node) {
                self.edits.extend(uses.iter().map(|field| Edit::Set {
                    path: field.path.clone(),
                    value: NewValue::Code(words.clone()),
                }));
            }
            self.edits.push(Edit::Remove { path: removed.path.clone() });
            ui.close();
        }
    }

    /// What a declared texture or material says, without its name.
    fn words(&self, node: &Node) -> Option<String> {
        let root = parse("", self.text).ok()?;
        root.at(&node.path).map(|value| self.text[value.span.clone()].to_owned())
    }

    /// A menu of what the list `node` could have one more of.
    fn add_menu(&mut self, ui: &mut Ui, node: &Node, outline: &Outline) {
        let names = &outline.names;
        let (role, kinds): (Role, &Arc<[String]>) = match node.kind {
            NodeKind::Lights => (Role::Light, &names.lights),
            NodeKind::Objects => (Role::Solid, &names.solids),
            // Entries of a map need a name of their own, which the author writes.
            _ => return,
        };
        let menu = ui.menu_button("+", |ui| {
            egui::ScrollArea::vertical().max_height(360.0).show(ui, |ui| {
                for name in kinds.iter() {
                    if ui.button(name).clicked() {
                        let (list, index) = (node.path.clone(), node.nodes.len());
                        let item = (self.example)(role, name);
                        self.edits.extend(item.map(|item| Edit::Insert { list, index, item }));
                        ui.close();
                    }
                }
            });
        });
        menu.response.on_hover_text("add one").accessible_name(format!("add to {}", node.label));
    }
}

/// Brings what was chosen elsewhere into sight, once.
fn reveal(ui: &Ui, area: Rect, path: &Path) {
    let id = egui::Id::unique("revealed");
    let path = path.to_string();
    if ui.data(|data| data.get_temp(id)) != Some(path.clone()) {
        ui.scroll_to_rect(area, None);
        ui.data_mut(|data| data.insert_temp(id, path));
    }
}

fn dot(ui: &mut Ui, color: Color32) {
    let (area, _) = ui.allocate_exact_size(Vec2::splat(10.0), Sense::hover());
    ui.painter().circle_filled(area.center(), 3.5, color);
}

fn color(kind: NodeKind) -> Color32 {
    match kind {
        NodeKind::Camera => Color32::from_rgb(120, 170, 255),
        NodeKind::Background | NodeKind::Ambient => Color32::from_rgb(110, 190, 220),
        NodeKind::Lights | NodeKind::Light => Color32::from_rgb(250, 205, 90),
        NodeKind::Textures | NodeKind::Texture => Color32::from_rgb(200, 130, 230),
        NodeKind::Materials | NodeKind::Material => Color32::from_rgb(240, 130, 100),
        NodeKind::Objects | NodeKind::Object => Color32::from_rgb(120, 210, 140),
        NodeKind::Csg => Color32::from_rgb(90, 180, 170),
        NodeKind::Render => Color32::from_gray(150),
    }
}
