//! A version of the scene that goes wrong while it is drawn: it is told, and the last good one comes back.

use std::time::Duration;

use super::{PROMPT, Painter};
use crate::app::drawable::Drawable;
use crate::app::messages::Notice;
use crate::app::orders::Version;
use crate::diagnostic::{Diagnostic, Report};

/// A picture that takes longer is drawn only for who says that it may.
const PATIENCE: Duration = Duration::from_secs(60);
/// So long it is drawn before anyone says how long it takes.
const MEASURED: Duration = Duration::from_secs(2);

impl Painter {
    /// Puts a version in place of the one before, which stays at hand until this one is proven.
    pub(super) fn replace(&mut self, version: Box<Version>) {
        (self.notify)(Notice::Tries(version.compiled.clone()));
        let refused = self.refused.take();
        let scene = Drawable::new(version, refused.as_ref().or(self.scene.as_ref()));
        scene.upload(&self.gpu);
        if let Some(before) = self.scene.replace(scene).filter(|before| before.is_proven) {
            self.former = Some(before);
        }
        self.refusal = None;
    }

    /// The version that is drawn goes no further.
    pub(super) fn refuse(&mut self, report: Report) {
        (self.notify)(Notice::Broken(report.clone()));
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

    /// Draws what was refused once more.
    pub(super) fn retry(&mut self) {
        if let Some(refused) = self.refused.take() {
            refused.upload(&self.gpu);
            self.former = self.scene.replace(refused);
        }
    }

    /// A sample of the version is there, as fine as it is shown.
    pub(super) fn prove(&mut self) {
        let Some(scene) = self.scene.as_mut().filter(|_| self.refused.is_none()) else { return };
        scene.is_proven = true;
        self.former = None;
        if self.refusal.take().is_some() {
            (self.notify)(Notice::Mended(scene.version.warnings.clone()));
        }
    }

    /// What to say of a picture that takes longer than the author may want to wait.
    pub(super) fn too_slow(&self) -> Option<Report> {
        let size = self.picture_size();
        let time = self.pace.time(size[0] * size[1]);
        if self.look.patient || time < PATIENCE || self.sample_started.elapsed() < MEASURED {
            return None;
        }
        let [width, height] = self.look.size;
        let minutes = match (self.pace.time(width * height).as_secs_f64() / 60.0).round() as u64 {
            0 | 1 => "a minute".to_owned(),
            minutes => format!("{minutes} minutes"),
        };
        let message = format!("one sample of a picture of {width}x{height} takes about {minutes} here");
        let problem = Diagnostic::error(message).help(
            "press P to wait for it; the view `cost` shows where the time goes, and fewer `shadow_samples`, \
             `max_bounces` or objects, or `bounds` around them, take less",
        );
        Some(Report { diagnostics: vec![problem], ..Report::default() })
    }
}
