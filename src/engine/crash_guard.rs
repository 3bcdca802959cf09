//! Which version of the scene has been drawn without harm, and which one the device may be lost over.

use std::sync::Arc;

use super::messages::Picture;
use crate::compile::Compiled;
use crate::diagnostic::{Diagnostic, Report};

/// What to know of a scene's versions where a device is lost.
#[derive(Clone, Debug, Default)]
pub struct CrashGuard {
    /// The last one of which there was a whole picture.
    good: Option<Arc<Compiled>>,
    /// One that is drawn for the first time.
    tried: Option<Arc<Compiled>>,
    /// One over which a device was lost, and what was said.
    suspect: Option<(Arc<Compiled>, String)>,
}

impl CrashGuard {
    /// A version is drawn for the first time.
    pub fn begin(&mut self, compiled: Arc<Compiled>) {
        self.tried = Some(compiled);
    }

    /// A version has been drawn.
    pub fn end(&mut self, picture: &Picture) {
        if !picture.is_sketch && (picture.resolution == 1.0 || picture.moves) {
            self.good = Some(picture.compiled.clone());
            self.tried = None;
        }
    }

    /// The device was lost: `why` is what its driver says.
    pub fn fail(&mut self, why: &str) {
        let is_good = |tried: &Arc<Compiled>| self.good.as_ref().is_some_and(|good| is_same(good, tried));
        if let Some(tried) = self.tried.take().filter(|tried| !is_good(tried)) {
            self.suspect = Some((tried, why.to_owned()));
        }
    }

    /// The version to show while there is no better one.
    pub fn good(&self) -> Option<&Arc<Compiled>> {
        self.good.as_ref()
    }

    /// What to say of a version that is not to be drawn again.
    pub fn verdict(&self, compiled: &Compiled) -> Option<Report> {
        let (_, why) = self.suspect.as_ref().filter(|(suspect, _)| is_same(suspect, compiled))?;
        let message = "the GPU stopped when it first drew this version of the scene";
        let problem = Diagnostic::error(message)
            .help(format!("message of the driver: {}", why.trim()))
            .help("if the scene is not the reason, save any change, even a comment, to draw it again");
        Some(problem.into())
    }
}

/// Whether two versions have one text, and draw the same.
fn is_same(a: &Compiled, b: &Compiled) -> bool {
    a.text == b.text && a.source == b.source
}
