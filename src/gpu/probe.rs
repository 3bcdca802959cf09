//! Questions to a scene's own functions, many at a time and without a picture: what does its material look
//! like at these points, what do these rays meet?
//!
//! In: [`Compiled`], points, rays. Out: the values that a picture of the scene would be made of.

use bytemuck::{Pod, Zeroable};
use glam::{Vec2, Vec3};

use super::assets::{Assets, check_models};
use super::batches::{Kernel, Scene};
use super::guard::Guard;
use super::layouts::{entry, layout_entry};
use super::pipeline::{self, checked};
use super::{Gpu, GpuError};
use crate::bindings::{FRAME, NUMBERS, PROBE_CROSSINGS, PROBE_LOOKS, PROBE_POINTS, PROBE_RAYS};
use crate::compile::Compiled;
use crate::frame::{FrameUniforms, Moment};

/// A scene that can be asked. One whose text stays the same takes new numbers.
#[derive(Debug)]
pub struct Probe {
    gpu: Gpu,
    materials: Kernel,
    rays: Kernel,
    scene: Scene,
    numbers: Option<wgpu::Buffer>,
    guard: Option<Guard>,
}

/// A point of an object, as its textures see it. Lengths are scene units.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct SurfacePoint {
    /// Its place among the scene's objects.
    pub object: u32,
    /// In the object's space.
    pub position: Vec3,
    /// Outward, length 1, in the object's space.
    pub normal: Vec3,
    pub uv: Vec2,
    /// The same point in world space.
    pub world: Vec3,
    /// Width of a pixel at the point, in the object's units; 0 does not filter.
    pub footprint: f32,
}

/// What a material looks like at one point; linear RGB.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaterialSample {
    pub color: Vec3,
    pub emission: Vec3,
}

/// The points `origin + t * direction` with `t_min < t < t_max`, in world space. The direction may have any
/// length but 0; t counts in it.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Ray {
    pub origin: Vec3,
    pub t_min: f32,
    pub direction: Vec3,
    pub t_max: f32,
}

/// Where a ray meets the scene first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// In lengths of the ray's direction.
    pub t: f32,
    /// Its place among the scene's objects.
    pub object: u32,
    /// In world space.
    pub position: Vec3,
    /// Outward, length 1, in world space, without bumps.
    pub normal: Vec3,
    pub uv: Vec2,
}

impl Probe {
    /// Makes one shader module and two pipelines, for `compiled` as it is at `moment` in a picture of `size`.
    ///
    /// # Errors
    /// Where the driver refuses or has no compute shaders, or the scene has more numbers than the GPU's
    /// uniform buffers hold.
    pub fn build(gpu: &Gpu, compiled: &Compiled, moment: &Moment, size: [u32; 2]) -> Result<Self, GpuError> {
        pipeline::check_numbers(gpu, compiled)?;
        check_models(gpu, &compiled.scene)?;
        Kernel::check(gpu)?;
        let probed = compiled.probed().map_err(|problem| GpuError::Refused(problem.message))?;
        let frame = FrameUniforms::new(moment, &compiled.scene.render, 0, size, 0, [0.0; 2]);
        checked(gpu, &probed, || {
            let device = &gpu.device;
            let module = pipeline::shader_module(gpu, &probed);
            let stage = wgpu::ShaderStages::COMPUTE;
            let mut entries = vec![layout_entry(FRAME, size_of::<FrameUniforms>() as u64, stage)];
            let numbers = pipeline::numbers_buffer(gpu, compiled);
            entries.extend(numbers.iter().map(|numbers| layout_entry(NUMBERS, numbers.size(), stage)));
            let guard = Guard::new(gpu, &probed);
            entries.extend(guard.iter().map(|_| Guard::layout(stage)));
            let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                label: Some("probe"),
                entries: &entries,
            });
            let frame_buffer = pipeline::uniform_buffer(gpu, "frame", size_of::<FrameUniforms>() as u64);
            gpu.queue.write_buffer(&frame_buffer, 0, bytemuck::bytes_of(&frame));
            let bound = [(FRAME, Some(&frame_buffer)), (NUMBERS, numbers.as_ref())];
            let bound = bound
                .into_iter()
                .filter_map(|(binding, buffer)| Some(entry(binding, buffer?.as_entire_binding())));
            let bound = bound.chain(guard.iter().map(Guard::entry));
            let values = device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some("probe"),
                layout: &layout,
                entries: &bound.collect::<Vec<_>>(),
            });
            let assets = Assets::new(gpu, &compiled.scene);
            let layouts = [Some(&layout), assets.as_ref().map(|assets| &assets.layout)];
            let kernel = |name, lists| Kernel::new(gpu, &module, layouts, name, lists);
            let materials = kernel("probeMaterials", [PROBE_POINTS, PROBE_LOOKS]);
            let rays = kernel("probeRays", [PROBE_RAYS, PROBE_CROSSINGS]);
            let scene = Scene { values, assets };
            Self { gpu: gpu.clone(), materials, rays, scene, numbers, guard }
        })
    }

    /// Replaces the scene's numbers by those of a scene with the same live text.
    pub fn upload(&self, numbers: &[f32]) {
        if let Some(buffer) = &self.numbers {
            self.gpu.queue.write_buffer(buffer, 0, bytemuck::cast_slice(numbers));
        }
    }

    /// What the materials look like at `points`, one answer for each. An object that the scene does not have
    /// is black.
    ///
    /// # Errors
    /// Where a loop of the author's had to be ended, or the device stops to answer.
    pub fn materials(&self, points: &[SurfacePoint]) -> Result<Vec<MaterialSample>, GpuError> {
        let answer = |a: &LookAnswer| MaterialSample { color: a.color, emission: a.emission };
        let looks = self.materials.ask(&self.gpu, &self.scene, points, PointQuestion::of, answer)?;
        self.verdict()?;
        Ok(looks)
    }

    /// Where `rays` meet the scene first, one answer for each; None where a ray meets nothing.
    ///
    /// # Errors
    /// Where a loop of the author's had to be ended, or the device stops to answer.
    pub fn rays(&self, rays: &[Ray]) -> Result<Vec<Option<Crossing>>, GpuError> {
        let answer = |a: &CrossingAnswer| {
            let CrossingAnswer { position, t, normal, object, uv, .. } = *a;
            (object != NO_OBJECT).then_some(Crossing { t, object, position, normal, uv })
        };
        let crossings = self.rays.ask(&self.gpu, &self.scene, rays, |ray| *ray, answer)?;
        self.verdict()?;
        Ok(crossings)
    }

    fn verdict(&self) -> Result<(), GpuError> {
        self.guard.as_ref().map_or(Ok(()), |guard| guard.verdict(&self.gpu))
    }
}

/// `NO_OBJECT` of shaders/hit.wgsl.
const NO_OBJECT: u32 = u32::MAX;

/// `ProbePoint` of shaders/probe.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct PointQuestion {
    position: Vec3,
    footprint: f32,
    normal: Vec3,
    object: u32,
    world: Vec3,
    padding: u32,
    uv: Vec2,
    end: [u32; 2],
}

impl PointQuestion {
    fn of(point: &SurfacePoint) -> Self {
        let SurfacePoint { object, position, normal, uv, world, footprint } = *point;
        Self { position, footprint, normal, object, world, padding: 0, uv, end: [0; 2] }
    }
}

/// `ProbeLook` of shaders/probe.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct LookAnswer {
    color: Vec3,
    padding: u32,
    emission: Vec3,
    end: u32,
}

/// `ProbeCrossing` of shaders/probe.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct CrossingAnswer {
    position: Vec3,
    t: f32,
    normal: Vec3,
    object: u32,
    uv: Vec2,
    end: [u32; 2],
}
