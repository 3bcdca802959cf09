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

#[cfg(test)]
mod tests {
    use super::*;

    fn looking_from(x: f32) -> Camera {
        Camera { eye: Vec3::new(x, 0.0, 0.0), target: Vec3::ZERO, up: Vec3::Y, fov: 0.7 }
    }

    #[test]
    fn cameras_are_kept_by_their_digits_and_come_back_as_they_were() {
        let mut kept = Bookmarks::default();
        for (digit, x) in [(3, 3.0), (1, 1.1), (3, 4.0)] {
            kept.keep(digit, &looking_from(x));
        }
        let digits: Vec<u8> = kept.all().iter().map(|known| known.digit).collect();
        assert_eq!(digits, [1, 3]);
        assert_eq!(kept.all()[1].camera(), looking_from(4.0));
        let told = serde_json::to_string(&kept).expect("it is JSON");
        assert_eq!(serde_json::from_str::<Bookmarks>(&told).expect("it is JSON"), kept);
    }

    #[test]
    fn a_name_stays_where_the_camera_is_another_and_goes_with_it() {
        let mut kept = Bookmarks::default();
        kept.keep(2, &looking_from(1.0));
        assert_eq!(kept.all()[0].title(), "camera 2");
        kept.rename(2, "front".into());
        kept.keep(2, &looking_from(2.0));
        assert_eq!(kept.all()[0].title(), "front");
        assert_eq!(free_digit(kept.all()), Some(1));
        kept.remove(2);
        kept.keep(2, &looking_from(1.0));
        assert_eq!(kept.all()[0].title(), "camera 2");
    }

    #[test]
    fn there_are_nine() {
        let mut kept = Bookmarks::default();
        while let Some(digit) = free_digit(kept.all()) {
            kept.keep(digit, &looking_from(1.0));
        }
        assert_eq!(kept.all().len(), 9);
    }
}
