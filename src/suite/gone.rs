//! Goldens of scenes that are no longer there.
//!
//! In: folders. Out: [`Gone`] scenes with the goldens that they left behind. A file counts only where what it
//! holds shows that it is a golden: it may be removed.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::cases::{kind_of, shown};
use super::goldens::read_text;
use super::settings::{Settings, settings_for};
use super::walk::Walk;
use super::{Case, CaseKind, Failure, Goldens, Outcome};
use crate::difference::scene_of;
use crate::sources::Sources;

/// A scene that is gone, whose goldens are not.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Gone {
    /// The scene that was.
    pub case: Case,
    pub goldens: Vec<PathBuf>,
}

/// The scenes that are gone from the folders among `paths`, sorted by name.
///
/// # Errors
/// Which folder cannot be read.
pub fn find_gone(sources: &Sources, goldens: &Goldens, paths: &[PathBuf]) -> Result<Vec<Gone>, String> {
    let mut walk = Walk::default();
    let mut found: BTreeMap<String, Gone> = BTreeMap::new();
    for path in paths {
        let folder = match &goldens.folder {
            Some(folder) => folder.join(sources.name(path).trim_start_matches('/')),
            None => path.clone(),
        };
        if !folder.is_dir() {
            continue;
        }
        let files = walk.files_below(&folder)?;
        for file in &files {
            let Some(scene) = scene_that_is_gone(sources, goldens, file) else { continue };
            let mut left = vec![shown(file)];
            if file.extension().is_some_and(|extension| extension == "wgsl") {
                left.extend(pictures(sources, &files, file, &scene));
            }
            let case = Case { name: sources.name(&scene), path: scene, kind: CaseKind::Scene };
            let gone = found.entry(case.name.clone()).or_insert_with(|| Gone { case, goldens: vec![] });
            gone.goldens.extend(left);
        }
    }
    Ok(found.into_values().collect())
}

impl Gone {
    /// Reports the goldens, or removes them.
    pub fn outcome(self, removes: bool) -> Outcome {
        let mut outcome = Outcome::new(&self.case);
        if !removes {
            outcome.failures.push(Failure::Gone(self.goldens));
            return outcome;
        }
        for golden in self.goldens {
            match std::fs::remove_file(&golden) {
                Ok(()) => outcome.removed.push(golden),
                Err(error) => {
                    let why = format!("cannot remove `{}`: {error}", golden.display());
                    outcome.failures.push(Failure::Obstacle(why));
                }
            }
        }
        outcome
    }
}

/// The scene whose text or report `file` is; None where it is neither, or where the scene is there.
fn scene_that_is_gone(sources: &Sources, goldens: &Goldens, file: &Path) -> Option<PathBuf> {
    let within = goldens.folder.as_ref().map_or(Some(file), |folder| file.strip_prefix(folder).ok())?;
    let scene = shown(&within.with_extension("ron"));
    // Names in a folder of goldens have lost the `/` that an absolute path begins with.
    let is_there = scene.exists() || goldens.folder.is_some() && Path::new("/").join(&scene).exists();
    let name = scene.file_name()?.to_string_lossy();
    let is_golden = || match file.extension()?.to_str()? {
        "wgsl" => Some(kind_of(file).is_none() && is_text(file, &name)),
        "txt" => Some(settings_for(sources, &scene).ok()?.mistakes && is_report(file, &name)),
        _ => None,
    };
    (!is_there && is_golden() == Some(true)).then_some(scene)
}

/// The pictures beside `text`, for any adapter, among `files`. A picture does not say what it shows, so it
/// has to have the size of a golden.
fn pictures(sources: &Sources, files: &[PathBuf], text: &Path, scene: &Path) -> Vec<PathBuf> {
    let Ok(Settings { picture: true, size, .. }) = settings_for(sources, scene) else { return vec![] };
    let stem = text.with_extension("");
    let is_own = |file: &&PathBuf| {
        let name = file.with_extension("");
        let is_of_other = ["ron", "wgsl"].iter().any(|extension| file.with_extension(extension).exists());
        file.extension().is_some_and(|extension| extension == "png")
            && (name == stem || name.with_extension("") == stem && !is_of_other)
            && size_of(file) == Some(size)
    };
    files.iter().filter(is_own).map(|file| shown(file)).collect()
}

/// Whether `file` holds the text of a scene that was called `name`, and that is nowhere near.
fn is_text(file: &Path, name: &str) -> bool {
    let Ok(Some(text)) = read_text(file) else { return false };
    let Some(scene) = scene_of(&text).map(Path::new) else { return false };
    // The name counts from the folder that raytoy ran in.
    let is_there = || file.ancestors().skip(1).any(|folder| folder.join(scene).exists());
    scene.file_name().is_some_and(|own| own == name) && !is_there()
}

/// Whether `file` holds what was reported of a scene that was called `name`.
fn is_report(file: &Path, name: &str) -> bool {
    let Ok(Some(text)) = read_text(file) else { return false };
    let is_place = |line: &str| {
        let place = line.trim_start().strip_prefix("┌─ ").and_then(|place| place.split(':').next());
        place.is_some_and(|place| place.rsplit('/').next() == Some(name))
    };
    (text.starts_with("error: ") || text.starts_with("warning: ")) && text.lines().any(is_place)
}

/// Width and height of the picture in `file`; None where it is none, or one that `raytoy render` wrote.
fn size_of(file: &Path) -> Option<[u32; 2]> {
    let bytes = std::fs::read(file).ok()?;
    let is_rendered = bytes.windows(RENDERED.len()).any(|part| part == RENDERED);
    let picture = image::load_from_memory_with_format(&bytes, image::ImageFormat::Png).ok()?;
    (!is_rendered).then(|| [picture.width(), picture.height()])
}

/// The keyword of the scene's text in a picture that `raytoy render` wrote.
const RENDERED: &[u8] = b"raytoy scene";
