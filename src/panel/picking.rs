//! What lies under the pointer: a click chooses it, an outline shows what is chosen.

use egui::{Color32, ColorImage, RichText, TextureHandle, TextureOptions, Ui};
use glam::{Vec2, Vec3};

use super::handles::Viewport;
use super::{ACCENT, Panel};
use crate::engine::focus::Focus;
use crate::gpu::{Identity, Seen, gizmo};
use crate::ir::Light;
use crate::outline::{Node, NodeKind};
use crate::panel::editor;
use crate::panel::handles::to_segment;
use crate::scene::Path;

/// How far from a light's gizmo a click chooses it, points.
const NEAR: f32 = 5.0;

/// What is known of the pixels of the picture, and what is asked of it.
#[derive(Default)]
pub struct Picking {
    identity: Option<Box<Identity>>,
    /// The pixel of a click that waits for an answer.
    wanted: Option<[u32; 2]>,
    seen: Option<Seen>,
    /// Whether a click was answered that nobody has heard of.
    is_new: bool,
    /// The outline of these objects.
    outline: Option<(Vec<u32>, TextureHandle)>,
}

impl Picking {
    /// The picture has changed.
    pub fn forget(&mut self) {
        self.identity = None;
        self.outline = None;
    }

    /// Something else is chosen than what was clicked.
    pub fn give_up(&mut self) {
        self.wanted = None;
    }
}

impl Panel {
    /// What lies under each pixel of the picture as it is now.
    pub fn know(&mut self, identity: Box<Identity>) {
        self.picking.identity = Some(identity);
        self.picking.outline = None;
        self.pick();
    }

    /// Where a click has chosen something since the last call: the object's name, or none.
    pub fn take_choice(&mut self) -> Option<Option<String>> {
        std::mem::take(&mut self.picking.is_new).then(|| self.chosen().map(|node| node.label.clone()))
    }

    /// Whether somebody wants to know what lies under the pixels.
    pub(super) fn asks(&self) -> bool {
        let is_open = self.picking.wanted.is_some() || !self.chosen_objects().is_empty();
        is_open && !matches!(self.focus, Focus::Material(_))
    }

    /// Chooses what lies under a pixel of the picture in `area`: a light where its gizmo does.
    pub(super) fn click(&mut self, ui: &Ui, area: egui::Rect, pixel: [u32; 2]) {
        if let Some(light) = self.frame(ui, area).and_then(|frame| self.light_at(&frame, pixel)) {
            self.picking.wanted = None;
            self.picking.seen = None;
            self.picking.is_new = true;
            self.selected = Some(Path::default().field("lights").item(light));
            return;
        }
        self.picking.wanted = Some(pixel);
        self.pick();
    }

    /// The light whose gizmo is shown nearest to a pixel.
    fn light_at(&self, frame: &Viewport, pixel: [u32; 2]) -> Option<usize> {
        let is_shown = self.gizmos && !matches!(self.focus, Focus::Material(_));
        let scene = &self.compiled.as_ref().filter(|_| is_shown)?.scene;
        let camera = self.camera.or(self.home)?;
        let (lens, at) = (&frame.lens, Vec2::from(pixel.map(|x| x as f32 + 0.5)));
        let away = |light: &Light| {
            let lines = gizmo::light(light, &camera).into_iter();
            let seen = lines.filter(|line| [line.from, line.to].iter().all(|end| lens.depth(*end) > 0.0));
            let away = seen.map(|line| to_segment(at, lens.pixel(line.from), lens.pixel(line.to)));
            away.min_by(f32::total_cmp)
        };
        let all = scene.lights.iter().enumerate().filter_map(|(i, light)| Some((i, away(light)?)));
        let near = all.filter(|(_, away)| *away < NEAR * frame.scale);
        near.min_by(|(_, a), (_, b)| a.total_cmp(b)).map(|(light, _)| light)
    }

    fn pick(&mut self) {
        let Some(identity) = &self.picking.identity else { return };
        let Some([x, y]) = self.picking.wanted.take() else { return };
        self.picking.seen = identity.at(x, y);
        self.picking.is_new = true;
        self.selected = self.picking.seen.and_then(|seen| {
            let (outline, _) = self.outline.as_ref()?;
            outline.object(seen.object as usize).map(|node| node.path.clone())
        });
    }

    /// Draws the outline of what is chosen, and says what was clicked.
    pub(super) fn show_choice(&mut self, ui: &mut Ui, area: egui::Rect) {
        let chosen = self.chosen_objects();
        if chosen.is_empty() {
            self.picking.outline = None;
        } else if self.picking.outline.as_ref().is_none_or(|(objects, _)| *objects != chosen) {
            self.picking.outline = self.picking.identity.as_ref().map(|identity| {
                let image = outlined(identity, &chosen, ui.ctx().pixels_per_point());
                (chosen, ui.ctx().load_texture("outline", image, TextureOptions::NEAREST))
            });
        }
        if let Some((_, texture)) = &self.picking.outline {
            let whole = egui::Rect::from_min_max(egui::pos2(0.0, 0.0), egui::pos2(1.0, 1.0));
            ui.painter().image(texture.id(), area, whole, Color32::WHITE);
        }
        let is_chosen =
            |seen: &Seen| self.chosen().is_some_and(|node| node.object == Some(seen.object as usize));
        if let Some(seen) = self.picking.seen.filter(is_chosen) {
            self.say(ui, area, &seen);
        }
    }

    fn say(&mut self, ui: &mut Ui, area: egui::Rect, seen: &Seen) {
        let Some(compiled) = &self.compiled else { return };
        let Some(object) = compiled.scene.primitives.get(seen.object as usize) else { return };
        let material = &compiled.scene.materials[object.material].name;
        let line = self.line_of_choice();
        let text = format!(
            "{}   material {material}\nposition {}   uv {:.3} {:.3}\nnormal {}   {:.3} away",
            object.name,
            triple(seen.position),
            seen.uv.x,
            seen.uv.y,
            triple(seen.normal),
            seen.distance,
        );
        let (mut closes, mut opens) = (false, false);
        egui::Area::new(egui::Id::unique("picked"))
            .order(egui::Order::Background)
            .fixed_pos(area.min + egui::vec2(10.0, 10.0))
            .show(ui.ctx(), |ui| {
                let frame = egui::Frame::NONE.fill(Color32::from_black_alpha(170)).corner_radius(6);
                frame.inner_margin(8.0).show(ui, |ui| {
                    let text = RichText::new(text).monospace().size(11.5).color(Color32::from_gray(225));
                    ui.label(text);
                    ui.horizontal(|ui| {
                        if let Some(line) = line {
                            let link = RichText::new(format!("open line {line}")).color(ACCENT).small();
                            opens = ui.link(link).clicked();
                        }
                        closes = ui.link(RichText::new("close").color(ACCENT).small()).clicked();
                    });
                });
            });
        if opens && let Some(line) = line {
            self.notice = editor::open(&self.scene, line).err();
        }
        if closes {
            self.picking.seen = None;
        }
    }

    /// The line of the scene's file at which what is chosen begins.
    fn line_of_choice(&self) -> Option<usize> {
        let start = self.chosen()?.span.as_ref()?.start;
        let (_, text) = self.outline.as_ref()?;
        Some(1 + text.get(..start)?.matches('\n').count())
    }

    /// What is chosen in the tree.
    pub(super) fn chosen(&self) -> Option<&Node> {
        let (outline, _) = self.outline.as_ref()?;
        find(&outline.nodes, self.selected.as_ref()?)
    }

    /// The objects that are chosen: one, those of a solid, or those of a material.
    pub(super) fn chosen_objects(&self) -> Vec<u32> {
        let (Some(node), Some(compiled)) = (self.chosen(), &self.compiled) else { return vec![] };
        let scene = &compiled.scene;
        match node.kind {
            NodeKind::Material => {
                let has_it = |i: &usize| scene.materials[scene.primitives[*i].material].name == node.label;
                (0..scene.primitives.len()).filter(has_it).map(|i| i as u32).collect()
            }
            NodeKind::Object | NodeKind::Csg => objects_of(node),
            _ => vec![],
        }
    }
}

fn triple(v: Vec3) -> String {
    format!("{:.3} {:.3} {:.3}", v.x, v.y, v.z)
}

/// The node at `path`.
pub fn find<'n>(nodes: &'n [Node], path: &Path) -> Option<&'n Node> {
    nodes.iter().find_map(|node| if node.path == *path { Some(node) } else { find(&node.nodes, path) })
}

fn objects_of(node: &Node) -> Vec<u32> {
    let own = node.object.map(|object| object as u32);
    own.into_iter().chain(node.nodes.iter().flat_map(objects_of)).collect()
}

/// The outline of `objects`, a point of the screen wide, which is so many pixels.
fn outlined(identity: &Identity, objects: &[u32], point: f32) -> ColorImage {
    let [width, height] = identity.size().map(|n| n as usize);
    let wide = point.round().max(1.0) as usize;
    let mut image = ColorImage::filled([width, height], Color32::TRANSPARENT);
    for [x, y] in identity.outline(|object| objects.contains(&object)) {
        let [x, y] = [x as usize, y as usize];
        let pixels = (y..height.min(y + wide)).flat_map(|y| (x..width.min(x + wide)).map(move |x| (x, y)));
        pixels.for_each(|pixel| image[pixel] = ACCENT);
    }
    image
}
