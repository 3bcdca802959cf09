//! The handles of what is chosen: the hand takes one, and what it does becomes edits.

use egui::{CursorIcon, Event, Key, Pos2, Rect, Response, Ui, pos2, vec2};
use glam::{Vec2, Vec3};

use super::{Ball, Direction, Handle, Known, Movable, Place, Tripod, movables};
use crate::edit::{Edit, NewValue};
use crate::engine::focus::Focus;
use crate::frame::Lens;
use crate::ir::Value;
use crate::panel::Panel;

/// Digits behind the point where the hand moves in steps: steps of 0.1.
const SNAP: i32 = 1;

/// What the hand does with the handles.
#[derive(Default)]
pub struct Handles {
    held: Option<Held>,
    /// What the hand has done and nobody has asked for yet.
    pub edits: Vec<Edit>,
    /// Whether it has taken back what it did.
    pub takes_back: bool,
}

/// A handle in the hand.
struct Held {
    grip: Grip,
    /// Of the movables when it was taken.
    index: usize,
    from: Movable,
    now: Movable,
    /// Where it was taken, pixels of the picture.
    start: Vec2,
    /// Then, too.
    frame: Viewport,
    /// Whether it was taken back, and is to do nothing until the hand lets go.
    is_over: bool,
}

/// What of a movable is in the hand.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Grip {
    Of(Handle),
    Knob,
}

/// A movable as it is shown.
pub struct Shown {
    pub movable: Movable,
    pub lit: Option<Grip>,
    /// Where it was when the hand took it.
    pub from: Option<Movable>,
}

/// From points of the screen to pixels of the picture.
#[derive(Clone, Copy)]
pub struct Viewport {
    pub lens: Lens,
    pub corner: Pos2,
    /// Pixels to a point.
    pub scale: f32,
}

impl Viewport {
    pub fn pixel(&self, at: Pos2) -> Vec2 {
        let away = (at - self.corner) * self.scale;
        Vec2::new(away.x, away.y)
    }

    pub fn point(&self, pixel: Vec2) -> Pos2 {
        let away = pixel / self.scale;
        self.corner + vec2(away.x, away.y)
    }

    pub fn tripod(&self, place: Vec3) -> Option<Tripod> {
        Tripod::new(self.lens, place, self.scale)
    }

    pub fn ball(&self) -> Ball {
        Ball { lens: self.lens, scale: self.scale }
    }
}

impl Handles {
    /// Whether the hand is about to move something.
    pub fn is_held(&self) -> bool {
        self.held.is_some()
    }
}

impl Panel {
    /// Lets the hand take handles and move them; whether it has one.
    pub(in crate::panel) fn take_handles(&mut self, ui: &Ui, response: &Response, area: Rect) -> bool {
        let Some(frame) = self.frame(ui, area) else {
            self.handles.held = None;
            return false;
        };
        let (is_down, is_drag, taken_at, pointer) = ui.input(|input| {
            let pointer = &input.pointer;
            // Where it was pressed: on a slow machine it may be elsewhere by now.
            let taken_at = pointer.press_origin().filter(|_| pointer.primary_pressed());
            (pointer.primary_down(), pointer.is_decidedly_dragging(), taken_at, pointer.interact_pos())
        });
        let (snaps, gives_up) = ui.input(|input| {
            // Ctrl counts as it was when the hand let go.
            let let_go = input.events.iter().find_map(|event| match event {
                Event::PointerButton { pressed: false, modifiers, .. } => Some(*modifiers),
                _ => None,
            });
            (let_go.unwrap_or(input.modifiers).command, input.key_pressed(Key::Escape))
        });
        if let Some(at) = taken_at.filter(|_| response.is_pointer_button_down_on()) {
            self.handles.held = self.take_one(&frame, frame.pixel(at));
        }
        let Some(held) = &mut self.handles.held else { return false };
        ui.ctx().set_cursor_icon(CursorIcon::Grabbing);
        if gives_up && !held.is_over {
            held.is_over = true;
            held.now = held.from.clone();
            self.handles.takes_back = true;
        }
        if let Some(at) = pointer.filter(|_| is_drag && !held.is_over)
            && let Some(now) = held.moved(frame.pixel(at), snaps)
            && now != held.now
        {
            self.handles.edits.extend(edits(&now));
            held.now = now;
        }
        // Not sooner: the last of the way may come with the news that the hand has let go.
        if !is_down {
            self.handles.held = None;
        }
        true
    }

    fn take_one(&self, frame: &Viewport, start: Vec2) -> Option<Held> {
        let mut movables = self.movables();
        let (index, grip) = under(frame, &movables, start)?;
        let from = movables.swap_remove(index);
        Some(Held { grip, index, now: from.clone(), from, start, frame: *frame, is_over: false })
    }

    /// What is to be drawn, where the pointer is at `hover`.
    pub(in crate::panel) fn shown_handles(&self, frame: &Viewport, hover: Option<Pos2>) -> Vec<Shown> {
        let movables = self.movables();
        let lit = match self.handles.held {
            Some(_) => None,
            None => hover.and_then(|at| under(frame, &movables, frame.pixel(at))),
        };
        let held = |index: usize| self.handles.held.as_ref().filter(|held| held.index == index);
        let shown = movables.into_iter().enumerate().map(|(index, movable)| match held(index) {
            Some(held) => {
                let lit = (!held.is_over).then_some(held.grip);
                Shown { movable: held.now.clone(), lit, from: Some(held.from.clone()) }
            }
            None => {
                let lit = lit.filter(|(lit, _)| *lit == index).map(|(_, grip)| grip);
                Shown { movable, lit, from: None }
            }
        });
        shown.collect()
    }

    fn movables(&self) -> Vec<Movable> {
        let (Some((outline, _)), Some(path), Some(compiled)) =
            (&self.outline, &self.selected, &self.compiled)
        else {
            return vec![];
        };
        if !self.settings.handles || matches!(self.focus, Focus::Material(_)) {
            return vec![];
        }
        let scene = &compiled.scene;
        // The middle of a model is that of its box.
        let middle = |object: usize| {
            let model = scene.primitives.get(object)?.arguments.iter().find_map(|argument| match argument {
                Value::Model(index) => scene.models.get(*index),
                _ => None,
            });
            let model = model?;
            let root = model.nodes.first()?;
            Some(model.origin.as_vec3() + 0.5 * (root.low + root.high))
        };
        let numbers = |path: &crate::scene::Path| self.pending.numbers(path);
        movables(outline, path, &Known { numbers: &numbers, middle: &middle })
    }

    /// The camera before the picture in `area`.
    pub(in crate::panel) fn frame(&self, ui: &Ui, area: Rect) -> Option<Viewport> {
        let camera = self.camera.or(self.home)?;
        let scale = ui.ctx().pixels_per_point();
        let pixels = |points: f32| (points * scale).round();
        let size = [pixels(area.width()), pixels(area.height())].map(|side| side as u32);
        let corner = pos2(pixels(area.min.x), pixels(area.min.y)) / scale;
        (!size.contains(&0)).then(|| Viewport { lens: Lens::new(&camera, size), corner, scale })
    }
}

impl Held {
    /// What it holds, once the pointer is at `pointer`; None where it points at nothing.
    fn moved(&self, pointer: Vec2, snaps: bool) -> Option<Movable> {
        match (&self.from, self.grip) {
            (Movable::Place(place), Grip::Of(handle)) => {
                let tripod = self.frame.tripod(place.at)?;
                let by = tripod.point(handle, pointer)? - tripod.point(handle, self.start)?;
                let fine = place.digits(self.frame.lens.pixel_size(place.at));
                Some(Movable::Place(place.moved(by, if snaps { SNAP } else { fine })))
            }
            (Movable::Direction(direction), Grip::Knob) => {
                let unit = self.frame.ball().turned(direction.value.normalize(), pointer - self.start);
                let digits = if snaps { SNAP } else { direction.digits() };
                direction.turned(unit, digits).map(Movable::Direction)
            }
            _ => None,
        }
    }
}

/// Which of `movables` the pointer would take, and by what.
fn under(frame: &Viewport, movables: &[Movable], pointer: Vec2) -> Option<(usize, Grip)> {
    movables.iter().enumerate().find_map(|(index, movable)| {
        let grip = match movable {
            Movable::Place(Place { at, .. }) => Grip::Of(frame.tripod(*at)?.under(pointer)?),
            Movable::Direction(Direction { value, .. }) => {
                frame.ball().is_under(pointer, value.normalize()).then_some(Grip::Knob)?
            }
        };
        Some((index, grip))
    })
}

fn edits(movable: &Movable) -> Vec<Edit> {
    let set = |path: &crate::scene::Path, value: Vec3| Edit::Set {
        path: path.clone(),
        value: NewValue::Vector(value.to_array().to_vec()),
    };
    match movable {
        Movable::Place(place) => place.points.iter().map(|(path, value)| set(path, *value)).collect(),
        Movable::Direction(Direction { path, value }) => vec![set(path, *value)],
    }
}
