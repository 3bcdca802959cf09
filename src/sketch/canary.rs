//! Whether a driver draws a scene as it is.
//!
//! In: one sample of a few pixels, as the driver draws them. Out: how many of them a sketch has otherwise.

use std::time::Duration;

use super::Sketch;
use crate::compile::Compiled;
use crate::diagnostic::Diagnostic;
use crate::frame::{FrameUniforms, Moment};

/// Of what a screen shows, 0 to 1: far more than the last digits of a driver's own functions change.
const NEAR: f32 = 0.03;

/// A picture must not wait longer for the question whether it is right.
pub const PATIENCE: Duration = Duration::from_millis(200);

/// The share of the pixels that may differ: on an edge they fall on either side of it.
const MAX_WRONG: f64 = 0.03;

/// A picture that is not what the scene says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Doubt {
    /// Pixels that differ, and all that were asked for.
    pub wrong: usize,
    pub pixels: usize,
}

impl Doubt {
    /// The warning about it; `driver` is who drew `scene`.
    pub fn warning(self, scene: &str, driver: &str) -> Diagnostic {
        let Doubt { wrong, pixels } = self;
        let message = format!(
            "the driver draws `{scene}` wrong: {wrong} of {pixels} tested pixels have the wrong color"
        );
        let advice = "choose another GPU with --adapter, or install another version";
        Diagnostic::warning(message)
            .help(format!("the driver is {driver}; {advice}"))
            .help("a texture or shape with too many branches can cause this; `raytoy check` reports it")
    }
}

/// What speaks against `drawn`: light and depth of each pixel of the first sample in `size`, without a
/// jitter. Nothing where the scene cannot be sketched, or not within `patience`.
pub fn doubt(
    compiled: &Compiled,
    moment: &Moment,
    size: [u32; 2],
    drawn: &[[f32; 4]],
    patience: Duration,
) -> Option<Doubt> {
    let sketch = Sketch::new(compiled).ok()?;
    let scene = &compiled.scene;
    let frame = FrameUniforms::new(moment, &scene.render, scene.casters(), size, 0, [0.0; 2]);
    let expected = sketch.draw(&frame, patience).ok()?;
    let shown = |light: f32| light.clamp(0.0, 1.0).powf(1.0 / 2.2);
    let differs = |(a, b): &(&[f32; 4], &[f32; 4])| (0..3).any(|c| (shown(a[c]) - shown(b[c])).abs() > NEAR);
    let wrong = expected.iter().zip(drawn).filter(differs).count();
    let pixels = expected.len();
    (wrong as f64 > MAX_WRONG * pixels as f64).then_some(Doubt { wrong, pixels })
}
