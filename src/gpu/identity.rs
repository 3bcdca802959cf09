//! What lies under each pixel of a picture: the object, the point, and the surface there.
//!
//! In: a scene's pipeline and the moment of a picture. Out: [`Identity`], which answers without the GPU.

use std::collections::BTreeMap;
use std::time::Instant;

use glam::{Vec2, Vec3, uvec2};

use super::slices::SLICE;
use super::{Gpu, GpuError, Pace, Pipeline, Region, Tracer};
use crate::frame::{Lens, Moment, View};
use crate::ir;

/// The cosine below which a slant no longer counts: a silhouette covers nothing.
const SLANT: f32 = 0.1;

/// The first surface along the ray through the middle of each pixel.
#[derive(Clone, Debug)]
pub struct Identity {
    size: [u32; 2],
    lens: Lens,
    /// By rows from the top: u, v, object, distance.
    places: Vec<[f32; 4]>,
    /// The same: a normal, and the distance again.
    normals: Vec<[f32; 4]>,
}

/// A point of a surface as the camera sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// Its place among the scene's objects.
    pub object: u32,
    /// From the eye, scene units.
    pub distance: f32,
    /// In world space.
    pub position: Vec3,
    /// Outward, length 1, in world space, without bumps.
    pub normal: Vec3,
    /// As textures get it, and not only its fraction.
    pub uv: Vec2,
}

impl Identity {
    /// Draws twice with the scene's own pipeline, which casts no shadow and follows no mirror for it.
    ///
    /// `render` is that of the scene, and the view of `moment` does not matter.
    ///
    /// # Errors
    /// Where the GPU has no texture of `size`, or stops to answer.
    pub fn draw(
        gpu: &Gpu,
        pipeline: &Pipeline,
        moment: &Moment,
        render: &ir::Render,
        size: [u32; 2],
    ) -> Result<Self, GpuError> {
        let mut survey = Survey::new(gpu, moment, render, size)?;
        loop {
            if let Some(identity) = survey.step(gpu, pipeline)? {
                return Ok(identity);
            }
        }
    }

    /// Width and height, pixels.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// What lies under the pixel `x` from the left and `y` from the top; None for the background, and outside
    /// the picture.
    pub fn at(&self, x: u32, y: u32) -> Option<Seen> {
        let object = self.object(x, y)?;
        let [u, v, _, distance] = self.places[self.index(x, y)];
        let [nx, ny, nz, _] = self.normals[self.index(x, y)];
        let direction = self.lens.direction(uvec2(x, y).as_vec2() + 0.5);
        Some(Seen {
            object,
            distance,
            position: self.lens.eye + distance * direction,
            normal: Vec3::new(nx, ny, nz),
            uv: Vec2::new(u, v),
        })
    }

    /// The object under a pixel, by its place among the scene's.
    pub fn object(&self, x: u32, y: u32) -> Option<u32> {
        let is_inside = x < self.size[0] && y < self.size[1];
        let [_, _, object, distance] = is_inside.then(|| self.places[self.index(x, y)])?;
        (distance >= 0.0).then_some(object as u32)
    }

    /// The pixels along the border of the chosen objects, by rows from the top: on each side one, so the line
    /// is two pixels wide. Where two chosen objects meet there is none, nor at the edge of the picture, nor
    /// where something else hides the chosen, or stands on them and is less than half as large.
    pub fn outline(&self, is_chosen: impl Fn(u32) -> bool) -> Vec<[u32; 2]> {
        let [width, height] = self.size;
        let chosen: Vec<bool> =
            self.places.iter().map(|place| place[3] >= 0.0 && is_chosen(place[2] as u32)).collect();
        let areas = self.areas();
        let area: usize = areas.iter().filter(|(object, _)| is_chosen(**object)).map(|(_, area)| area).sum();
        let mut is_border = vec![false; chosen.len()];
        let mut meet = |a: [u32; 2], b: [u32; 2]| {
            let [i, j] = [a, b].map(|[x, y]| self.index(x, y));
            let (own, other) = match (chosen[i], chosen[j]) {
                (true, false) => (a, b),
                (false, true) => (b, a),
                _ => return,
            };
            let is_end = match (self.at(own[0], own[1]), self.at(other[0], other[1])) {
                (Some(own), Some(other)) if self.touch(&own, &other) => area <= 2 * areas[&other.object],
                (Some(own), Some(other)) => own.distance < other.distance,
                _ => true,
            };
            is_border[i] |= is_end;
            is_border[j] |= is_end;
        };
        for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
            if x + 1 < width {
                meet([x, y], [x + 1, y]);
            }
            if y + 1 < height {
                meet([x, y], [x, y + 1]);
            }
        }
        let pixels = (0..height).flat_map(|y| (0..width).map(move |x| [x, y]));
        pixels.filter(|[x, y]| is_border[self.index(*x, *y)]).collect()
    }

    /// How many pixels each object has.
    fn areas(&self) -> BTreeMap<u32, usize> {
        let mut areas = BTreeMap::new();
        for place in self.places.iter().filter(|place| place[3] >= 0.0) {
            *areas.entry(place[2] as u32).or_default() += 1;
        }
        areas
    }

    /// Whether two points that are seen beside each other lie on surfaces that meet there, and not one
    /// before the other.
    fn touch(&self, a: &Seen, b: &Seen) -> bool {
        // What a pixel covers of a surface, which grows as that is seen at a slant.
        let covers = |seen: &Seen| {
            let toward = (self.lens.eye - seen.position).normalize_or_zero();
            self.lens.pixel_size(seen.position) / toward.dot(seen.normal).abs().max(SLANT)
        };
        a.position.distance(b.position) <= covers(a) + covers(b)
    }

    fn index(&self, x: u32, y: u32) -> usize {
        (y * self.size[0] + x) as usize
    }
}

/// An [`Identity`] that is being drawn, slice by slice.
#[derive(Debug)]
pub struct Survey {
    tracer: Tracer,
    pace: Pace,
    moment: Moment,
    render: ir::Render,
    pixels_done: u32,
    /// Once they are drawn.
    places: Option<Vec<[f32; 4]>>,
}

impl Survey {
    /// Of a picture of `size`, as [`Identity::draw`] has it.
    ///
    /// # Errors
    /// Where the GPU has no texture of `size`.
    pub fn new(gpu: &Gpu, moment: &Moment, render: &ir::Render, size: [u32; 2]) -> Result<Self, GpuError> {
        Ok(Self {
            tracer: Tracer::new(gpu, size)?,
            pace: Pace::new(SLICE, gpu.is_software()),
            moment: Moment { view: View::Place, split: None, ..*moment },
            render: ir::Render { max_bounces: 0, shadows: false, texture_filter: false, ..*render },
            pixels_done: 0,
            places: None,
        })
    }

    /// Draws a slice, which takes about a tenth of a second; the whole, once it is there.
    ///
    /// # Errors
    /// Where a loop of the author's had to be ended, or the device stops to answer.
    pub fn step(&mut self, gpu: &Gpu, pipeline: &Pipeline) -> Result<Option<Identity>, GpuError> {
        let size = self.tracer.size();
        let begun = Instant::now();
        let region = Region::after(self.pixels_done, self.pace.pixels(), size);
        self.tracer.draw(pipeline, &self.moment, &self.render, [0.0; 2], &region);
        pipeline.finish(gpu)?;
        self.pace.learn(region.pixels(), begun.elapsed());
        self.pixels_done += region.pixels();
        if self.pixels_done < size[0] * size[1] {
            return Ok(None);
        }
        self.pixels_done = 0;
        self.tracer.next();
        let bytes = gpu.read_texture(self.tracer.picture(), 16)?;
        let values = bytemuck::pod_collect_to_vec(&bytes);
        self.tracer.restart();
        let Some(places) = self.places.take() else {
            self.places = Some(values);
            self.moment.view = View::Outward;
            return Ok(None);
        };
        let lens = Lens::new(&self.moment.camera, size);
        Ok(Some(Identity { size, lens, places, normals: values }))
    }
}
