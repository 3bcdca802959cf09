//! How many pixels fit into a time, by what those before have cost.
//!
//! In: how long each slice of a picture took. Out: the pixels of the next one.

use std::time::Duration;

/// What a pixel costs.
#[derive(Debug)]
pub struct Pace {
    /// No slice is to take much longer.
    slice: Duration,
    nanos_per_pixel: f64,
    /// Whether the pipeline has not drawn yet: its first slice may hold the driver's compile time.
    is_probe: bool,
    /// The most pixels that go at once, since those before have shown that so many do.
    reach: u32,
}

/// Pixels of the first slice that a pipeline draws: nobody knows what they cost.
const FIRST: u32 = 512;
/// A slice may have so many times the pixels of those before.
const GROWTH: u32 = 8;

impl Pace {
    /// For slices that take up to `slice`, by a driver that runs on the processor or does not.
    pub fn new(slice: Duration, is_software: bool) -> Self {
        let nanos_per_pixel = if is_software { 150.0 } else { 10.0 };
        Self { slice, nanos_per_pixel, is_probe: true, reach: FIRST }
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
        self.fitting(self.nanos_per_pixel).min(self.reach)
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
            self.reach = match time <= self.slice {
                true => self.reach.max(pixels.saturating_mul(GROWTH)),
                false => self.fitting(nanos),
            };
        }
        self.is_probe = false;
    }

    /// The pixels of a slice where one costs `nanos`.
    fn fitting(&self, nanos: f64) -> u32 {
        ((self.slice.as_nanos() as f64 / nanos) as u32).max(1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SLICE: Duration = Duration::from_millis(100);

    /// Draws so many slices in which each pixel costs so many nanoseconds, and gives their pixels.
    fn drawn(pace: &mut Pace, slices: usize, nanos: u64) -> Vec<u32> {
        let mut slice = || {
            let pixels = pace.pixels();
            pace.learn(pixels, Duration::from_nanos(nanos * u64::from(pixels)));
            pixels
        };
        (0..slices).map(|_| slice()).collect()
    }

    #[test]
    fn slices_begin_small_grow_step_by_step_and_then_take_the_time() {
        let mut pace = Pace::new(SLICE, true);
        let pixels = drawn(&mut pace, 30, 200);
        assert_eq!(pixels[..4], [512, 512, 4096, 32_768]);
        assert!(pixels.windows(2).all(|pair| pair[1] <= GROWTH * pair[0]), "{pixels:?}");
        assert!(pixels[29].abs_diff(500_000) <= 1, "{pixels:?}");
        pace.probe();
        assert_eq!(pace.pixels(), FIRST, "another pipeline may be slower");
    }

    #[test]
    fn what_a_driver_compiles_in_the_first_slice_is_not_the_cost_of_a_pixel() {
        let mut pace = Pace::new(SLICE, true);
        let before = pace.time(1000);
        pace.learn(FIRST, Duration::from_secs(5));
        assert_eq!(pace.time(1000), before);
        assert_eq!(pace.pixels(), FIRST);
    }

    #[test]
    fn after_a_slice_that_took_long_the_next_fits_down_to_one_pixel() {
        let mut pace = Pace::new(SLICE, true);
        let cheap = drawn(&mut pace, 30, 200)[29];
        assert!(drawn(&mut pace, 2, 20_000)[1] <= cheap / 100);
        pace.learn(1, Duration::from_secs(3));
        assert_eq!(pace.pixels(), 1);
    }
}
