//! `--stats`: what a picture cost, as JSON.

use std::time::Duration;

use serde::Serialize;

use crate::capture::Shot;
use crate::gpu::PictureTimes;

/// One picture. Times are milliseconds.
#[derive(Serialize)]
pub struct Stats {
    scene: String,
    adapter: String,
    width: u32,
    height: u32,
    samples: u32,
    objects: usize,
    wgsl_bytes: usize,
    parse_ms: f64,
    resolve_ms: f64,
    generate_ms: f64,
    naga_ms: f64,
    pipeline_ms: f64,
    first_frame_ms: f64,
    frame_ms: f64,
}

impl Stats {
    pub fn new(shot: &Shot<'_>, times: &PictureTimes) -> Self {
        let Shot { gpu, compiled, size, samples, .. } = *shot;
        let ms = |time: Duration| (time.as_secs_f64() * 1e6).round() / 1e3;
        Self {
            scene: compiled.scene.name.clone(),
            adapter: gpu.describe(),
            width: size[0],
            height: size[1],
            samples,
            objects: compiled.scene.primitives.len(),
            wgsl_bytes: compiled.source.text().len(),
            parse_ms: ms(compiled.times.parse),
            resolve_ms: ms(compiled.times.resolve),
            generate_ms: ms(compiled.times.generate),
            naga_ms: ms(compiled.times.naga),
            pipeline_ms: ms(times.pipeline),
            first_frame_ms: ms(times.first_frame),
            frame_ms: ms(times.frame),
        }
    }

    /// One object for one picture, a list for several.
    pub fn json(all: &[Stats]) -> String {
        let text = match all {
            [one] => serde_json::to_string_pretty(one),
            many => serde_json::to_string_pretty(many),
        };
        text.expect("numbers and strings") + "\n"
    }
}
