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

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: u32 = 1_000_000;

    /// Draws so many pixels in which each thousand takes so many milliseconds.
    fn draw(forecast: &mut Forecast, pixels: u32, millis: u64) {
        (0..pixels / 1000).for_each(|_| forecast.add(1000, Duration::from_millis(millis)));
    }

    #[test]
    fn little_says_nothing_however_long_it_took() {
        let mut forecast = Forecast::default();
        assert_eq!(forecast.of(ALL), None);
        forecast.add(1, Duration::from_secs(9));
        assert_eq!(forecast.of(ALL), None, "a pixel is no share");
        forecast.add(50_000, Duration::from_millis(500));
        let known = forecast.of(ALL).expect("it is a share");
        assert!((185..=190).contains(&known.as_secs()), "{known:?}");
    }

    #[test]
    fn all_pixels_of_a_sample_count_alike() {
        let mut forecast = Forecast::default();
        // Dear ones, and then cheap ones: 20 seconds.
        draw(&mut forecast, 100_000, 110);
        assert_eq!(forecast.of(ALL), Some(Duration::from_secs(110)));
        assert_eq!(forecast.rest(ALL), Duration::from_secs(99));
        draw(&mut forecast, 900_000, 10);
        assert_eq!(forecast.of(ALL), Some(Duration::from_secs(20)));
        assert_eq!(forecast.rest(ALL), Duration::ZERO);
    }

    #[test]
    fn what_was_quick_once_is_never_called_slow() {
        let mut forecast = Forecast::default();
        draw(&mut forecast, ALL, 4);
        forecast.finish();
        draw(&mut forecast, ALL / 2, 400);
        assert_eq!(forecast.of(ALL), Some(Duration::from_secs(4)));
    }

    #[test]
    fn what_is_slow_is_known_after_a_share_and_a_coarse_sample_counts() {
        let mut forecast = Forecast::default();
        // An eighth as wide and high: 2 seconds of 120.
        draw(&mut forecast, ALL / 64, 120);
        assert_eq!(forecast.of(ALL), None);
        forecast.finish();
        draw(&mut forecast, ALL / 20, 120);
        assert_eq!(forecast.of(ALL), Some(Duration::from_secs(120)));
    }
}
