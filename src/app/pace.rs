//! How much of a picture fits into a time, by what its pixels cost lately.

use std::time::Duration;

/// What a pixel costs.
pub struct Pace {
    nanos_per_pixel: f64,
    /// Whether the pipeline has not drawn yet: its first slice may hold the driver's compile time.
    is_probe: bool,
    /// The most pixels that go at once, since those before have shown that so many do.
    reach: u32,
}

/// No slice of a picture takes much longer: an edit waits for the one that is being drawn.
const SLICE: Duration = Duration::from_millis(30);
/// Pixels of the first slice that a pipeline draws: nobody knows what they cost.
const FIRST: u32 = 512;
/// A slice may have so many times the pixels of those before.
const GROWTH: u32 = 8;

impl Pace {
    pub fn new(is_software: bool) -> Self {
        let nanos_per_pixel = if is_software { 150.0 } else { 10.0 };
        Self { nanos_per_pixel, is_probe: true, reach: FIRST }
    }

    /// Another pipeline is about to draw.
    pub fn probe(&mut self) {
        self.is_probe = true;
        self.reach = FIRST;
    }

    /// Screen pixels to one of a picture that is drawn within `prompt`.
    pub fn coarseness(&self, size: [u32; 2], prompt: Duration) -> u32 {
        let pixels = f64::from(size[0]) * f64::from(size[1]);
        let predicted = self.nanos_per_pixel * pixels / prompt.as_nanos() as f64;
        (predicted.sqrt().ceil() as u32).clamp(1, 8)
    }

    /// The pixels of the next slice.
    pub fn pixels(&self) -> u32 {
        ((SLICE.as_nanos() as f64 / self.nanos_per_pixel) as u32).clamp(1, self.reach)
    }

    /// What so many pixels take.
    pub fn time(&self, pixels: u32) -> Duration {
        Duration::from_nanos((self.nanos_per_pixel * f64::from(pixels)) as u64)
    }

    /// So many pixels took `time`.
    pub fn learn(&mut self, pixels: u32, time: Duration) {
        if !self.is_probe {
            let nanos = time.as_nanos() as f64 / f64::from(pixels);
            self.nanos_per_pixel = 0.5 * (self.nanos_per_pixel + nanos);
            self.reach = match time <= SLICE {
                true => self.reach.max(pixels.saturating_mul(GROWTH)),
                false => ((SLICE.as_nanos() as f64 / nanos) as u32).max(1),
            };
        }
        self.is_probe = false;
    }
}
