//! A gathered picture as the window gets it: shown as light or values, with lines over it.

use super::messages::{FORMAT, Texels, ViewRequest};
use crate::compile::Compiled;
use crate::gpu::{Display, Gpu, GpuError, Line, Lines, LitColumns, Target, Tracer, gizmo};

/// What turns samples into a picture.
pub struct Compositor {
    display: Display,
    lines: Lines,
    /// Whether textures of its GPU can be shown by the window.
    shares_device: bool,
}

impl Compositor {
    pub fn new(gpu: &Gpu, shares_device: bool) -> Self {
        Self { display: Display::new(gpu, FORMAT), lines: Lines::new(gpu, FORMAT), shares_device }
    }

    /// The picture that `tracer` holds of the scene.
    ///
    /// # Errors
    /// Where the device stops to answer.
    pub fn show(&self, tracer: &Tracer, compiled: &Compiled, look: &ViewRequest) -> Result<Texels, GpuError> {
        let canvas = self.display.canvas(tracer.picture(), FORMAT);
        let target = canvas.create_view(&Default::default());
        let whole = Target { corner: [0.0; 2], zoom: 1.0 };
        let columns = look.view.columns_of_light(look.split, tracer.size()[0]);
        let light = LitColumns { render: &compiled.scene.render, columns };
        self.display.draw(tracer.picture(), Some(light), &target, whole);
        if look.gizmos {
            let camera = look.camera.unwrap_or(compiled.scene.camera);
            let lines: Vec<Line> = gizmo::lights(&compiled.scene, &camera)
                .into_iter()
                .chain(gizmo::camera_target(&camera))
                .chain(gizmo::bounds(&compiled.scene))
                .collect();
            self.lines.draw(tracer.picture(), &camera, &target, whole, &lines);
        }
        Ok(if self.shares_device {
            Texels::Shared(canvas)
        } else {
            Texels::Bytes { size: tracer.size(), rgba: self.display.read(&canvas)? }
        })
    }
}
