//! A driver that runs on the processor is held to account: some draw wrong without a word.

use super::Painter;
use crate::engine::messages::EngineEvent;
use crate::frame::{Moment, View};
use crate::gpu::{GpuError, SMALL};
use crate::sketch::canary;

impl Painter {
    /// Compares a few pixels with a sketch, once for each version. They come after the second sample, so
    /// that no hand that drags waits for them.
    pub(super) fn examine(&mut self) -> Result<(), GpuError> {
        let Some(scene) = &self.scene else { return Ok(()) };
        let Some(pipeline) = scene.pipeline(false) else { return Ok(()) };
        if scene.is_examined || !self.gpu.is_software() {
            return Ok(());
        }
        let compiled = scene.version.compiled.clone();
        let moment = Moment { view: View::Color, split: None, ..self.moment(&compiled) };
        let small = pipeline.small(&self.gpu, &compiled.scene.render, &moment)?;
        let doubt = canary::doubt(&compiled, &moment, SMALL, &small, canary::PATIENCE);
        let Some(scene) = &mut self.scene else { return Ok(()) };
        scene.is_examined = true;
        if let Some(doubt) = doubt {
            scene.doubt = Some(doubt.warning(&compiled.scene.name, &self.gpu.describe()));
            (self.notify)(EngineEvent::Warned(scene.warned(&scene.version.warnings)));
        }
        Ok(())
    }
}
