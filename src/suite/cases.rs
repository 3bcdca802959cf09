//! Which files are tested: scenes, and the files of textures and shapes.

use std::path::{Path, PathBuf};

use super::settings::{OF_FOLDER, is_settings};
use super::walk::Walk;
use crate::library::Family;
use crate::sources::Sources;

/// One file that is tested.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Case {
    /// As messages call it: from the folder that raytoy runs in.
    pub name: String,
    pub path: PathBuf,
    pub kind: CaseKind,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CaseKind {
    /// Compared with goldens.
    Scene,
    /// Held to laws.
    Snippet(Family),
}

/// All cases at or below `paths`, sorted by name; hidden folders and `target` are left out.
///
/// # Errors
/// Which path is not there, or no case.
pub fn find(sources: &Sources, paths: &[PathBuf]) -> Result<Vec<Case>, String> {
    let mut walk = Walk::default();
    let mut found = vec![];
    for path in paths {
        if path.is_dir() {
            for file in walk.files_below(path)? {
                if let Some(kind) = kind_of(&file) {
                    found.push((file, kind));
                } else if is_settings(&file) && file.file_name().is_some_and(|name| name != OF_FOLDER) {
                    refuse_stray(&file)?;
                }
            }
        } else if !path.exists() {
            return Err(format!("there is no file or folder `{}`", path.display()));
        } else if let Some(kind) = kind_of(path) {
            found.push((path.clone(), kind));
        } else {
            return Err(format!("`{}` is not a test: {}", path.display(), why_not(path)));
        }
    }
    let case = |(path, kind): (PathBuf, CaseKind)| {
        let path = shown(&path);
        Case { name: sources.name(&path), path, kind }
    };
    let mut cases: Vec<Case> = found.into_iter().map(case).collect();
    cases.sort_by(|a, b| a.name.cmp(&b.name));
    cases.dedup_by(|a, b| a.name == b.name);
    Ok(cases)
}

/// `path` as one would type it.
pub(super) fn shown(path: &Path) -> PathBuf {
    path.strip_prefix(".").unwrap_or(path).to_path_buf()
}

/// # Errors
/// Where settings are those of no file: a scene that was renamed would lose them in silence.
fn refuse_stray(path: &Path) -> Result<(), String> {
    let name = path.to_string_lossy();
    let stem = name.strip_suffix(".test.ron").unwrap_or(&name);
    if ["ron", "wgsl"].iter().any(|extension| Path::new(&format!("{stem}.{extension}")).exists()) {
        return Ok(());
    }
    let [name, stem] = [&name, stem].map(|path| path.trim_start_matches("./"));
    Err(format!("`{name}` contains the settings of a test, but there is no scene `{stem}.ron`"))
}

/// How the file at `path` is tested; None where it is not.
pub fn kind_of(path: &Path) -> Option<CaseKind> {
    let folder = path.parent().and_then(Path::file_name).unwrap_or_default();
    match path.extension()?.to_str()? {
        "ron" if !is_settings(path) => Some(CaseKind::Scene),
        "wgsl" if folder == "textures" => Some(CaseKind::Snippet(Family::Texture)),
        "wgsl" if folder == "shapes" => Some(CaseKind::Snippet(Family::Shape)),
        _ => None,
    }
}

fn why_not(path: &Path) -> &'static str {
    if is_settings(path) {
        return "it contains the settings of a test; name the scene";
    }
    match path.extension().and_then(|extension| extension.to_str()) {
        Some("wgsl") => "textures belong in a folder `textures`, shapes in a folder `shapes`",
        _ => "scenes end in .ron, textures and shapes in .wgsl",
    }
}
