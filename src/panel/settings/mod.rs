//! What the window remembers from one day to the next, as a small file in the user's own folder.
//!
//! In: a folder, or none where nothing is to be remembered. Out: [`Settings`]. A file that is missing or
//! damaged counts as none, and one that cannot be written is no reason to trouble anybody.

mod bookmarks;

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

pub use self::bookmarks::{Bookmark, Bookmarks, free_digit};
use crate::files::write_file;

/// Scenes that are remembered.
const RECENT: usize = 12;
/// How wide the panel beside the picture may be, points.
pub const PANEL: std::ops::RangeInclusive<f32> = 240.0..=640.0;
/// Sides of a window that a screen can show, points.
const SIDES: std::ops::RangeInclusive<u32> = 200..=16384;

/// What is remembered.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Settings {
    /// Of the window's inside, points.
    pub size: [u32; 2],
    /// Width of the panel beside the picture, points.
    pub panel: f32,
    pub theme: Theme,
    /// Whether what is chosen has handles.
    pub handles: bool,
    /// The scenes that were open, the last one first; absolute.
    pub recent: Vec<PathBuf>,
    /// Cameras of scenes, by the scene's absolute path.
    pub bookmarks: BTreeMap<PathBuf, Bookmarks>,
}

/// The window's colors.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Theme {
    Dark,
    Light,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            size: [1280, 720],
            panel: 320.0,
            theme: Theme::Dark,
            handles: true,
            recent: vec![],
            bookmarks: BTreeMap::new(),
        }
    }
}

impl Settings {
    /// Those in `folder`, within what a window can be.
    pub fn read(folder: &Path) -> Self {
        let text = std::fs::read_to_string(file(folder)).unwrap_or_default();
        let mut settings: Self = serde_json::from_str(&text).unwrap_or_default();
        settings.size = settings.size.map(|side| side.clamp(*SIDES.start(), *SIDES.end()));
        settings.panel = settings.panel.clamp(*PANEL.start(), *PANEL.end());
        settings.recent.truncate(RECENT);
        settings
    }

    /// Puts them into `folder`, which is made if need be.
    ///
    /// # Errors
    /// Where the file cannot be written.
    pub fn write(&self, folder: &Path) -> std::io::Result<()> {
        std::fs::create_dir_all(folder)?;
        let text = serde_json::to_string_pretty(self)? + "\n";
        write_file(&file(folder), text.as_bytes())
    }

    /// Puts `scene` before the others that were open.
    pub fn visit(&mut self, scene: &Path) {
        let Some(scene) = known_as(scene) else { return };
        self.recent.retain(|other| *other != scene);
        self.recent.insert(0, scene);
        self.recent.truncate(RECENT);
    }

    /// The cameras that were kept of `scene`.
    pub fn bookmarks(&self, scene: &Path) -> &[Bookmark] {
        known_as(scene).and_then(|scene| self.bookmarks.get(&scene)).map_or(&[], |kept| kept.all())
    }

    /// Does `change` to them.
    pub fn change_bookmarks(&mut self, scene: &Path, change: impl FnOnce(&mut Bookmarks)) {
        let Some(scene) = known_as(scene) else { return };
        let kept = self.bookmarks.entry(scene.clone()).or_default();
        change(kept);
        if kept.all().is_empty() {
            self.bookmarks.remove(&scene);
        }
    }
}

/// By what a scene is remembered; None where JSON has no way to say its path, which is not UTF-8.
fn known_as(scene: &Path) -> Option<PathBuf> {
    std::path::absolute(scene).ok().filter(|path| path.to_str().is_some())
}

/// Settings as their file has them.
pub struct Memory {
    folder: Option<PathBuf>,
    kept: Settings,
}

impl Memory {
    /// What `folder` holds; without one, nothing is remembered.
    pub fn open(folder: Option<PathBuf>) -> Self {
        let kept = folder.as_deref().map_or_else(Settings::default, Settings::read);
        Self { folder, kept }
    }

    pub fn kept(&self) -> &Settings {
        &self.kept
    }

    /// Writes `settings`, if they are others than those in the file.
    pub fn keep(&mut self, settings: &Settings) {
        if self.kept != *settings {
            self.kept = settings.clone();
            let _ = self.folder.as_deref().map(|folder| settings.write(folder));
        }
    }
}

/// The folder for the settings, where `variable` gives the environment. `RAYTOY_CONFIG` goes before the usual
/// places, and nothing is remembered where it is empty or where a program drives the window without it.
///
/// The places are those of the XDG Base Directory Specification, of Apple's File System Programming Guide and
/// of Windows' known folders RoamingAppData and LocalAppData.
pub fn folder(is_driven: bool, variable: impl Fn(&str) -> Option<OsString>) -> Option<PathBuf> {
    let usual = ["APPDATA", "Library/Application Support", "XDG_CONFIG_HOME", ".config"];
    place(is_driven, &variable, usual)
}

/// The folder for pictures that can be drawn again, in the same way.
pub fn cache(is_driven: bool, variable: impl Fn(&str) -> Option<OsString>) -> Option<PathBuf> {
    let usual = ["LOCALAPPDATA", "Library/Caches", "XDG_CACHE_HOME", ".cache"];
    Some(place(is_driven, &variable, usual)?.join("thumbnails"))
}

/// The folder that `RAYTOY_CONFIG` names, or one of the user's own: on Windows in what a variable says, on
/// macOS in a folder of the user's, elsewhere in what a variable says, or else in a folder of the user's.
fn place(
    is_driven: bool,
    variable: &impl Fn(&str) -> Option<OsString>,
    [windows, macos, unix, unset]: [&str; 4],
) -> Option<PathBuf> {
    if let Some(folder) = variable("RAYTOY_CONFIG") {
        return (!folder.is_empty()).then(|| folder.into());
    }
    let set = |name: &str| variable(name).map(PathBuf::from).filter(|path| path.is_absolute());
    let place = if is_driven {
        None
    } else if cfg!(target_os = "windows") {
        set(windows)
    } else if cfg!(target_os = "macos") {
        set("HOME").map(|home| home.join(macos))
    } else {
        set(unix).or_else(|| set("HOME").map(|home| home.join(unset)))
    };
    place.map(|place| place.join("raytoy"))
}

fn file(folder: &Path) -> PathBuf {
    folder.join("window.json")
}
