//! How long an edit of the structure takes from the save to a picture on a target of the GPU, without a window,
//! and without the driver's shader cache: `cargo test --test edit_bench -- [SCENE…]`, all of them unless told.
//! RAYTOY_ADAPTER names the GPU, the software driver unless told.

#[path = "../common/device.rs"]
mod device;

use std::time::{Duration, Instant};

use device::gpu;
use raytoy::frame::{FrameUniforms, Moment};
use raytoy::gpu::{Display, Gpu, LitColumns, Target, Tracer, render};
use raytoy::sketch::Sketch;
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;
use raytoy::{Compiled, compile};

const ROUNDS: usize = 20;
const SIZE: [u32; 2] = [1280, 720];
/// Pixels of the picture to one of its sketch.
const COARSENESS: u32 = 8;
const PATIENCE: Duration = Duration::from_secs(1);

fn main() {
    // The drivers read it, of Mesa and of NVIDIA. Nothing else runs in this program yet.
    unsafe { std::env::set_var("MESA_SHADER_CACHE_DISABLE", "true") };
    unsafe { std::env::set_var("__GL_SHADER_DISK_CACHE", "0") };
    unsafe { raytoy::gpu::prefer_quick_compiles() };
    let wanted: Vec<String> = std::env::args().skip(1).collect();
    let scenes = ["two_suns", "table", "mirror_room", "textures", "shapes", "glass", "solids", "fractals"];
    let Some(gpu) = gpu() else { return };
    println!("{}; a sketch of {}x{}", gpu.describe(), SIZE[0] / COARSENESS, SIZE[1] / COARSENESS);
    for name in scenes {
        if wanted.is_empty() || wanted.iter().any(|scene| scene == name) {
            measure(gpu, name);
        }
    }
}

/// Adds and removes a disk, which is another shader each time.
fn measure(gpu: &Gpu, name: &str) {
    let home = tempfile::TempDir::new().expect("there is room for a folder");
    let file = home.path().join("scene.ron");
    let scene = format!("{}/scenes/{name}.ron", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(scene).expect("it ships with raytoy");
    let display = Display::new(gpu, wgpu::TextureFormat::Rgba8Unorm);
    let mut before: Option<Compiled> = None;
    let (mut sketched, mut drawn) = (vec![], vec![]);
    for round in 0..ROUNDS {
        let disk = format!("Disk(name: \"round {round}\", center: (0, 0.01, 0), radius: 0.3),\n");
        let edited = match round % 2 {
            0 => text.replacen("objects: [", &format!("objects: [{disk}"), 1),
            _ => text.clone(),
        };
        let saved = Instant::now();
        std::fs::write(&file, edited).expect("the folder is writable");
        let outcome = compile(&Sources::on_disk(home.path()), &file, Mode::Live, before.as_ref());
        let compiled = outcome.compiled.expect("the scene is right");
        let baked = compiled.plain().expect("naga has taken the other text");
        sketched.extend(sketch(gpu, &display, &baked).then(|| saved.elapsed()));
        let moment = Moment::of(&compiled.scene);
        render(gpu, &baked, &moment, SIZE, 1, &mut |_| ()).expect("the driver draws it");
        drawn.push(saved.elapsed());
        before = Some(compiled);
    }
    println!("{name:<12} sketch, ms: {}   whole picture, ms: {}", spread(sketched), spread(drawn));
}

/// Draws a sketch as a screen shows it; whether there can be one.
fn sketch(gpu: &Gpu, display: &Display, compiled: &Compiled) -> bool {
    let Ok(sketch) = Sketch::new(compiled) else { return false };
    let size = SIZE.map(|n| n / COARSENESS);
    let render = &compiled.scene.render;
    let moment = Moment::of(&compiled.scene);
    let frame = FrameUniforms::new(&moment, render, compiled.scene.casters(), size, 0, [0.0; 2]);
    let Ok(pixels) = sketch.draw(&frame, PATIENCE) else { return false };
    let mut tracer = Tracer::new(gpu, size).expect("the size is small");
    tracer.fill(&pixels);
    let canvas = display.canvas(tracer.picture(), wgpu::TextureFormat::Rgba8Unorm);
    let light = LitColumns { render, columns: moment.view.columns_of_light(None, size[0]) };
    let target = canvas.create_view(&Default::default());
    display.draw(tracer.picture(), Some(light), &target, Target { corner: [0.0; 2], zoom: 1.0 });
    gpu.wait().expect("the device answers");
    true
}

/// Minimum, median, 95th percentile and maximum.
fn spread(mut values: Vec<Duration>) -> String {
    if values.is_empty() {
        return "none".into();
    }
    values.sort();
    let at = |share: f64| values[((values.len() - 1) as f64 * share).round() as usize].as_secs_f64() * 1e3;
    format!("min {:.0}, median {:.0}, p95 {:.0}, max {:.0}", at(0.0), at(0.5), at(0.95), at(1.0))
}
