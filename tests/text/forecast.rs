//! How long a picture will take, by the part of it that is drawn.

use std::time::Duration;

use raytoy::engine::painter::forecast::Forecast;

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
