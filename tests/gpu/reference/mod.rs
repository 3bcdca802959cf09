//! A CPU ray tracer in f64, written from LANGUAGE.md, that raytoy's pictures are judged by.
//!
//! It shares no code with raytoy. It shades what the contract fixes to the letter: closed-form
//! shapes, Checker and Stripes without a filter, hard shadows, reflection and refraction. Soft
//! lights shine from their middle. A scene that asks for more parses, and `render` says what it
//! cannot shade.

mod color;
mod hit;
mod light;
#[cfg(test)]
mod light_checks;
mod material;
mod node;
mod roots;
mod scene;
#[cfg(test)]
mod scene_checks;
mod shade;
mod shadow;
#[cfg(test)]
mod shape_checks;
mod shapes;
mod solids;
mod surface;
mod texture;
mod transform;
mod vector;

pub use self::{hit::nearest_hit, scene::Scene, shapes::Shape, surface::outward_normal};

use std::panic::resume_unwind;
use std::thread;

use self::shade::{Ray, facing_normal};
use self::vector::Vec3;

const THREADS: usize = 2;

/// One value for each pixel, row 0 on top.
#[derive(Debug)]
pub struct Picture {
    /// After exposure, tone map and transfer, clamped to 0..1.
    pub display: Vec<[f64; 3]>,
    pub radiance: Vec<[f64; 3]>,
    /// The distance along the primary ray of length 1; infinity where it leaves the scene.
    pub depth: Vec<f64>,
    /// The unit normal at the hit, turned towards the eye; zero where the ray leaves the scene.
    pub normal: Vec<[f64; 3]>,
    /// The place of the object seen among the file's objects; -1 where the ray leaves the scene.
    pub object: Vec<i64>,
}

/// Renders a scene, or says in words why it cannot.
pub fn render(scene_text: &str, width: usize, height: usize) -> Result<Picture, String> {
    let scene = Scene::parse(scene_text)?;
    if !scene.unsupported.is_empty() {
        return Err(format!("the reference cannot shade {}", scene.unsupported.join(", ")));
    }
    let row = |j: usize| (0..width).map(|i| pixel(&scene, i, j, width, height)).collect();
    let rows: Vec<Vec<Pixel>> = by_threads(height, row);
    let pixels: Vec<Pixel> = rows.into_iter().flatten().collect();
    let gain = scene.settings.exposure.exp2();
    let display = |radiance: Vec3| (radiance * gain).map(|c| scene.settings.transfer.encode(c)).0;
    Ok(Picture {
        display: pixels.iter().map(|pixel| display(pixel.radiance)).collect(),
        radiance: pixels.iter().map(|pixel| pixel.radiance.0).collect(),
        depth: pixels.iter().map(|pixel| pixel.depth).collect(),
        normal: pixels.iter().map(|pixel| pixel.normal.0).collect(),
        object: pixels.iter().map(|pixel| pixel.object).collect(),
    })
}

struct Pixel {
    radiance: Vec3,
    depth: f64,
    normal: Vec3,
    object: i64,
}

fn pixel(scene: &Scene, i: usize, j: usize, width: usize, height: usize) -> Pixel {
    let (origin, direction) = scene.camera.ray(i, j, width, height);
    let ray = Ray { origin, direction };
    let hit = scene.nearest(ray);
    Pixel {
        radiance: scene.radiance(ray, hit.as_ref(), &[], 0, 1.0),
        depth: hit.as_ref().map_or(f64::INFINITY, |hit| hit.t),
        normal: hit.as_ref().map_or(Vec3::ZERO, |hit| facing_normal(ray, hit)),
        object: hit.as_ref().map_or(-1, |hit| hit.object.index as i64),
    }
}

/// Calls `make` for 0..count, every `THREADS`th on one thread, and returns the results in order.
fn by_threads<T: Send>(count: usize, make: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let make = &make;
    let parts: Vec<Vec<T>> = thread::scope(|scope| {
        let share = |first| move || (first..count).step_by(THREADS).map(make).collect();
        let workers: Vec<_> = (0..THREADS).map(|first| scope.spawn(share(first))).collect();
        workers.into_iter().map(|worker| worker.join().unwrap_or_else(|e| resume_unwind(e))).collect()
    });
    let mut parts: Vec<_> = parts.into_iter().map(Vec::into_iter).collect();
    (0..count).filter_map(|n| parts[n % THREADS].next()).collect()
}
