//! How the painter draws: slices of samples, what lies under the pixels, a first row of a new pipeline.

use std::time::{Duration, Instant};

use super::{Painter, SAMPLES};
use crate::compile::Compiled;
use crate::engine::messages::{EngineEvent, Picture, ViewRequest};
use crate::frame::{Moment, sample_offset};
use crate::gpu::{GpuError, Region, Survey, Tracer};

/// On a device of its own the painter lets the window show a picture first, but waits no longer than this.
const COURTESY: Duration = Duration::from_millis(100);

impl Painter {
    /// Finds more of the objects under the pixels, and sends them to the window once all are known.
    pub(super) fn tell(&mut self) -> Result<(), GpuError> {
        let Some(scene) = &self.scene else { return Ok(()) };
        let Some(pipeline) = scene.pipeline(true) else { return Ok(()) };
        let compiled = &scene.version.compiled;
        let mut survey = match self.survey.take() {
            Some(survey) => survey,
            None => {
                let (moment, render) = (self.moment(compiled), &compiled.scene.render);
                Survey::new(&self.gpu, &moment, render, self.look.size)?
            }
        };
        match survey.step(&self.gpu, pipeline)? {
            Some(identity) => {
                self.is_told = true;
                (self.notify)(EngineEvent::Identity(Box::new(identity)));
            }
            None => self.survey = Some(survey),
        }
        Ok(())
    }

    /// What the picture shows that is being drawn.
    pub(super) fn moment(&self, compiled: &Compiled) -> Moment {
        let scene = &compiled.scene;
        let mouse = self.look.mouse.map(|x| x / self.coarseness as f32);
        let camera = self.look.camera.unwrap_or(scene.camera);
        let ViewRequest { view, split, reach, .. } = self.look;
        Moment { camera, view, split, reach, time: self.time, mouse }
    }

    /// Draws a pixel that the next sample will draw over.
    pub(super) fn warm_up(&mut self) -> Result<(), GpuError> {
        self.stretch()?;
        let (Some(scene), Some(tracer)) = (&mut self.scene, &mut self.tracer) else { return Ok(()) };
        let Some(full) = &scene.full else { return Ok(()) };
        let compiled = &scene.version.compiled;
        let pixel = Region::after(0, 1, tracer.size());
        tracer.draw(full, &Moment::of(&compiled.scene), &compiled.scene.render, [0.0; 2], &pixel);
        full.finish(&self.gpu)?;
        scene.is_warm = true;
        (self.notify)(EngineEvent::Ready { pipelines: self.gpu.pipelines_made() });
        Ok(())
    }

    /// Pixels, of the picture that is being drawn.
    pub(super) fn picture_size(&self) -> [u32; 2] {
        self.look.size.map(|n| n.div_ceil(self.coarseness))
    }

    /// Sees to it that there is something to draw on, as large as the picture.
    pub(super) fn stretch(&mut self) -> Result<(), GpuError> {
        let size = self.picture_size();
        if self.tracer.as_ref().is_none_or(|t| t.size() != size) {
            self.tracer = Some(Tracer::new(&self.gpu, size)?);
            self.pixels_done = 0;
        }
        Ok(())
    }

    pub(super) fn draw_slice(&mut self) -> Result<(), GpuError> {
        self.stretch()?;
        let size = self.picture_size();
        let scene = self.scene.as_ref().expect("is_done has looked");
        let pipeline = scene.pipeline(self.look.has_views()).expect("is_done has looked");
        let region = Region::after(self.pixels_done, self.pace.pixels(), size);
        let compiled = &scene.version.compiled;
        if self.pixels_done == 0 {
            self.sample_started = Instant::now();
            // All slices of a picture show one moment.
            self.time = if scene.moves { self.look.clock.time() } else { 0.0 };
        }
        let moment = self.moment(compiled);
        let tracer = self.tracer.as_mut().expect("it was just made");
        let begun = Instant::now();
        let jitter = sample_offset(tracer.samples(), SAMPLES);
        tracer.draw(pipeline, &moment, &compiled.scene.render, jitter, &region);
        pipeline.finish(&self.gpu)?;
        let took = begun.elapsed();
        self.pace.learn(region.pixels(), took);
        self.forecast.add(region.pixels(), took);
        self.pixels_done += region.pixels();
        if self.pixels_done == size[0] * size[1] {
            self.finish_sample()?;
        } else if self.is_better_coarser() {
            self.begin(self.coarseness * 2);
        }
        Ok(())
    }

    fn finish_sample(&mut self) -> Result<(), GpuError> {
        let tracer = self.tracer.as_mut().expect("it has drawn a sample");
        tracer.next();
        self.pixels_done = 0;
        self.forecast.finish();
        self.is_first_pass = false;
        let samples = tracer.samples();
        let frame_time = self.sample_started.elapsed();
        let is_first = samples == 1;
        let is_last = samples == SAMPLES;
        if is_first && (self.coarseness == 1 || self.is_moving()) {
            self.prove();
        }
        if samples == 2 && self.coarseness == 1 {
            self.examine()?;
        }
        if is_first || is_last || self.shown.elapsed() > Duration::from_millis(100) {
            self.show(frame_time)?;
        }
        if self.is_moving() {
            self.begin(self.coarseness);
            std::thread::sleep(Duration::from_millis(15).saturating_sub(frame_time));
        } else if self.coarseness > 1 {
            self.begin((self.coarseness / 4).max(1));
        }
        Ok(())
    }

    pub(super) fn show(&mut self, frame_time: Duration) -> Result<(), GpuError> {
        let scene = self.scene.as_mut().expect("it has been drawn");
        scene.is_shown = true;
        let tracer = self.tracer.as_ref().expect("it has drawn a sample");
        let version = &scene.version;
        let texels = self.compositor.show(tracer, &version.compiled, &self.look)?;
        self.shown = Instant::now();
        self.waits_until = (!self.shares_device).then(|| Instant::now() + COURTESY);
        (self.notify)(EngineEvent::Picture(Picture {
            texels,
            edit: scene.edit,
            change: version.change,
            samples: tracer.samples(),
            is_sketch: self.is_sketched,
            resolution: 1.0 / self.coarseness as f32,
            pipelines: self.gpu.pipelines_made(),
            noticed: version.noticed,
            pipeline_time: version.pipeline_time,
            frame_time,
            moves: scene.moves,
            compiled: version.compiled.clone(),
            warnings: self.refusal.clone().unwrap_or_else(|| scene.warned(&version.warnings)),
        }));
        Ok(())
    }
}
