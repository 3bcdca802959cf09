//! What one picture differs by from the next, as the bytes that shaders/frame.wgsl declares.

use bytemuck::{Pod, Zeroable};

use super::Split;
use super::lens::Lens;
use crate::ir;

/// What a picture shows. The numbers are those of shaders/view.wgsl.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum View {
    /// The light that reaches the camera.
    #[default]
    Color,
    /// World normals, -1 to 1 shown as 0 to 1.
    Normal,
    /// Distance along the ray, nearer is brighter.
    Depth,
    /// World position, its fraction of a unit.
    Position,
    /// Surface coordinates, their fraction of a unit.
    Uv,
    /// One color for each object.
    Object,
    /// The surface's own color, without light.
    Material,
    /// Depth of the ray tree, white where it was cut.
    Bounces,
    /// Unblocked share of the lights.
    Shadow,
    /// Light that is infinite or no number in magenta, on a dim grey picture.
    Nan,
    /// Work of all rays on a scale of doublings: black is 1, pale yellow 65536.
    Cost,
    /// Outsides of surfaces in blue, insides in orange.
    Facing,
    /// The number that the scene measures, blue below 0 and red above.
    Value,
    /// Surface coordinates as they are, and the object's index. For [`super::Identity`].
    Place,
    /// World normals as they are, outward and without bumps. For [`super::Identity`].
    Outward,
}

impl View {
    /// Those to look at, with the names by which they are asked for.
    pub const ALL: [(&str, View); 13] = [
        ("color", View::Color),
        ("normal", View::Normal),
        ("depth", View::Depth),
        ("position", View::Position),
        ("uv", View::Uv),
        ("object", View::Object),
        ("material", View::Material),
        ("bounces", View::Bounces),
        ("shadow", View::Shadow),
        ("nan", View::Nan),
        ("cost", View::Cost),
        ("facing", View::Facing),
        ("value", View::Value),
    ];

    /// The name by which it is asked for.
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(_, view)| *view == self).expect("all are there").0
    }
}

/// The moment at which a picture is taken, and by which camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment {
    pub camera: ir::Camera,
    pub view: View,
    /// What lies over the right part of it.
    pub split: Option<Split>,
    /// The number at which the colors of [`View::Value`] end, more than 0.
    pub reach: f32,
    /// Seconds.
    pub time: f32,
    /// Pixels from the top left.
    pub mouse: [f32; 2],
}

impl Moment {
    /// As the scene says, at its beginning.
    pub fn of(scene: &ir::Scene) -> Self {
        let (camera, view) = (scene.camera, View::Color);
        Self { camera, view, split: None, reach: 1.0, time: 0.0, mouse: [0.0; 2] }
    }
}

/// `Frame` of shaders/frame.wgsl, where each field is explained.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct Frame {
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

impl Frame {
    /// `casters` is how many bodies of the scene cast shadows.
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

/// Where sample `index` of `count` lies in its pixel, from the centre: one sample goes through the centre,
/// more are spread by the R2 sequence and gathered by a tent two pixels wide.
pub fn sample_offset(index: u32, count: u32) -> [f32; 2] {
    if count == 1 {
        return [0.0; 2];
    }
    let steps = [0.754_877_666_2, 0.569_840_290_998_f64];
    let tent = |u: f64| if u < 0.5 { (2.0 * u).sqrt() - 1.0 } else { 1.0 - (2.0 - 2.0 * u).sqrt() };
    steps.map(|step| tent((0.5 + f64::from(index) * step).fract()) as f32)
}
