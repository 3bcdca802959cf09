//! Tests of an author's own files: scenes beside their goldens, textures and shapes before their laws.
//!
//! In: [`Case`]s and devices. Out: [`Outcome`]s, and texts about them for people and programs. The only room
//! that writes and removes goldens, and only if it is called to bless.

mod cases;
mod goldens;
mod gone;
mod jobs;
mod outcome;
mod report;
mod scene;
mod settings;
mod snippet;
mod walk;

pub use cases::{Case, CaseKind, find, kind_of};
pub use goldens::Goldens;
pub use gone::{Gone, find_gone};
pub use jobs::by_devices;
pub use outcome::{Failure, Outcome};
pub use report::{Run, html, human, json, junit};
pub use scene::Bench;
pub use settings::{Settings, is_settings};
pub use walk::Walk;

use crate::gpu::Gpu;

/// Runs all `cases`, a thread for each of `devices`; `done` gets the number of those that are done.
pub fn run(bench: &Bench, devices: &[Gpu], cases: &[Case], done: &mut dyn FnMut(usize)) -> Vec<Outcome> {
    let check = |gpu: &Gpu, case: &Case| match case.kind {
        CaseKind::Scene => scene::check(bench, gpu, case),
        CaseKind::Snippet(family) => snippet::check(bench, gpu, case, family),
    };
    by_devices(devices, cases, check, done)
}
