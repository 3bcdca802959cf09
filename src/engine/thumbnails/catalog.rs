//! What a gallery can show: scenes, and all that scenes can name.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::compile::{Compiled, compile};
use crate::diagnostic::Report;
use crate::library::{Family, Function, Library, sample};
use crate::outline::{self, Role};
use crate::sources::Disk;
use crate::wgsl::Mode;

/// Something that has a picture.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Subject {
    Scene(PathBuf),
    /// What scenes call by this name.
    Function(Family, String),
}

/// A subject, and its description for people.
pub struct Item {
    pub subject: Subject,
    pub name: String,
    /// Of a scene, its first comment.
    pub caption: String,
    /// None for scenes, and for a file with mistakes.
    pub definition: Option<Definition>,
}

/// A texture, mapping or shape, as scenes write it.
pub struct Definition {
    pub function: Arc<Function>,
    /// With no more than it must be given.
    pub call: String,
    /// With all that it takes.
    pub full_call: String,
}

/// The scenes, by the names that people know them by, and what a scene in `folder` can name.
pub fn catalog(disk: &Disk, folder: &Path, scenes: &[(PathBuf, String)]) -> Vec<Item> {
    let sources = disk.sources();
    let library = Library::new(&sources, folder);
    let scenes = scenes.iter().map(|(path, name)| Item {
        subject: Subject::Scene(path.clone()),
        name: name.clone(),
        caption: sources.text(path).map_or(String::new(), |text| first_comment(&text)),
        definition: None,
    });
    let functions = [Family::Texture, Family::Shape].into_iter().flat_map(|family| {
        let names = library.names(family).into_iter();
        names.map(|name| item(&library, family, name)).collect::<Vec<_>>()
    });
    scenes.chain(functions).collect()
}

impl Subject {
    /// What is to be drawn of it, as a scene in `folder` sees it.
    ///
    /// # Errors
    /// All mistakes that are in the way, as one text.
    pub fn compiled(&self, disk: &Disk, folder: &Path) -> Result<Compiled, String> {
        let (sources, path) = match self {
            Subject::Scene(path) => (disk.sources(), path.clone()),
            Subject::Function(family, name) => {
                let known = disk.sources();
                let found = Library::new(&known, folder).find(*family, name);
                let function = found.map_err(|problems| {
                    let diagnostics = problems.unwrap_or_default();
                    Report { diagnostics, texts: known.texts() }.to_string()
                })?;
                sample::shown(&function, disk.sources(), folder)
            }
        };
        let outcome = compile(&sources, &path, Mode::Baked, None);
        outcome.compiled.ok_or_else(|| outcome.report.to_string())
    }
}

fn item(library: &Library<'_>, family: Family, name: String) -> Item {
    let role = match family {
        Family::Texture => Role::Texture,
        Family::Shape => Role::Solid,
    };
    let definition = library.find(family, &name).ok().and_then(|function| {
        let call = outline::example(role, &name, library)?;
        Some(Definition { call, full_call: sample::full_call(&function), function })
    });
    let caption = definition.as_ref().map_or(String::new(), |known| known.function.caption.clone());
    Item { subject: Subject::Function(family, name.clone()), name, caption, definition }
}

/// The words of the line that opens `text`, if that is a comment.
fn first_comment(text: &str) -> String {
    let line = text.lines().next().unwrap_or_default();
    line.strip_prefix("//").unwrap_or_default().trim_matches(['/', ' ']).to_owned()
}
