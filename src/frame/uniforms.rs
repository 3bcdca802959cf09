//! What one picture differs by from the next, as the bytes that shaders/frame.wgsl declares.

use bytemuck::{Pod, Zeroable};

use super::{Lens, Moment};
use crate::ir;

/// `Frame` of shaders/frame.wgsl, where each field is explained.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct FrameUniforms {
    pub eye: [f32; 3],
    pub time: f32,
    pub right: [f32; 3],
    pub pixel_spread: f32,
    pub up: [f32; 3],
    pub max_bounces: u32,
    pub forward: [f32; 3],
    pub shadow_samples: u32,
    pub resolution: [f32; 2],
    pub mouse: [f32; 2],
    pub jitter: [f32; 2],
    pub sample: u32,
    pub view: u32,
    pub casters: u32,
    pub beside: u32,
    pub divider: f32,
    pub reach: f32,
}

impl FrameUniforms {
    /// `casters` is how many objects of the scene cast shadows.
    pub fn new(
        moment: &Moment,
        render: &ir::Render,
        casters: u32,
        size: [u32; 2],
        sample: u32,
        jitter: [f32; 2],
    ) -> Self {
        let Lens { eye, forward, right, up, half, size: resolution } = Lens::new(&moment.camera, size);
        Self {
            eye: eye.into(),
            time: moment.time,
            right: (right * half).into(),
            pixel_spread: if render.texture_filter { 2.0 * half / resolution.y } else { 0.0 },
            up: (up * half).into(),
            max_bounces: render.max_bounces,
            forward: forward.into(),
            shadow_samples: if render.shadows { render.shadow_samples } else { 0 },
            resolution: resolution.into(),
            mouse: moment.mouse,
            jitter,
            sample,
            view: moment.view as u32,
            casters,
            beside: moment.split.map_or(moment.view, |split| split.view) as u32,
            divider: moment.split.map_or(0, |split| split.column(size[0])) as f32,
            reach: moment.reach,
        }
    }
}

/// The place of sample `index` of `count` in its pixel, from the centre: one sample goes through the centre,
/// more are spread by the R2 sequence and gathered by a tent two pixels wide.
pub fn sample_offset(index: u32, count: u32) -> [f32; 2] {
    if count == 1 {
        return [0.0; 2];
    }
    let steps = [0.754_877_666_2, 0.569_840_290_998_f64];
    let tent = |u: f64| if u < 0.5 { (2.0 * u).sqrt() - 1.0 } else { 1.0 - (2.0 - 2.0 * u).sqrt() };
    steps.map(|step| tent((0.5 + f64::from(index) * step).fract()) as f32)
}
