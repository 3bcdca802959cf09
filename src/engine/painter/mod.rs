//! The thread that draws: a coarse picture at once, then samples until it is fine, in slices, so that wishes
//! are heard within a tenth of a second.

mod drawing;
mod examination;
pub mod forecast;
mod refusal;
mod sketching;
mod slowness;

use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::{Duration, Instant};

use super::builder_messages::{BuilderEvent, Version};
use super::compositor::Compositor;
use super::drawable::Drawable;
use super::events::Change;
use super::messages::{Clock, EngineEvent, PainterCommand, Slow, ViewRequest};
use crate::diagnostic::Report;
use crate::frame::View;
use crate::gpu::{Gpu, GpuError, Pace, Pipeline, Survey, Tracer};
use forecast::Forecast;

/// A picture that takes longer than this to draw starts coarse.
const PROMPT: Duration = Duration::from_millis(50);
/// The same for one whose pipeline the author has waited for already.
const PROMPT_EDIT: Duration = Duration::from_millis(10);
/// No slice of a picture takes much longer: an edit waits for the one that is being drawn.
const SLICE: Duration = Duration::from_millis(30);
/// Whoever wants to know what lies under a pixel waits for the sample that is drawn, but no longer than this.
const WAITING: Duration = Duration::from_millis(500);
/// A still picture is done with this many samples.
const SAMPLES: u32 = 64;

/// Starts the thread. `shares_device`: whether textures of `gpu` can be shown by the window.
pub fn start(
    gpu: Gpu,
    shares_device: bool,
    notify: impl Fn(EngineEvent) + Send + 'static,
) -> Sender<PainterCommand> {
    let (sender, receiver) = channel();
    std::thread::spawn(move || {
        let clock = Clock::Stopped(0.0);
        let look = ViewRequest {
            corner: [0; 2],
            size: [0; 2],
            camera: None,
            view: View::Color,
            split: None,
            reach: 1.0,
            mouse: [0.0; 2],
            clock,
            gizmos: false,
            asks: false,
        };
        let mut painter = Painter {
            compositor: Compositor::new(&gpu, shares_device),
            gpu,
            shares_device,
            notify: Box::new(notify),
            scene: None,
            former: None,
            refused: None,
            refusal: None,
            is_stuck: false,
            look,
            tracer: None,
            coarseness: 1,
            pixels_done: 0,
            is_sketched: false,
            is_told: false,
            survey: None,
            forecast: Forecast::default(),
            is_first_pass: false,
            slow: None,
            slow_told: Instant::now(),
            sample_started: Instant::now(),
            pace: Pace::new(SLICE, !shares_device),
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
    compositor: Compositor,
    notify: Box<dyn Fn(EngineEvent)>,
    /// What is drawn.
    scene: Option<Drawable>,
    /// The version before that was proven, until this one is.
    former: Option<Drawable>,
    /// The newest version, where `scene` is an older one in its place; and what is wrong with the newest.
    refused: Option<Drawable>,
    refusal: Option<Report>,
    /// Whether the scene is not to be drawn until something changes.
    is_stuck: bool,
    look: ViewRequest,
    tracer: Option<Tracer>,
    /// Screen pixels to one of the picture being drawn.
    coarseness: u32,
    pixels_done: u32,
    /// Whether the picture that is to be drawn was sketched, or could not be.
    is_sketched: bool,
    /// Whether the window knows what lies under each pixel, as far as it has asked.
    is_told: bool,
    /// What lies under each pixel, while it is found out.
    survey: Option<Survey>,
    /// How long a sample of the scene takes.
    forecast: Forecast,
    /// Whether nothing of the picture has been shown yet that something coarser could stand for.
    is_first_pass: bool,
    /// The last report of slow drawing, and when it was sent.
    slow: Option<Slow>,
    slow_told: Instant,
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
    fn run(&mut self, receiver: &Receiver<PainterCommand>) {
        loop {
            if self.is_done() {
                self.tell_slowness();
                let Ok(wish) = receiver.recv() else { return };
                self.grant(wish);
            }
            receiver.try_iter().for_each(|wish| self.grant(wish));
            self.tell_slowness();
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
            } else if self.pipeline().is_none() {
                self.sketch()
            } else {
                self.draw_slice()
            };
            match done {
                Ok(()) => {}
                Err(GpuError::Endless(report)) => self.refuse(report),
                Err(error) => return (self.notify)(EngineEvent::Failed(error)),
            }
        }
    }

    fn is_done(&self) -> bool {
        if self.pipeline().is_none() && !self.needs_sketch() {
            return true;
        }
        let complete = self.tracer.as_ref().is_some_and(|t| t.samples() >= SAMPLES) && self.coarseness == 1;
        let is_visible = !self.look.size.contains(&0);
        let is_owed = self.is_moving() || self.needs_warming() || self.needs_telling();
        self.is_held || self.is_stuck || !is_visible || (complete && !is_owed)
    }

    /// What to draw with, once it is there.
    fn pipeline(&self) -> Option<&Pipeline> {
        self.scene.as_ref()?.pipeline(self.look.has_views())
    }

    /// Whether the picture changes by itself.
    fn is_moving(&self) -> bool {
        let moves = self.scene.as_ref().is_some_and(|scene| scene.moves);
        moves && matches!(self.look.clock, Clock::Running { .. })
    }

    /// Whether a full pipeline waits for its first draw, and the author already sees the scene or has to wait
    /// for that.
    fn needs_warming(&self) -> bool {
        let Some(scene) = &self.scene else { return false };
        let is_settled = scene.is_shown && (self.coarseness == 1 || self.is_moving());
        let has_other = scene.baked_for(self.look.has_views()).is_some();
        let is_cold = scene.full.is_some() && !scene.is_warm;
        is_cold && self.pixels_done == 0 && (is_settled || !has_other)
    }

    /// Whether the window waits to know what lies under the pixels of a picture that it shows as fine as it
    /// gets, or for long: to find that out takes two samples without shadows, and a hand that drags a number
    /// waits for none.
    fn needs_telling(&self) -> bool {
        let is_shown = self.scene.as_ref().is_some_and(|scene| scene.is_shown);
        let is_fine = self.coarseness == 1 && self.tracer.as_ref().is_some_and(|t| t.samples() > 0);
        let can_tell = self.scene.as_ref().is_some_and(|scene| scene.pipeline(true).is_some());
        let is_asked = self.look.asks && !self.is_told && can_tell;
        let is_slow = self.pixels_done > 0 && self.sample_started.elapsed() > WAITING;
        let is_time = is_slow || (self.pixels_done == 0 && (is_fine || self.is_moving()));
        is_asked && is_shown && is_time
    }

    fn grant(&mut self, wish: PainterCommand) {
        if let PainterCommand::Built(built) = &wish {
            match built {
                BuilderEvent::Begun => self.is_held = !self.shares_device,
                BuilderEvent::Scene(_) | BuilderEvent::Broken(_) => self.is_held = false,
                _ => {}
            }
        }
        match wish {
            PainterCommand::Shown => self.waits_until = None,
            PainterCommand::View(look) => {
                let before = self.look;
                let scene = self.scene.as_ref();
                let reads_mouse = scene.is_some_and(|s| s.reads_mouse) && look.mouse != before.mouse;
                let reads_clock = scene.is_some_and(|s| s.moves) && look.clock != before.clock;
                let ViewRequest { corner, mouse, clock, asks, .. } = look;
                let is_other = look != ViewRequest { corner, mouse, clock, asks, ..before }
                    || reads_mouse
                    || reads_clock;
                self.look = look;
                if is_other {
                    self.restart(PROMPT);
                }
            }
            PainterCommand::Built(BuilderEvent::Begun) => {}
            PainterCommand::Built(BuilderEvent::File(text)) => (self.notify)(EngineEvent::File(text)),
            PainterCommand::Built(BuilderEvent::Outline { outline, text }) => {
                (self.notify)(EngineEvent::Outline { outline, text });
            }
            PainterCommand::Built(BuilderEvent::Broken(report)) => (self.notify)(EngineEvent::Broken(report)),
            PainterCommand::Built(BuilderEvent::Scene(version)) => self.take(version),
            PainterCommand::Built(BuilderEvent::Refused(report)) => self.refuse(report),
            PainterCommand::Built(BuilderEvent::Baked(pipeline, time)) => {
                let Some(scene) = self.refused.as_mut().or(self.scene.as_mut()) else { return };
                scene.baked = Some(pipeline);
                scene.version.pipeline_time = time;
                self.pace.probe();
                self.restart(if self.is_sketched { PROMPT } else { PROMPT_EDIT });
            }
            PainterCommand::Built(BuilderEvent::Full(pipeline)) => {
                if let Some(scene) = self.refused.as_mut().or(self.scene.as_mut()) {
                    scene.full = Some(Arc::new(pipeline));
                    scene.is_warm = false;
                }
            }
        }
    }

    fn take(&mut self, version: Box<Version>) {
        if version.change == Change::Cosmetic {
            let warned = self.scene.as_ref().map(|scene| scene.warned(&version.warnings));
            let report = self.refusal.clone().or(warned).unwrap_or(version.warnings);
            return (self.notify)(EngineEvent::Unchanged(report));
        }
        self.waits_until = None;
        if version.baked.is_some() {
            self.pace.probe();
        }
        let prompt = match &*version {
            // Nothing coarser comes in its place.
            Version { is_on_screen: true, .. } => Duration::MAX,
            Version { baked: Some(_), .. } => PROMPT_EDIT,
            _ => PROMPT,
        };
        self.replace(version);
        self.restart(prompt);
    }

    /// Begins a new picture, coarse where a fine one would keep the window waiting.
    fn restart(&mut self, prompt: Duration) {
        self.is_told = false;
        self.survey = None;
        self.is_first_pass = prompt < Duration::MAX;
        self.is_stuck = false;
        self.is_sketched = false;
        self.begin(self.pace.coarseness(self.look.size, prompt));
    }

    fn begin(&mut self, coarseness: u32) {
        self.coarseness = coarseness;
        self.pixels_done = 0;
        self.forecast.begin();
        if let Some(tracer) = &mut self.tracer {
            tracer.restart();
        }
    }
}
