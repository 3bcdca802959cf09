//! A structural edit, step by step: each is taken once the author sees the one before.
//!
//! First a sketch, which needs no driver. Then a pipeline with the scene's numbers baked in, which a driver
//! compiles sooner and draws faster, and without debug views where none is looked at. Then the full one, with
//! live numbers, so that it is there before the author changes a number.

use std::sync::Arc;
use std::time::Instant;

use super::Builder;
use crate::compile::Compiled;
use crate::diagnostic::{Diagnostic, Report};
use crate::engine::builder_messages::{BuilderEvent, Version};
use crate::engine::events::Change;
use crate::gpu::Pipeline;
use crate::sketch::Sketch;
use crate::wgsl::Mode;

/// The next pipeline of a structural edit.
pub enum NextStage {
    /// The baked one of a version that is shown as a sketch; and the text that it is made of.
    Baked(Arc<Compiled>, Box<Compiled>),
    Full(Arc<Compiled>),
}

impl NextStage {
    pub fn compiled(&self) -> &Arc<Compiled> {
        match self {
            NextStage::Baked(compiled, _) | NextStage::Full(compiled) => compiled,
        }
    }
}

impl Builder {
    /// Tells a version of another structure: as a sketch where there can be one and nothing finer is on the
    /// screen, else with its baked pipeline.
    pub(super) fn show(
        &mut self,
        compiled: &Arc<Compiled>,
        warnings: Report,
        noticed: Instant,
        is_on_screen: bool,
        done: &impl Fn(BuilderEvent),
    ) -> Result<(), Diagnostic> {
        let baked_text = if self.shows_views { compiled.in_mode(Mode::Baked) } else { compiled.plain() }?;
        let sketch =
            Some(&baked_text).filter(|_| !is_on_screen).and_then(|compiled| Sketch::new(compiled).ok());
        let is_sketched = sketch.is_some();
        let started = Instant::now();
        let baked = match is_sketched {
            true => None,
            false => Some(self.build_baked(&baked_text)?),
        };
        done(BuilderEvent::Scene(Box::new(Version {
            compiled: compiled.clone(),
            change: Change::Structure,
            sketch,
            baked,
            pipeline_time: started.elapsed(),
            is_on_screen,
            warnings,
            noticed,
        })));
        self.before = Some(compiled.clone());
        self.next_stage = Some(NextStage::Full(compiled.clone()));
        if is_sketched {
            self.next_stage = Some(NextStage::Baked(compiled.clone(), Box::new(baked_text)));
            // A driver on the processor would keep that from the sketch.
            if !self.gpu.is_software() {
                self.advance(done);
            }
        }
        Ok(())
    }

    /// Makes the next pipeline of the last structural edit.
    pub(super) fn advance(&mut self, done: &impl Fn(BuilderEvent)) {
        match self.next_stage.take() {
            // Nothing can be shown of it without views.
            Some(NextStage::Baked(compiled, baked)) if self.shows_views && !baked.source.target.views => {
                self.next_stage = Some(NextStage::Full(compiled));
                self.build_full(done);
            }
            Some(NextStage::Baked(compiled, baked)) => {
                let started = Instant::now();
                match self.build_baked(&baked) {
                    Ok(pipeline) => {
                        done(BuilderEvent::Baked(pipeline, started.elapsed()));
                        self.next_stage = Some(NextStage::Full(compiled));
                    }
                    Err(problem) => {
                        // No later edit can go on from it.
                        self.before = None;
                        done(BuilderEvent::Refused(Report {
                            diagnostics: vec![problem],
                            ..Report::default()
                        }));
                    }
                }
            }
            next_stage => {
                self.next_stage = next_stage;
                self.build_full(done);
            }
        }
    }

    /// Makes the full pipeline of the last structural edit, if that has none yet. Are its numbers live?
    pub(super) fn build_full(&mut self, done: &impl Fn(BuilderEvent)) -> bool {
        let Some(next_stage) = self.next_stage.take() else { return self.before.is_some() };
        let compiled = next_stage.compiled();
        let full = Pipeline::build(&self.gpu, compiled).or_else(|_| {
            // A scene may have more numbers than the GPU takes. Then every edit is a structural one.
            self.before = None;
            self.build_baked(&compiled.in_mode(Mode::Baked)?)
        });
        full.into_iter().for_each(|pipeline| done(BuilderEvent::Full(pipeline)));
        self.before.is_some()
    }

    fn build_baked(&self, baked: &Compiled) -> Result<Pipeline, Diagnostic> {
        Pipeline::build(&self.gpu, baked).map_err(|error| Diagnostic::error(error.to_string()))
    }
}
