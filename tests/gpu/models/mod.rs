//! Models as rays meet them, and as light falls on them.

mod aim;
mod brute_force;
mod closed;
mod combined;
mod crossings;
mod remote;
mod smoothness;
mod surfaces;

use std::path::Path;

use raytoy::frame::Moment;
use raytoy::gpu::{Crossing, Gpu, Probe, Ray};
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;
use raytoy::{Compiled, compile};

use crate::common::{expect_compiled, root};
use crate::shared_models::{decoded, random, shapes};
use brute_force::Soup;

/// A scene of one model, before the probe and before the reference.
struct Subject {
    name: &'static str,
    probe: Probe,
    soup: Soup,
}

impl Subject {
    /// The model that shapes.rs calls `name`; `fields` are those of its `Mesh`.
    fn new(gpu: &Gpu, name: &'static str, fields: &str) -> Self {
        let compiled = compiled(name, &format!("(objects: [Mesh(file: \"{name}\", {fields})])"));
        let soup = Soup::of(&compiled.scene.models[0]);
        Self { name, probe: probe(gpu, &compiled), soup }
    }

    fn ask(&self, rays: &[Ray]) -> Vec<Option<Crossing>> {
        self.probe.rays(rays).unwrap_or_else(|error| panic!("{}: {error}", self.name))
    }
}

/// The scene `text`, beside a model that shapes.rs calls `name`.
fn compiled(name: &str, text: &str) -> Compiled {
    let scene = "scenes/models/probe.ron";
    let sources = Sources::on_disk(&root()).with(scene, text);
    let made = shapes::made(name).into_iter().fold(sources, |sources, obj| {
        let beside = Path::new(scene).with_file_name(name);
        sources.with(beside, &obj)
    });
    expect_compiled(compile(&made, Path::new(scene), Mode::Live, None))
}

fn probe(gpu: &Gpu, compiled: &Compiled) -> Probe {
    let probe = Probe::build(gpu, compiled, &Moment::of(&compiled.scene), [480, 270]);
    probe.unwrap_or_else(|error| panic!("{error}"))
}
