//! raytoy: procedural, ray-traced scenes from RON to WGSL to a picture, live.
//!
//! A scene goes down the rooms of this crate, and a room knows only those above it:
//!
//! ```text
//! RON text ─► scene::Value ─► ir::Scene ─► wgsl::Source ─► module::Module ─► gpu::Pipeline ─► gpu::Picture
//!            parse           resolve      generate        validate          build            draw
//! ```
//!
//! [`compile`] is the front door to all that needs no GPU:
//!
//! ```
//! use raytoy::{compile, sources::Sources, wgsl::Mode};
//!
//! let sources = Sources::in_memory().with("ball.ron", "(objects: [Sphere(radius: 2)])");
//! let outcome = compile(&sources, "ball.ron".as_ref(), Mode::Baked, None);
//! assert!(outcome.compiled.unwrap().source.generated().contains("fn rayTraceScene"));
//! ```

pub mod app;
pub mod capture;
pub mod cli;
pub mod diagnostic;
pub mod difference;
pub mod edit;
pub mod export;
pub mod gpu;
pub mod ir;
pub mod judge;
pub mod laws;
pub mod library;
pub mod module;
pub mod outline;
pub mod scene;
pub mod sketch;
pub mod sources;
mod stage;
pub mod suite;
pub mod watch;
pub mod wgsl;

use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};

use diagnostic::{Diagnostic, Report};
use library::Library;
use module::Module;
use sources::Sources;
use wgsl::{Mode, Source};

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

impl Compiled {
    /// The same scene with its numbers in the other `mode`.
    ///
    /// # Errors
    /// Where naga refuses that text although it took the other, which would be a mistake of ours.
    pub fn in_mode(&self, mode: Mode) -> Result<Self, Diagnostic> {
        self.with_scene(self.scene.clone(), mode)
    }

    /// The same scene as [`wgsl::generate_plain`] writes it: no debug views, and all numbers as literals.
    ///
    /// # Errors
    /// Where naga refuses that text although it took the whole, which would be a mistake of ours.
    pub fn plain(&self) -> Result<Self, Diagnostic> {
        self.with_source(self.scene.clone(), wgsl::generate_plain(&self.scene))
    }

    /// The same scene in which only the body that has this one of its objects is seen and casts a shadow.
    /// Lights, camera and background stay, and so do all indices.
    ///
    /// # Errors
    /// Where naga refuses that text although it took the whole scene's, which would be a mistake of ours.
    pub fn isolated(&self, object: usize) -> Result<Self, Diagnostic> {
        let mut scene = self.scene.clone();
        for body in &mut scene.bodies {
            let is_chosen = body.solid.has(object);
            body.visible = is_chosen;
            body.casts_shadow = is_chosen;
        }
        self.with_scene(scene, self.source.mode)
    }

    /// The same scene with a number for the debug view `value`.
    ///
    /// # Errors
    /// Where naga refuses that text although it took the other, since a file of the author's has a function
    /// of the same name.
    pub fn measuring(&self, measure: ir::Measure) -> Result<Self, Diagnostic> {
        let scene = ir::Scene { measure: Some(measure), ..self.scene.clone() };
        self.with_scene(scene, self.source.mode)
    }

    /// Whether `other` needs no other pipeline than this one, where both have their numbers as data.
    pub fn has_structure_of(&self, other: &Self) -> bool {
        self.source.sections == other.source.sections && self.scene.has_files_of(&other.scene)
    }

    fn with_scene(&self, scene: ir::Scene, mode: Mode) -> Result<Self, Diagnostic> {
        let source = wgsl::generate(&scene, mode);
        self.with_source(scene, source)
    }

    fn with_source(&self, scene: ir::Scene, source: Source) -> Result<Self, Diagnostic> {
        let module = on_deep_stack(|| module::validate(&source))?;
        Ok(Self { text: self.text.clone(), scene, source, module, times: self.times })
    }

    /// The same scene with the entry points by which a [`gpu::Probe`] asks it.
    ///
    /// # Errors
    /// Where naga refuses them, since a file of the author's has a function of the same name.
    pub fn probed(&self) -> Result<Self, Diagnostic> {
        self.with_source(self.scene.clone(), self.source.clone().with_probe())
    }
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

/// What came of a scene: [`Compiled`] unless the report has errors.
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
    let source = wgsl::generate(&scene, mode);
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

/// Runs `work` on a thread whose stack holds the recursion of naga and of the RON parser.
pub fn on_deep_stack<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    const STACK_BYTES: usize = 64 << 20;
    std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().stack_size(STACK_BYTES).spawn_scoped(scope, work);
        let thread = thread.expect("the system has room for one more thread");
        thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    })
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
