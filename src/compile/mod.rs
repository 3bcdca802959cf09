//! A scene from its text to a shader that naga has found right: all stages that need no GPU.
//!
//! In: [`Sources`] and the path of a scene. Out: an [`Outcome`]. Nobody else runs stage after stage.

mod stack;
mod variants;

use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};

pub use self::stack::on_deep_stack;
use crate::diagnostic::{Diagnostic, Report};
use crate::library::Library;
use crate::module::{self, Module};
use crate::sources::Sources;
use crate::wgsl::{self, Mode, Source, Target};
use crate::{ir, scene};

/// A scene that is ready for a GPU.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// The scene as its author wrote it.
    pub text: Arc<str>,
    pub scene: ir::Scene,
    pub source: Source,
    pub module: Module,
    pub times: Times,
}

/// How long each stage took.
#[derive(Clone, Copy, Debug, Default)]
pub struct Times {
    pub parse: Duration,
    pub resolve: Duration,
    pub generate: Duration,
    /// Zero where the text had been validated before.
    pub naga: Duration,
}

/// The result of a compilation: [`Compiled`] unless the report has errors.
#[derive(Debug)]
pub struct Outcome {
    pub compiled: Option<Compiled>,
    pub report: Report,
}

/// Compiles the scene at `path`. Where its text comes out as `before`, naga is not asked again.
pub fn compile(sources: &Sources, path: &Path, mode: Mode, before: Option<&Compiled>) -> Outcome {
    on_deep_stack(|| {
        let mut generated = None;
        let (compiled, diagnostics) = match stages(sources, path, mode, before, &mut generated) {
            Ok((compiled, warnings)) => (Some(compiled), warnings),
            Err(problems) => (None, problems),
        };
        let mut texts = sources.texts();
        // Text that no disk holds: what is built in, and the scene's own section.
        for section in generated.iter().flat_map(|s: &Source| &s.sections) {
            texts.entry(section.name.clone()).or_insert_with(|| section.text.clone());
        }
        Outcome { compiled, report: Report { diagnostics, texts } }
    })
}

fn stages(
    sources: &Sources,
    path: &Path,
    mode: Mode,
    before: Option<&Compiled>,
    generated: &mut Option<Source>,
) -> Result<(Compiled, Vec<Diagnostic>), Vec<Diagnostic>> {
    let name = sources.name(path);
    let text = sources.text(path).map_err(|problem| vec![problem])?;
    let mut clock = Clock(Instant::now());
    let root = scene::parse(&name, &text)?;
    let parse = clock.lap();
    let mut library = Library::new(sources, path.parent().unwrap_or(Path::new("")));
    if let Some(before) = before {
        library = library.with_known(&before.scene.images, &before.scene.models);
    }
    let (scene, mut warnings) = ir::resolve(&name, &text, &root, &library)?;
    let resolve = clock.lap();
    let source = wgsl::generate(&scene, &Target::raytoy(mode));
    let generate = clock.lap();
    let known = before.filter(|b| b.source.sections == source.sections).map(|b| b.module.clone());
    let module = match known {
        Some(module) => module,
        None => module::validate(&source).map_err(|problem| {
            *generated = Some(source.clone());
            vec![problem]
        })?,
    };
    warnings.extend(module.warning().cloned());
    let naga = clock.lap();
    let times = Times { parse, resolve, generate, naga };
    Ok((Compiled { text, scene, source, module, times }, warnings))
}

struct Clock(Instant);

impl Clock {
    /// The time since the last lap.
    fn lap(&mut self) -> Duration {
        let now = Instant::now();
        let lap = now - self.0;
        self.0 = now;
        lap
    }
}
