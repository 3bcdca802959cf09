//! How much of a picture fits into a time, by what its pixels cost lately.

use std::time::Duration;

/// What a pixel costs.
pub struct Pace {
    nanos_per_pixel: f64,
    /// Whether the pipeline has not drawn yet: its first slice may hold the driver's compile time.
    pub is_probe: bool,
}

impl Pace {
    pub fn new(is_software: bool) -> Self {
        Self { nanos_per_pixel: if is_software { 150.0 } else { 10.0 }, is_probe: true }
    }

    /// Screen pixels to one of a picture that is drawn within `prompt`.
    pub fn coarseness(&self, size: [u32; 2], prompt: Duration) -> u32 {
        let pixels = f64::from(size[0]) * f64::from(size[1]);
        let predicted = self.nanos_per_pixel * pixels / prompt.as_nanos() as f64;
        (predicted.sqrt().ceil() as u32).clamp(1, 8)
    }

    /// The rows of a picture `width` wide that are drawn within `slice`, at least one.
    pub fn rows(&self, width: u32, slice: Duration) -> u32 {
        let row = self.nanos_per_pixel * f64::from(width);
        let rows = if self.is_probe { 2 } else { (slice.as_nanos() as f64 / row) as u32 };
        rows.max(1)
    }

    /// So many pixels took `time`.
    pub fn learn(&mut self, pixels: u32, time: Duration) {
        if !self.is_probe {
            let nanos = time.as_nanos() as f64 / f64::from(pixels);
            self.nanos_per_pixel = 0.5 * (self.nanos_per_pixel + nanos);
        }
        self.is_probe = false;
    }
}
