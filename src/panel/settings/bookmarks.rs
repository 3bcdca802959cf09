//! Cameras of a scene to come back to, each under a digit, with a name if the author gives it one.

use glam::Vec3;
use serde::{Deserialize, Serialize};

use crate::ir::Camera;

/// Digits that there are.
pub const MAX_BOOKMARKS: u8 = 9;

/// The cameras that were kept of a scene, by their digits.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Bookmarks(Vec<Bookmark>);

/// A camera that was kept.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bookmark {
    /// 1 to [`MAX_BOOKMARKS`].
    pub digit: u8,
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub name: String,
    eye: [f32; 3],
    target: [f32; 3],
    up: [f32; 3],
    /// Vertical, radians.
    fov: f32,
}

impl Bookmarks {
    pub fn all(&self) -> &[Bookmark] {
        &self.0
    }

    /// Keeps `camera` under `digit`; what was there before leaves its name.
    pub fn keep(&mut self, digit: u8, camera: &Camera) {
        // JSON has no way to say infinity, and a file that says it otherwise counts as damaged.
        if !(camera.eye.is_finite() && camera.target.is_finite()) {
            return;
        }
        let place = self.0.iter().position(|known| known.digit >= digit).unwrap_or(self.0.len());
        match self.0.get_mut(place).filter(|known| known.digit == digit) {
            Some(known) => *known = Bookmark::new(digit, std::mem::take(&mut known.name), camera),
            None => self.0.insert(place, Bookmark::new(digit, String::new(), camera)),
        }
    }

    pub fn rename(&mut self, digit: u8, name: String) {
        self.0.iter_mut().filter(|known| known.digit == digit).for_each(|known| known.name.clone_from(&name));
    }

    pub fn remove(&mut self, digit: u8) {
        self.0.retain(|known| known.digit != digit);
    }
}

/// The first digit under which `bookmarks` have no camera.
pub fn free_digit(bookmarks: &[Bookmark]) -> Option<u8> {
    (1..=MAX_BOOKMARKS).find(|digit| bookmarks.iter().all(|known| known.digit != *digit))
}

impl Bookmark {
    fn new(digit: u8, name: String, camera: &Camera) -> Self {
        let Camera { eye, target, up, fov } = *camera;
        Self { digit, name, eye: eye.to_array(), target: target.to_array(), up: up.to_array(), fov }
    }

    pub fn camera(&self) -> Camera {
        let [eye, target, up] = [self.eye, self.target, self.up].map(Vec3::from_array);
        Camera { eye, target, up, fov: self.fov }
    }

    /// What to call it.
    pub fn title(&self) -> String {
        if self.name.is_empty() { format!("camera {}", self.digit) } else { self.name.clone() }
    }
}
