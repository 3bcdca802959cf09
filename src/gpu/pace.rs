//! How many pixels fit into a time, by what those before have cost.
//!
//! In: how long each slice of a picture took, which is drawing and, on a busy machine, waiting for a turn.
//! Out: the pixels of the next slice.

use std::time::Duration;

/// What a pixel costs, and how much of a slice is only waiting.
#[derive(Debug)]
pub struct Pace {
    /// No slice is to take much longer, unless it waits.
    slice: Duration,
    /// However much of it is waiting, none is to take longer than this.
    longest: Duration,
    /// So many pixels took so many nanoseconds lately.
    lately: [f64; 2],
    /// Whether the pipeline has not drawn yet: its first slice may hold the driver's compile time.
    is_probe: bool,
    /// The pixels of the next slice that is not tiny.
    reach: u32,
    /// Whether the next slice is tiny, and so shows how long slices wait.
    is_tiny: bool,
    /// Slices since the last tiny one.
    since_tiny: u32,
    /// What the last tiny slices took, the newest first.
    waits: [Duration; 3],
}

/// Pixels of the first slice that a pipeline draws: nobody knows what they cost.
const FIRST: u32 = 512;
/// A slice may have so many times the pixels of those before.
const GROWTH: u32 = 8;
/// However cheap the pixels just drawn, no slice takes so many times as long where the next cost what all do.
const AT_ONCE: u32 = 4;
/// So many slices of all have one tiny one among them, and by so much it is smaller.
const TINY_EVERY: u32 = 8;
const TINY: u32 = 16;
/// The cost of a pixel is a mean over this time of drawing, and over little of what another pipeline drew.
const MEMORY: Duration = Duration::from_secs(4);
const MEMORY_OF_OTHERS: Duration = Duration::from_millis(5);
/// GPUs that do not answer for two seconds are taken away by some systems; processors are not.
const LONGEST_ON_GPU: Duration = Duration::from_millis(500);
const LONGEST_ON_PROCESSOR: Duration = Duration::from_secs(2);

impl Pace {
    /// For slices that take up to `slice`, by a driver that runs on the processor or does not.
    pub fn new(slice: Duration, is_software: bool) -> Self {
        let (cost, longest) =
            if is_software { (150.0, LONGEST_ON_PROCESSOR) } else { (10.0, LONGEST_ON_GPU) };
        Self {
            slice,
            longest,
            lately: [1.0, cost],
            is_probe: true,
            reach: FIRST,
            is_tiny: false,
            since_tiny: 0,
            waits: [Duration::ZERO; 3],
        }
    }

    /// Another pipeline is about to draw.
    pub fn probe(&mut self) {
        self.is_probe = true;
        self.reach = FIRST;
        self.is_tiny = false;
        self.keep(MEMORY_OF_OTHERS);
    }

    /// Screen pixels to one of a picture that is drawn within `prompt`.
    pub fn coarseness(&self, size: [u32; 2], prompt: Duration) -> u32 {
        let pixels = f64::from(size[0]) * f64::from(size[1]);
        let predicted = self.cost() * pixels / prompt.as_nanos() as f64;
        (predicted.sqrt().ceil() as u32).clamp(1, 8)
    }

    /// The pixels of the next slice.
    pub fn pixels(&self) -> u32 {
        // After a sky a model may begin, as it did in the sample before.
        let most = (AT_ONCE * self.slice).max(3 * self.wanted() / 2);
        let foreseen = (most.as_nanos() as f64 / self.cost()) as u32;
        let pixels = self.reach.min(foreseen);
        (if self.is_tiny { pixels / TINY } else { pixels }).max(1)
    }

    /// So many pixels took `time`.
    pub fn learn(&mut self, pixels: u32, time: Duration) {
        if std::mem::take(&mut self.is_probe) {
            return;
        }
        let time = time.max(Duration::from_nanos(1));
        let nanos = time.as_nanos() as f64;
        self.lately = [self.lately[0] + f64::from(pixels), self.lately[1] + nanos];
        self.keep(MEMORY);
        if std::mem::take(&mut self.is_tiny) {
            self.waits = [time, self.waits[0], self.waits[1]];
            self.since_tiny = 0;
            return;
        }
        let wanted = self.wanted();
        let fitting = (f64::from(pixels) * wanted.as_nanos() as f64 / nanos) as u32;
        self.reach = match time <= wanted {
            true => self.reach.max(fitting.min(pixels.saturating_mul(GROWTH))),
            false => fitting.max(1),
        };
        self.since_tiny += 1;
        self.is_tiny = time > wanted || self.since_tiny >= TINY_EVERY;
    }

    /// How long a slice is to take. Where slices wait, smaller ones would only wait more often: half of their
    /// time goes to drawing.
    fn wanted(&self) -> Duration {
        let mut waits = self.waits;
        waits.sort_unstable();
        (2 * waits[1]).clamp(self.slice, self.longest.max(self.slice))
    }

    /// Nanoseconds that a pixel takes, with its share of waiting.
    fn cost(&self) -> f64 {
        self.lately[1] / self.lately[0]
    }

    /// Forgets what is older than so much drawing.
    fn keep(&mut self, memory: Duration) {
        let share = (memory.as_nanos() as f64 / self.lately[1]).min(1.0);
        self.lately = self.lately.map(|x| x * share);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
        assert!(pixels.windows(2).all(|pair| pair[1] <= TINY * GROWTH * pair[0]), "{pixels:?}");
        let full = |x: &&u32| x.abs_diff(300_000) <= 1;
        assert!(pixels[10..].iter().filter(full).count() >= 40, "{pixels:?}");
        pace.probe();
        assert_eq!(pace.pixels(), FIRST, "another pipeline may be slower");
    }

    #[test]
    fn what_a_driver_compiles_in_the_first_slice_is_not_the_cost_of_a_pixel() {
        let mut pace = Pace::new(SLICE, true);
        let before = pace.cost();
        pace.learn(FIRST, Duration::from_secs(5));
        assert_eq!(pace.cost(), before);
        assert_eq!(pace.pixels(), FIRST);
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
}
