//! A version of the scene that goes wrong while it is drawn: a report of it, and the last good one again.

use super::forecast::Forecast;
use super::{PROMPT, Painter};
use crate::diagnostic::Report;
use crate::engine::builder_messages::Version;
use crate::engine::drawable::Drawable;
use crate::engine::messages::EngineEvent;

impl Painter {
    /// Puts a version in place of the one before, which stays at hand until this one is proven.
    pub(super) fn replace(&mut self, version: Box<Version>) {
        (self.notify)(EngineEvent::Tries(version.compiled.clone()));
        let refused = self.refused.take();
        let scene = Drawable::new(version, refused.as_ref().or(self.scene.as_ref()));
        scene.upload(&self.gpu);
        if let Some(before) = self.scene.replace(scene).filter(|before| before.is_proven) {
            self.former = Some(before);
        }
        self.refusal = None;
        self.forecast = Forecast::default();
    }

    /// The version that is drawn goes no further.
    pub(super) fn refuse(&mut self, report: Report) {
        (self.notify)(EngineEvent::Broken(report.clone()));
        self.refusal = Some(report);
        if let Some(former) = self.former.take() {
            former.upload(&self.gpu);
            self.refused = self.scene.replace(former);
            return self.restart(PROMPT);
        }
        // Another look at it may do no harm.
        self.begin(self.coarseness);
        self.is_stuck = true;
    }

    /// A sample of the version is there, as fine as it is shown.
    pub(super) fn prove(&mut self) {
        let Some(scene) = self.scene.as_mut().filter(|_| self.refused.is_none()) else { return };
        scene.is_proven = true;
        self.former = None;
        if self.refusal.take().is_some() {
            (self.notify)(EngineEvent::Warned(scene.warned(&scene.version.warnings)));
        }
    }
}
