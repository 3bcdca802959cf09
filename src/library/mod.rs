//! WGSL files as data: what a scene can name, read from signatures and doc lines.
//!
//! In: [`Sources`] and the folder of a scene. Out: [`Function`]s by the names that scenes use.

mod color;
mod condition;
mod condition_line;
mod declarations;
mod doc_line;
mod function;
mod header;
pub mod knot;
mod lexer;
mod mixing;
mod read;
pub mod sample;
mod shape;
mod taken;
mod unfit;
mod value;

use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::Path;
use std::sync::{Arc, Mutex};

pub use color::{parse_color, parse_css};
pub use condition::{Condition, Relation};
pub use function::{Function, Kind, Parameter, Traits, name_of};
pub use value::{Const, Type};

use crate::assets::{Image, Model, Reading};
use crate::diagnostic::{Diagnostic, Place};
use crate::sources::{Answer, Reach, Sources};

/// The files that ship with raytoy: name in the project and text, sorted by name.
pub const BUILT_IN: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/built_in.rs"));

/// The two families of files that a scene names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Family {
    Shape,
    /// Patterns, colors and mappings.
    Texture,
}

impl Family {
    /// In prose.
    pub fn noun(self) -> &'static str {
        match self {
            Family::Shape => "shape",
            Family::Texture => "texture",
        }
    }

    fn users_folder(self) -> &'static str {
        match self {
            Family::Shape => "shapes",
            Family::Texture => "textures",
        }
    }

    fn built_in_folder(self) -> &'static str {
        match self {
            Family::Shape => "shaders/shapes",
            Family::Texture => "textures",
        }
    }
}

/// What a file says, or all that is wrong with it.
type Read = Result<Arc<Function>, Vec<Diagnostic>>;

/// Finds what a scene names: beside the scene, beside its parent folders, then among what is built in.
pub struct Library<'a> {
    sources: &'a Sources,
    reach: Reach<'a>,
    known: Mutex<BTreeMap<(Family, String), Read>>,
    warnings: Mutex<Vec<Diagnostic>>,
    images: &'a [Image],
    models: &'a [Model],
}

impl<'a> Library<'a> {
    /// For a scene that lies in `folder`.
    pub fn new(sources: &'a Sources, folder: &Path) -> Self {
        let reach = sources.reach(folder);
        let known = Mutex::default();
        Self { sources, reach, known, warnings: Mutex::default(), images: &[], models: &[] }
    }

    /// The same, which takes what was read before instead of reading the same bytes again.
    pub fn with_known(self, images: &'a [Image], models: &'a [Model]) -> Self {
        Self { images, models, ..self }
    }

    /// The function that scenes call `name`, such as `WoodGrain`.
    ///
    /// # Errors
    /// None if there is no such file; else what is wrong with the file, once for all that name it.
    pub fn find(&self, family: Family, name: &str) -> Result<Arc<Function>, Option<Vec<Diagnostic>>> {
        let key = (family, name.to_owned());
        if let Some(known) = self.known.lock().expect("no holder panics").get(&key) {
            return known.clone().map_err(|_| Some(vec![]));
        }
        let read = match self.locate(family, name) {
            Ok(Some((file, text))) => read::read(family, &file, &text).map(Arc::new),
            Ok(None) => return Err(None),
            Err(problem) => Err(vec![problem]),
        };
        self.known.lock().expect("no holder panics").insert(key, read.clone());
        read.map_err(Some)
    }

    /// The names of all that can be found, sorted.
    pub fn names(&self, family: Family) -> Vec<String> {
        let built_in = BUILT_IN.iter().filter_map(|(path, _)| {
            let file = path.strip_prefix(family.built_in_folder())?.strip_prefix('/')?;
            file.strip_suffix(".wgsl").map(str::to_owned)
        });
        let folders = self.reach.folders().into_iter().map(|f| f.join(family.users_folder()));
        let mut stems: Vec<String> =
            folders.flat_map(|f| self.reach.snippets_in(&f)).chain(built_in).collect();
        stems.sort();
        stems.dedup();
        let is_name = |name: &String| lexer::is_name(name);
        stems.iter().map(|stem| function::name_of(stem)).filter(is_name).collect()
    }

    /// The files in the scene's reach that end in one of `extensions`, as scenes write them, nearest first.
    pub fn files(&self, extensions: &[&str]) -> Vec<String> {
        self.reach.files_near(extensions)
    }

    /// The picture in `file`, which lies beside the scene unless its path says otherwise, as `reading` says.
    ///
    /// # Errors
    /// Why it cannot be shown.
    pub fn image(&self, file: &str, reading: Reading) -> Result<Image, Diagnostic> {
        let (name, digest, bytes) = self.file(file)?;
        let is_it = |known: &&Image| known.file == name && known.digest == digest && known.reading == reading;
        let known = self.images.iter().find(is_it);
        known
            .map_or_else(|| Image::decode(name.clone(), digest, &bytes, reading), |known| Ok(known.clone()))
            .map_err(|why| Diagnostic::error(format!("`{name}` {why}")))
    }

    /// The model in `file`, which lies beside the scene unless its path says otherwise.
    ///
    /// # Errors
    /// Why it cannot be shown.
    pub fn model(&self, file: &str) -> Result<Model, Diagnostic> {
        let (name, digest, bytes) = self.file(file)?;
        let folder = file.rsplit_once('/').map(|(folder, _)| format!("{folder}/")).unwrap_or_default();
        let beside = |uri: &str| self.file(&format!("{folder}{uri}"));
        let known = self.models.iter().find(|known| {
            let digests = known.beside.iter().map_while(|uri| beside(uri).ok().map(|(_, digest, _)| digest));
            known.file == name && known.digest == mixed(digest, digests)
        });
        if let Some(known) = known {
            return Ok(known.clone());
        }
        let mut digests = vec![];
        let read = Model::decode(name.clone(), &bytes, &mut |uri| {
            let found = beside(uri).map_err(|problem| format!("points to another file: {}", problem.message));
            found.map(|(_, digest, bytes)| {
                digests.push(digest);
                bytes
            })
        });
        let model = read.map_err(|why| Diagnostic::error(format!("`{name}` {why}")))?;
        Ok(Model { digest: mixed(digest, digests), ..model })
    }

    /// The name of a file beside the scene, a digest of its bytes, and these.
    fn file(&self, file: &str) -> Result<(String, u64, Arc<[u8]>), Diagnostic> {
        if file.contains('\\') {
            let better = file.replace('\\', "/");
            let problem = Diagnostic::error("`\\` separates folders only on Windows");
            return Err(problem.help(format!("write `/` on all systems: `{better}`")));
        }
        let path = self.reach.folder().join(file);
        let bytes = self.reach.bytes(&path)?;
        let mut digest = DefaultHasher::new();
        bytes.hash(&mut digest);
        Ok((self.sources.name(&path), digest.finish(), bytes))
    }

    /// What was odd but not wrong, since the last call.
    pub fn take_warnings(&self) -> Vec<Diagnostic> {
        std::mem::take(&mut self.warnings.lock().expect("no holder panics"))
    }

    /// # Errors
    /// Why the file that has the name cannot be read.
    fn locate(&self, family: Family, name: &str) -> Result<Option<(String, Arc<str>)>, Diagnostic> {
        let stem = function::stem_of(name);
        let stems = [stem.clone(), stem.replace('_', "-"), function::wgsl_name_of(&stem), name.to_owned()];
        let built_in_name = format!("{}/{stem}.wgsl", family.built_in_folder());
        let built_in = built_in(&built_in_name);
        for folder in self.reach.folders() {
            let folder = folder.join(family.users_folder());
            let mut paths = stems.iter().map(|stem| folder.join(format!("{stem}.wgsl")));
            if let Some(path) = paths.find(|path| self.reach.read(path) != Answer::Missing) {
                let (text, file) = (self.reach.text(&path)?, self.sources.name(&path));
                if built_in.is_some_and(|b| b != &*text) {
                    let what =
                        format!("this replaces the {} of this name that comes with raytoy", family.noun());
                    let warning = Diagnostic::warning(what)
                        .at(Place { file: file.clone(), span: 0..0 }, "")
                        .help(format!("rename the file and its function to keep both `{name}`s"));
                    self.warnings.lock().expect("no holder panics").push(warning);
                }
                return Ok(Some((file, unmarked(text))));
            }
        }
        Ok(built_in.map(|text| (built_in_name, text.into())))
    }
}

/// The text with blanks in place of a byte-order mark, so that all places stay as they are.
fn unmarked(text: Arc<str>) -> Arc<str> {
    text.strip_prefix('\u{feff}').map(|rest| format!("   {rest}").into()).unwrap_or(text)
}

/// The digest of a file and of those beside it.
fn mixed(digest: u64, beside: impl IntoIterator<Item = u64>) -> u64 {
    beside.into_iter().fold(digest, |digest, other| digest.rotate_left(1) ^ other)
}

/// The text of a file that ships with raytoy, by its name in the project.
pub fn built_in(name: &str) -> Option<&'static str> {
    let at = BUILT_IN.binary_search_by_key(&name, |(n, _)| n).ok()?;
    Some(BUILT_IN[at].1)
}
