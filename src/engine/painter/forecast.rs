//! How long one sample of a picture takes, by what its pixels have taken so far.
//!
//! In: each slice of the samples that are drawn. Out: a time, once there is enough to judge by.

use std::time::Duration;

/// What is known of the pixels of one scene.
#[derive(Clone, Copy, Debug, Default)]
pub struct Forecast {
    /// Of the sample that is being drawn.
    pixels: u32,
    spent: Duration,
    /// What a pixel took in the quickest whole sample, seconds.
    whole: Option<f64>,
}

/// A part of a picture says something of all of it once it is so large, or was drawn for so long. A coarse
/// sample has fewer pixels than the picture.
const SHARE: f64 = 0.05;
const ENOUGH: Duration = Duration::from_secs(2);
const AT_LAST: Duration = Duration::from_secs(10);

impl Forecast {
    /// A sample begins.
    pub fn begin(&mut self) {
        (self.pixels, self.spent) = (0, Duration::ZERO);
    }

    /// So many pixels more are drawn, and took `time`.
    pub fn add(&mut self, pixels: u32, time: Duration) {
        self.pixels += pixels;
        self.spent += time;
    }

    /// The sample is whole.
    pub fn finish(&mut self) {
        let cost = self.spent.as_secs_f64() / f64::from(self.pixels.max(1));
        self.whole = Some(self.whole.map_or(cost, |before| before.min(cost)));
        self.begin();
    }

    /// What a sample of so many pixels takes. A busy machine makes pixels slower and never quicker, so what
    /// was quick once is quick.
    pub fn of(&self, all: u32) -> Option<Duration> {
        let is_share = f64::from(self.pixels) >= SHARE * f64::from(all);
        let is_known = self.spent >= AT_LAST || (self.spent >= ENOUGH && is_share);
        let cost = self.spent.as_secs_f64() / f64::from(self.pixels.max(1));
        let cost = cost.min(self.whole.unwrap_or(f64::INFINITY));
        is_known.then(|| Duration::from_secs_f64(cost * f64::from(all)))
    }

    /// What is left of a sample of so many pixels that is being drawn, by what is drawn of it.
    pub fn rest(&self, all: u32) -> Duration {
        let share = f64::from(all.saturating_sub(self.pixels)) / f64::from(self.pixels.max(1));
        self.spent.mul_f64(share)
    }
}
