//! What a picture was made of, which its PNG file carries: so it can be made again, and changed.

use std::io::Cursor;
use std::path::Path;

use super::Shot;
use crate::frame::{Moment, View};

/// The scene, and what else makes the picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Origin {
    /// The text of the scene, but not of the files that it names.
    pub scene: String,
    /// What it is, and how much: ("time", "1.5").
    pub notes: Vec<(String, String)>,
}

/// What each keyword begins with, as other programs put texts into PNG files, too.
const PREFIX: &str = "raytoy ";
const SCENE: &str = "scene";

impl Origin {
    /// What the pictures of `shot` are made of, their size aside.
    pub fn of(shot: &Shot<'_>) -> Self {
        let Shot { compiled, moment, .. } = shot;
        let own = Moment::of(&compiled.scene);
        let path = Path::new(&compiled.scene.name);
        // The folders are of this machine, and nobody else's business.
        let file = path.file_name().unwrap_or_default().to_string_lossy();
        let mut notes = vec![
            ("version", env!("CARGO_PKG_VERSION").to_owned()),
            ("file", file.into_owned()),
            ("time", moment.time.to_string()),
            ("view", moment.view.name().to_owned()),
            ("samples", shot.samples.to_string()),
        ];
        if let Some(split) = moment.split {
            notes.push(("split", format!("{} from {} on", split.view.name(), split.at)));
        }
        let views = [Some(moment.view), moment.split.map(|split| split.view)];
        if let Some(measure) = compiled.scene.measure.filter(|_| views.contains(&Some(View::Value))) {
            let name = measure.name(&compiled.scene);
            notes.push(("value", format!("{name}, to {}", moment.reach)));
        }
        if moment.camera != own.camera {
            let camera = moment.camera;
            let [eye, target, up] = [camera.eye, camera.target, camera.up].map(|v| (v.x, v.y, v.z));
            let fov = camera.fov.to_degrees();
            notes.push(("camera", format!("(eye: {eye:?}, target: {target:?}, up: {up:?}, fov_deg: {fov})")));
        }
        if moment.mouse != own.mouse {
            notes.push(("mouse", format!("{}, {}", moment.mouse[0], moment.mouse[1])));
        }
        let notes = notes.into_iter().map(|(what, text)| (what.to_owned(), text)).collect();
        Self { scene: compiled.text.to_string(), notes }
    }

    /// What the PNG file of `bytes` carries; none where raytoy did not write it.
    ///
    /// # Errors
    /// Why it is no PNG file.
    pub fn read(bytes: &[u8]) -> Result<Option<Self>, String> {
        let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info().map_err(|e| e.to_string())?;
        // Programs that change a picture may put the texts behind it.
        reader.finish().map_err(|e| e.to_string())?;
        let mut scene = None;
        let mut notes = vec![];
        for chunk in &reader.info().utf8_text {
            let Some(keyword) = chunk.keyword.strip_prefix(PREFIX) else { continue };
            let text = chunk.get_text().map_err(|e| e.to_string())?;
            if keyword == SCENE {
                scene = Some(text);
            } else {
                notes.push((keyword.to_owned(), text));
            }
        }
        Ok(scene.map(|scene| Self { scene, notes }))
    }

    /// The keyword and the text of each chunk.
    pub(super) fn chunks(&self) -> impl Iterator<Item = (String, String)> {
        let scene = std::iter::once((SCENE, self.scene.as_str()));
        let notes = self.notes.iter().map(|(what, text)| (what.as_str(), text.as_str()));
        scene.chain(notes).map(|(what, text)| (format!("{PREFIX}{what}"), text.to_owned()))
    }
}
