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
    pub fn wanted(&self) -> Duration {
        let mut waits = self.waits;
        waits.sort_unstable();
        (2 * waits[1]).clamp(self.slice, self.longest.max(self.slice))
    }

    /// Nanoseconds that a pixel takes, with its share of waiting.
    pub fn cost(&self) -> f64 {
        self.lately[1] / self.lately[0]
    }

    /// Forgets what is older than so much drawing.
    fn keep(&mut self, memory: Duration) {
        let share = (memory.as_nanos() as f64 / self.lately[1]).min(1.0);
        self.lately = self.lately.map(|x| x * share);
    }
}
