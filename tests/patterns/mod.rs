//! Textures of the library as calls with arguments, and what a probe tells of their values at many points.
// Each binary uses a part of it.
#![allow(dead_code)]

use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

use glam::{Vec2, Vec3};
use raytoy::gpu::{AdapterChoice, Gpu, Moment, Probe, SurfacePoint};
use raytoy::library::{Family, Function, Library, Parameter, Type};
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;
use raytoy::{Compiled, compile};

/// Texture files: those that ship with raytoy, and more at paths like `textures/NAME.wgsl`.
#[derive(Default)]
pub struct World {
    pub files: Vec<(String, String)>,
    /// Whether the files that ship are left out of [`World::textures`].
    pub only: bool,
}

impl World {
    /// All textures, sorted by name.
    pub fn textures(&self) -> Vec<Arc<Function>> {
        let sources = self.sources();
        let library = Library::new(&sources, Path::new(""));
        let find = |name: &String| {
            library.find(Family::Texture, name).unwrap_or_else(|problems| panic!("{name}: {problems:?}"))
        };
        let all = library.names(Family::Texture).iter().map(find).collect::<Vec<_>>();
        all.into_iter().filter(|f| !self.only || self.files.iter().any(|(file, _)| *file == f.file)).collect()
    }

    fn sources(&self) -> Sources {
        self.files.iter().fold(Sources::in_memory(), |sources, (path, text)| sources.with(path, text))
    }

    /// A scene in which object i emits the value of the i-th call.
    fn compiled(&self, calls: &[String], mode: Mode, before: Option<&Compiled>) -> Compiled {
        let objects = calls.iter().map(|call| format!("    Sphere(material: (emission: {call})),\n"));
        let text = format!("(objects: [\n{}])", objects.collect::<String>());
        let outcome = compile(&self.sources().with("panel.ron", &text), Path::new("panel.ron"), mode, before);
        outcome.compiled.unwrap_or_else(|| panic!("{}", outcome.report))
    }
}

/// `Name(argument: value, …)`; `value` gives None where the default is to stay.
pub fn call(function: &Function, mut value: impl FnMut(&Parameter) -> Option<String>) -> String {
    let argument = |p: &Parameter| value(p).map(|value| format!("{}: {value}", p.name));
    let arguments: Vec<String> = function.parameters.iter().filter_map(argument).collect();
    format!("{}({})", function.name, arguments.join(", "))
}

/// What stands for a parameter that has no default.
pub fn stand_in(parameter: &Parameter) -> String {
    let (low, high) = parameter.range.unwrap_or((0.0, 1.0));
    match parameter.ty {
        // Patterns and colors are what such parameters are there for, as in combinations of textures.
        Type::F32 if low <= 0.0 && high >= 1.0 => "Noise(scale: 1.3)".into(),
        Type::Vec3 if !parameter.nonzero => "Checker(scale: 0.7)".into(),
        Type::F32 => (0.5 * (low + high)).to_string(),
        Type::I32 | Type::U32 => format!("{}", 1.0_f32.clamp(low, high.max(1.0))),
        Type::Bool => "true".into(),
        Type::Vec2 => "(0.4, 0.7)".into(),
        Type::Vec3 => "(0.3, 0.8, -0.5)".into(),
        Type::Vec4 => "(0.4, 0.7, 0.2, 0.9)".into(),
        Type::Model => "\"scenes/models/gem.glb\"".into(),
    }
}

/// An argument within the parameter's documented range, now and then at an end of it.
pub fn random_argument(parameter: &Parameter, random: &mut Random) -> String {
    if !parameter.choices.is_empty() {
        return parameter.choices[random.below(parameter.choices.len())].clone();
    }
    let mut number = || random_number(parameter, random);
    match parameter.ty {
        Type::Bool => (number() < 0.5).to_string(),
        Type::I32 | Type::U32 => number().round().to_string(),
        Type::F32 => number().to_string(),
        Type::Vec2 => format!("({}, {})", number(), number()),
        Type::Vec3 => format!("({}, {}, {})", number(), number(), number()),
        Type::Vec4 => format!("({}, {}, {}, {})", number(), number(), number(), number()),
        Type::Model => stand_in(parameter),
    }
}

/// Another texture for a color, or for a number from 0 to 1.
pub fn texture_argument(parameter: &Parameter, random: &mut Random) -> Option<String> {
    let scale = 0.3 + 3.0 * random.unit();
    match parameter.ty {
        Type::F32 if parameter.range == Some((0.0, 1.0)) => Some(format!("Noise(scale: {scale})")),
        Type::Vec3 if parameter.is_color => Some(format!("Checker(scale: {scale})")),
        _ => None,
    }
}

fn random_number(parameter: &Parameter, random: &mut Random) -> f32 {
    let default = parameter.default.map_or(1.0, |value| value.numbers()[0]);
    let (low, high) = parameter.range.unwrap_or(match parameter.ty {
        _ if parameter.is_color || parameter.ty == Type::Bool => (0.0, 1.0),
        Type::U32 | Type::I32 => (0.0, 2.0 * default.max(2.0)),
        _ if parameter.nonzero => (-2.0, 2.0),
        _ => (default - default.abs().max(1.0), default + default.abs().max(1.0)),
    });
    let place = random.unit();
    match place {
        _ if place < 0.06 && !parameter.nonzero => low,
        _ if place > 0.94 => high,
        // A scale from 0.01 to 100 is as likely below 1 as above.
        _ if low > 0.0 && high / low > 50.0 => low * (high / low).powf(random.unit()),
        _ => low + (high - low) * random.unit(),
    }
}

/// Calls that are asked for their values.
pub struct Panel {
    compiled: Compiled,
    probe: Probe,
    calls: usize,
}

impl Panel {
    pub fn new(gpu: &Gpu, world: &World, calls: &[String], mode: Mode) -> Self {
        let compiled = world.compiled(calls, mode, None);
        let probe = Probe::build(gpu, &compiled, &Moment::of(&compiled.scene), [480, 270]);
        let probe = probe.unwrap_or_else(|error| panic!("{calls:?}: {error}"));
        Self { compiled, probe, calls: calls.len() }
    }

    /// Takes the numbers of other calls, which must differ in nothing else.
    pub fn renumber(&mut self, world: &World, calls: &[String]) {
        let next = world.compiled(calls, Mode::Live, Some(&self.compiled));
        assert_eq!(next.source.sections, self.compiled.source.sections, "{calls:?}");
        self.probe.upload(&next.source.numbers);
        self.compiled = next;
    }

    /// What each call gives at each point.
    pub fn values(&self, points: &[SurfacePoint]) -> Vec<Vec<Vec3>> {
        let of = |object| points.iter().map(move |point| SurfacePoint { object, ..*point });
        let asked: Vec<SurfacePoint> = (0..self.calls as u32).flat_map(of).collect();
        let looks = self.probe.materials(&asked).unwrap_or_else(|error| panic!("{error}"));
        looks.chunks(points.len()).map(|looks| looks.iter().map(|look| look.emission).collect()).collect()
    }
}

/// Calls `work` for each of `jobs`, each thread with a device of its own: the software driver compiles the
/// shaders of one device one after the other. Nothing where there is no device.
pub fn by_devices<J: Sync, R: Send>(jobs: &[J], work: impl Fn(&Gpu, &J) -> R + Sync) -> Option<Vec<R>> {
    let first = crate::common::gpu()?;
    let second = Gpu::headless(&AdapterChoice::Software).expect("there is one, so there are two");
    let next = AtomicUsize::new(0);
    let done = Mutex::new(vec![]);
    std::thread::scope(|scope| {
        for gpu in [first, &second] {
            let (next, done, work) = (&next, &done, &work);
            scope.spawn(move || {
                while let Some((i, job)) =
                    Some(next.fetch_add(1, Ordering::Relaxed)).and_then(|i| jobs.get(i).map(|job| (i, job)))
                {
                    let result = work(gpu, job);
                    done.lock().unwrap().push((i, result));
                }
            });
        }
    });
    let mut done = done.into_inner().unwrap();
    done.sort_by_key(|(i, _)| *i);
    Some(done.into_iter().map(|(_, result)| result).collect())
}

/// SplitMix64.
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ (x >> 31)
    }

    /// 0 to 1.
    pub fn unit(&mut self) -> f32 {
        (self.next() >> 40) as f32 / (1 << 24) as f32
    }

    /// -1 to 1.
    pub fn signed(&mut self) -> f32 {
        2.0 * self.unit() - 1.0
    }

    pub fn below(&mut self, count: usize) -> usize {
        (self.next() % count as u64) as usize
    }

    pub fn vector(&mut self) -> Vec3 {
        Vec3::new(self.signed(), self.signed(), self.signed())
    }
}

/// A point of a floor: uv is (x, z).
pub fn on_floor(position: Vec3, footprint: f32) -> SurfacePoint {
    let uv = Vec2::new(position.x, position.z);
    SurfacePoint { object: 0, position, normal: Vec3::Y, uv, world: position, footprint }
}
