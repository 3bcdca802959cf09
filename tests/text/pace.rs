//! Slices of pictures: how many pixels each of them has, on idle machines and on busy ones.

use std::time::Duration;

use raytoy::gpu::Pace;

const SLICE: Duration = Duration::from_millis(30);
/// A picture that fills a screen.
const PIXELS: u32 = 1_280_000;

/// Draws so many slices in which each pixel costs so many nanoseconds; their pixels.
fn drawn(pace: &mut Pace, slices: usize, nanos: u64) -> Vec<u32> {
    let mut slice = || {
        let pixels = pace.pixels();
        pace.learn(pixels, Duration::from_nanos(nanos * u64::from(pixels)));
        pixels
    };
    (0..slices).map(|_| slice()).collect()
}

/// Nanoseconds of the pixel with a number.
type Cost = fn(u32) -> u64;

/// A machine, and what it draws.
struct Machine {
    /// Nanoseconds of all pixels before one.
    costs: Vec<u64>,
    /// The share of slices that wait, and how long, milliseconds.
    share: f64,
    wait: [u64; 2],
}

/// What came of a sample.
#[derive(Debug)]
struct Sample {
    all: Duration,
    drawing: Duration,
    /// The longest that a slice drew, without waiting.
    longest: Duration,
    slices: u32,
}

impl Machine {
    /// `cost` is that of the pixel with a number.
    fn new(cost: impl Fn(u32) -> u64, share: f64, wait: [u64; 2]) -> Self {
        let sum = |sum: &mut u64, pixel| Some(std::mem::replace(sum, *sum + cost(pixel)));
        Self { costs: (0..=PIXELS).scan(0, sum).collect(), share, wait }
    }

    fn sample(&self, pace: &mut Pace, random: &mut u64) -> Sample {
        let mut next = || {
            *random = random.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (*random >> 33) as f64 / (1u64 << 31) as f64
        };
        let none = Duration::ZERO;
        let mut sample = Sample { all: none, drawing: none, longest: none, slices: 0 };
        let mut done = 0;
        while done < PIXELS {
            let end = PIXELS.min(done + pace.pixels());
            let draws = Duration::from_nanos(self.costs[end as usize] - self.costs[done as usize]);
            let waits = match next() < self.share {
                true => self.wait[0] as f64 + next() * (self.wait[1] - self.wait[0]) as f64,
                false => 1.0,
            };
            let time = draws + Duration::from_secs_f64(waits / 1e3);
            pace.learn(end - done, time);
            sample.all += time;
            sample.drawing += draws;
            sample.longest = sample.longest.max(draws);
            sample.slices += 1;
            done = end;
        }
        sample
    }
}

#[test]
fn slices_begin_small_grow_step_by_step_and_then_take_the_time() {
    let mut pace = Pace::new(SLICE, true);
    let pixels = drawn(&mut pace, 60, 100);
    assert_eq!(pixels[..4], [512, 512, 4096, 32_768]);
    assert!(pixels.windows(2).all(|pair| pair[1] <= 128 * pair[0]), "{pixels:?}");
    let full = |x: &&u32| x.abs_diff(300_000) <= 1;
    assert!(pixels[10..].iter().filter(full).count() >= 40, "{pixels:?}");
    pace.probe();
    assert_eq!(pace.pixels(), 512, "another pipeline may be slower");
}

#[test]
fn what_a_driver_compiles_in_the_first_slice_is_not_the_cost_of_a_pixel() {
    let mut pace = Pace::new(SLICE, true);
    let before = pace.cost();
    pace.learn(512, Duration::from_secs(5));
    assert_eq!(pace.cost(), before);
    assert_eq!(pace.pixels(), 512);
}

#[test]
fn after_a_slice_that_took_long_the_next_fits_down_to_one_pixel() {
    for is_software in [true, false] {
        let mut pace = Pace::new(SLICE, is_software);
        let cheap = drawn(&mut pace, 30, 200).into_iter().max().expect("some were drawn");
        assert!(drawn(&mut pace, 2, 20_000)[1] <= cheap / 100);
        let dear = drawn(&mut pace, 40, 1_500_000_000);
        assert!(dear[8..].iter().all(|pixels| *pixels == 1), "{dear:?}");
    }
}

#[test]
fn a_busy_machine_makes_no_slices_without_end() {
    let even = |_: u32| 3_000;
    // A sky, and below it a model.
    let uneven = |pixel: u32| if pixel < PIXELS / 2 { 200 } else { 6_000 };
    // Wherever a slice begins, it meets both.
    let mixed = |pixel: u32| if pixel % 97 < 90 { 300 } else { 30_000 };
    let costs: [(&str, Cost); 3] = [("even", even), ("uneven", uneven), ("mixed", mixed)];
    // How much longer than the drawing itself a sample takes at most.
    let loads =
        [(0.0, [0, 0], 1.3), (0.3, [100, 300], 10.0), (0.7, [100, 300], 10.0), (1.0, [100, 300], 10.0)];
    for (name, cost) in costs {
        for (share, wait, most) in loads {
            let machine = Machine::new(cost, share, wait);
            for seed in 0..20 {
                let (mut pace, mut random) = (Pace::new(SLICE, true), seed);
                for number in 0..4 {
                    let sample = machine.sample(&mut pace, &mut random);
                    let told = format!("{name}, {share} wait, seed {seed}, sample {number}: {sample:?}");
                    assert!(sample.all <= sample.drawing.mul_f64(most), "{told}");
                    let longest =
                        if share == 0.0 && number > 0 { 16 * SLICE } else { Duration::from_secs(2) };
                    assert!(sample.longest <= longest, "{told}");
                }
            }
        }
    }
}

#[test]
fn once_a_machine_is_idle_again_slices_are_short_again() {
    let (mut pace, mut random) = (Pace::new(SLICE, true), 1);
    Machine::new(|_| 3_000, 1.0, [100, 300]).sample(&mut pace, &mut random);
    assert!(pace.wanted() > 5 * SLICE, "{:?}", pace.wanted());
    let idle = Machine::new(|_| 3_000, 0.0, [0, 0]);
    for _ in 0..3 {
        idle.sample(&mut pace, &mut random);
    }
    let after = idle.sample(&mut pace, &mut random);
    assert!(after.longest <= 2 * SLICE, "{after:?}");
}
