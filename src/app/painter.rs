//! The thread that draws: a coarse picture at once, then samples until it is fine, in slices, so that wishes
//! are heard within a tenth of a second.

use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::{Duration, Instant};

use super::builder::{Built, Version};
use super::drawable::Drawable;
use super::easel::Easel;
use super::events::Change;
use super::messages::{Clock, Look, Notice, Picture, Wish};
use super::pace::Pace;
use crate::Compiled;
use crate::gpu::{Gpu, GpuError, Identity, Moment, Tracer, View, sample_offset};

/// No slice of a picture takes much longer.
const SLICE: Duration = Duration::from_millis(60);
/// A picture that takes longer than this to draw starts coarse.
const PROMPT: Duration = Duration::from_millis(50);
/// The same for one whose pipeline the author has waited for already.
const PROMPT_EDIT: Duration = Duration::from_millis(10);
/// A still picture is done with this many samples.
const SAMPLES: u32 = 64;

/// On a device of its own the painter lets the window show a picture first, but waits no longer than this.
const COURTESY: Duration = Duration::from_millis(100);

/// Starts the thread. `shares_device`: whether textures of `gpu` can be shown by the window.
pub fn start(gpu: Gpu, shares_device: bool, notify: impl Fn(Notice) + Send + 'static) -> Sender<Wish> {
    let (sender, receiver) = channel();
    std::thread::spawn(move || {
        let clock = Clock::Stopped(0.0);
        let look = Look {
            corner: [0; 2],
            size: [0; 2],
            camera: None,
            view: View::Color,
            mouse: [0.0; 2],
            clock,
            gizmos: false,
            asks: false,
        };
        let mut painter = Painter {
            easel: Easel::new(&gpu, shares_device),
            gpu,
            shares_device,
            notify: Box::new(notify),
            scene: None,
            look,
            tracer: None,
            coarseness: 1,
            rows_done: 0,
            is_told: false,
            sample_started: Instant::now(),
            pace: Pace::new(!shares_device),
            is_held: false,
            shown: Instant::now(),
            waits_until: None,
            time: 0.0,
        };
        painter.run(&receiver);
    });
    sender
}

struct Painter {
    gpu: Gpu,
    shares_device: bool,
    easel: Easel,
    notify: Box<dyn Fn(Notice)>,
    scene: Option<Drawable>,
    look: Look,
    tracer: Option<Tracer>,
    /// Screen pixels to one of the picture being drawn.
    coarseness: u32,
    rows_done: u32,
    /// Whether the window knows what lies under each pixel, as far as it has asked.
    is_told: bool,
    sample_started: Instant,
    pace: Pace,
    /// Whether another version is being built on the processor that would draw this one.
    is_held: bool,
    shown: Instant,
    /// When to go on although the window has not shown the last picture.
    waits_until: Option<Instant>,
    /// Of the picture that is being drawn, seconds.
    time: f32,
}

impl Painter {
    fn run(&mut self, receiver: &Receiver<Wish>) {
        loop {
            if self.is_done() {
                let Ok(wish) = receiver.recv() else { return };
                self.grant(wish);
            }
            receiver.try_iter().for_each(|wish| self.grant(wish));
            if let Some(until) = self.waits_until {
                match receiver.recv_timeout(until.saturating_duration_since(Instant::now())) {
                    Ok(wish) => self.grant(wish),
                    Err(_) => self.waits_until = None,
                }
            }
            if self.is_done() || self.waits_until.is_some() {
                continue;
            }
            let done = if self.needs_warming() {
                self.warm_up()
            } else if self.needs_telling() {
                self.tell()
            } else {
                self.draw_slice()
            };
            if let Err(error) = done {
                (self.notify)(Notice::Failed(error));
                return;
            }
        }
    }

    fn is_done(&self) -> bool {
        if self.scene.is_none() {
            return true;
        }
        let complete = self.tracer.as_ref().is_some_and(|t| t.samples() >= SAMPLES) && self.coarseness == 1;
        let is_visible = !self.look.size.contains(&0);
        let is_owed = self.is_moving() || self.needs_warming() || self.needs_telling();
        self.is_held || !is_visible || (complete && !is_owed)
    }

    /// Whether the picture changes by itself.
    fn is_moving(&self) -> bool {
        let moves = self.scene.as_ref().is_some_and(|scene| scene.moves);
        moves && matches!(self.look.clock, Clock::Running { .. })
    }

    /// Whether a live pipeline waits for its first draw, and the author already sees the scene.
    fn needs_warming(&self) -> bool {
        let Some(scene) = &self.scene else { return false };
        let is_settled = self.rows_done == 0 && (self.coarseness == 1 || self.is_moving());
        is_settled && scene.is_shown && scene.live.is_some() && !scene.is_warm
    }

    /// Whether the window waits to know what lies under the pixels of a picture that it shows.
    fn needs_telling(&self) -> bool {
        let is_shown = self.scene.as_ref().is_some_and(|scene| scene.is_shown);
        self.look.asks && !self.is_told && self.rows_done == 0 && is_shown
    }

    fn tell(&mut self) -> Result<(), GpuError> {
        let Some(scene) = &self.scene else { return Ok(()) };
        let compiled = &scene.version.compiled;
        let moment = self.moment(compiled);
        let render = &compiled.scene.render;
        let identity = Identity::draw(&self.gpu, scene.pipeline(), &moment, render, self.look.size)?;
        self.is_told = true;
        (self.notify)(Notice::Identity(Box::new(identity)));
        Ok(())
    }

    /// What the picture shows that is being drawn.
    fn moment(&self, compiled: &Compiled) -> Moment {
        let scene = &compiled.scene;
        let mouse = self.look.mouse.map(|x| x / self.coarseness as f32);
        let camera = self.look.camera.unwrap_or(scene.camera);
        Moment { camera, view: self.look.view, time: self.time, mouse }
    }

    /// Draws a row that the next sample will draw over.
    fn warm_up(&mut self) -> Result<(), GpuError> {
        let (Some(scene), Some(tracer)) = (&mut self.scene, &mut self.tracer) else { return Ok(()) };
        let Some(live) = &scene.live else { return Ok(()) };
        let compiled = &scene.version.compiled;
        tracer.draw(live, &Moment::of(&compiled.scene), &compiled.scene.render, [0.0; 2], 0..1);
        self.gpu.wait()?;
        scene.is_warm = true;
        (self.notify)(Notice::Ready { pipelines: self.gpu.pipelines_made() });
        Ok(())
    }

    fn grant(&mut self, wish: Wish) {
        if let Wish::Built(built) = &wish {
            match built {
                Built::Begun => self.is_held = !self.shares_device,
                Built::Scene(_) | Built::Broken(_) => self.is_held = false,
                _ => {}
            }
        }
        match wish {
            Wish::Shown => self.waits_until = None,
            Wish::Look(look) => {
                let before = self.look;
                let scene = self.scene.as_ref();
                let reads_mouse = scene.is_some_and(|s| s.reads_mouse) && look.mouse != before.mouse;
                let reads_clock = scene.is_some_and(|s| s.moves) && look.clock != before.clock;
                let Look { corner, mouse, clock, asks, .. } = look;
                let is_other =
                    look != Look { corner, mouse, clock, asks, ..before } || reads_mouse || reads_clock;
                self.look = look;
                if is_other {
                    self.restart(PROMPT);
                }
            }
            Wish::Built(Built::Begun) => {}
            Wish::Built(Built::File(text)) => (self.notify)(Notice::File(text)),
            Wish::Built(Built::Outline { outline, text }) => {
                (self.notify)(Notice::Outline { outline, text });
            }
            Wish::Built(Built::Broken(report)) => (self.notify)(Notice::Broken(report)),
            Wish::Built(Built::Scene(version)) => self.take(version),
            Wish::Built(Built::Live(pipeline)) => {
                if let Some(scene) = &mut self.scene {
                    scene.live = Some(pipeline);
                    scene.is_warm = false;
                }
            }
        }
    }

    fn take(&mut self, version: Box<Version>) {
        if version.change == Change::Cosmetic {
            return (self.notify)(Notice::Unchanged(version.warnings));
        }
        self.waits_until = None;
        let has_pipeline = version.baked.is_some();
        self.pace.is_probe |= has_pipeline;
        let scene = Drawable::new(version, self.scene.take());
        if let Some(live) = &scene.live {
            live.upload(&self.gpu, &scene.version.compiled.source.numbers);
        }
        self.scene = Some(scene);
        self.restart(if has_pipeline { PROMPT_EDIT } else { PROMPT });
    }

    /// Begins a new picture, coarse where a fine one would keep the window waiting.
    fn restart(&mut self, prompt: Duration) {
        self.is_told = false;
        self.begin(self.pace.coarseness(self.look.size, prompt));
    }

    fn begin(&mut self, coarseness: u32) {
        self.coarseness = coarseness;
        self.rows_done = 0;
        if let Some(tracer) = &mut self.tracer {
            tracer.restart();
        }
    }

    fn draw_slice(&mut self) -> Result<(), GpuError> {
        let scene = self.scene.as_ref().expect("is_done has looked");
        let size = self.look.size.map(|n| n.div_ceil(self.coarseness));
        if self.tracer.as_ref().is_none_or(|t| t.size() != size) {
            self.tracer = Some(Tracer::new(&self.gpu, size)?);
            self.rows_done = 0;
        }
        let end = self.rows_done.saturating_add(self.pace.rows(size[0], SLICE)).min(size[1]);
        let compiled = &scene.version.compiled;
        if self.rows_done == 0 {
            self.sample_started = Instant::now();
            // All slices of a picture show one moment.
            self.time = if scene.moves { self.look.clock.time() } else { 0.0 };
        }
        let moment = self.moment(compiled);
        let tracer = self.tracer.as_mut().expect("it was just made");
        let begun = Instant::now();
        let jitter = sample_offset(tracer.samples(), SAMPLES);
        tracer.draw(scene.pipeline(), &moment, &compiled.scene.render, jitter, self.rows_done..end);
        self.gpu.wait()?;
        self.pace.learn(size[0] * (end - self.rows_done), begun.elapsed());
        self.rows_done = end;
        if end == size[1] {
            self.finish_sample()?;
        }
        Ok(())
    }

    fn finish_sample(&mut self) -> Result<(), GpuError> {
        let tracer = self.tracer.as_mut().expect("it has drawn a sample");
        tracer.next();
        self.rows_done = 0;
        let samples = tracer.samples();
        let frame_time = self.sample_started.elapsed();
        let is_first = samples == 1;
        let is_last = samples == SAMPLES;
        if is_first || is_last || self.shown.elapsed() > Duration::from_millis(100) {
            self.show(samples, frame_time)?;
        }
        if self.is_moving() {
            self.begin(self.coarseness);
            std::thread::sleep(Duration::from_millis(15).saturating_sub(frame_time));
        } else if self.coarseness > 1 {
            self.begin((self.coarseness / 4).max(1));
        }
        Ok(())
    }

    fn show(&mut self, samples: u32, frame_time: Duration) -> Result<(), GpuError> {
        let scene = self.scene.as_mut().expect("it has been drawn");
        scene.is_shown = true;
        let tracer = self.tracer.as_ref().expect("it has drawn a sample");
        let version = &scene.version;
        let texels = self.easel.show(tracer, &version.compiled, &self.look)?;
        self.shown = Instant::now();
        self.waits_until = (!self.shares_device).then(|| Instant::now() + COURTESY);
        (self.notify)(Notice::Picture(Picture {
            texels,
            edit: scene.edit,
            change: version.change,
            samples,
            resolution: 1.0 / self.coarseness as f32,
            pipelines: self.gpu.pipelines_made(),
            noticed: version.noticed,
            pipeline_time: version.pipeline_time,
            frame_time,
            moves: scene.moves,
            compiled: version.compiled.clone(),
            warnings: version.warnings.clone(),
        }));
        Ok(())
    }
}
