//! The scene as the reference holds it: camera, background, lights, objects and render settings.

use super::color::{Transfer, read_color};
use super::light::Light;
use super::material::{Material, Reader};
use super::node::{Fields, Node};
use super::shapes::Shape;
use super::surface::has_uv;
use super::transform::Transform;
use super::vector::Vec3;

#[derive(Debug)]
pub struct Scene {
    pub camera: Camera,
    pub background: Background,
    pub ambient: Vec3,
    pub lights: Vec<Light>,
    pub objects: Vec<Object>,
    pub settings: Settings,
    /// What the file asks for and the reference cannot shade.
    pub unsupported: Vec<String>,
}

#[derive(Debug)]
pub struct Camera {
    eye: Vec3,
    target: Vec3,
    up: Vec3,
    fov_deg: f64,
}

#[derive(Debug)]
pub struct Background {
    zenith: Vec3,
    horizon: Vec3,
}

#[derive(Debug)]
pub struct Object {
    pub shape: Shape,
    pub material: Material,
    pub transform: Transform,
    pub visible: bool,
    pub casts_shadow: bool,
    /// Where it stands among the file's objects, from 0.
    pub index: usize,
}

#[derive(Debug)]
pub struct Settings {
    pub max_bounces: f64,
    pub shadows: bool,
    pub transfer: Transfer,
    pub exposure: f64,
}

impl Scene {
    /// Reads a scene; an error is what no renderer could accept, `unsupported` what this one cannot.
    pub fn parse(text: &str) -> Result<Scene, String> {
        let mut file = Fields::new("scene", Node::parse(text)?)?;
        let mut reader = Reader::default();
        if let Some(textures) = file.take("textures") {
            reader.textures = textures.map()?;
        }
        if let Some(materials) = file.take("materials") {
            reader.materials = materials.map()?;
        }
        let camera = Camera::read(file.need("camera")?)?;
        let background = file.read("background", Background::flat(Vec3::ZERO), Background::read)?;
        let ambient = file.read("ambient", Vec3::splat(0.1), read_color)?;
        let lights = file.take("lights").map_or(Ok(Vec::new()), Node::list)?;
        let lights = lights.into_iter().map(Light::read).collect::<Result<_, _>>()?;
        let mut objects = Vec::new();
        for (index, node) in file.need("objects")?.list()?.into_iter().enumerate() {
            objects.extend(Object::read(index, node, &mut reader)?);
        }
        let settings = Settings::read(file.take("render"), &mut reader)?;
        file.finish()?;
        let unsupported = reader.unsupported;
        Ok(Scene { camera, background, ambient, lights, objects, settings, unsupported })
    }
}

impl Camera {
    fn read(node: Node) -> Result<Camera, String> {
        let mut fields = Fields::new("camera", node)?;
        let camera = Camera {
            eye: fields.need_vector("eye")?,
            target: fields.need_vector("target")?,
            up: fields.vector("up", Vec3::Y)?,
            fov_deg: fields.number("fov_deg", 40.0)?,
        };
        fields.finish()?;
        Ok(camera)
    }

    /// Origin and unit direction through the centre of pixel (i, j), by "Camera rays".
    pub fn ray(&self, i: usize, j: usize, width: usize, height: usize) -> (Vec3, Vec3) {
        let forward = (self.target - self.eye).unit();
        let right = forward.cross(self.up).unit();
        let true_up = right.cross(forward);
        let (w, h) = (width as f64, height as f64);
        let x = (2.0 * (i as f64 + 0.5) / w - 1.0) * w / h;
        let y = 1.0 - 2.0 * (j as f64 + 0.5) / h;
        let reach = (0.5 * self.fov_deg.to_radians()).tan();
        (self.eye, (forward + (right * x + true_up * y) * reach).unit())
    }
}

impl Background {
    fn flat(color: Vec3) -> Background {
        Background { zenith: color, horizon: color }
    }

    fn read(node: &Node) -> Result<Background, String> {
        match node {
            Node::Call(name, _) if name == "Gradient" => {
                let mut fields = Fields::of_call(node.clone())?;
                let zenith = read_color(&fields.need("zenith")?)?;
                let horizon = read_color(&fields.need("horizon")?)?;
                fields.finish()?;
                Ok(Background { zenith, horizon })
            }
            color => read_color(color).map(Background::flat),
        }
    }

    /// From `horizon` at direction.y ≤ 0 to `zenith` at 1, linearly in y.
    pub fn color(&self, direction: Vec3) -> Vec3 {
        let share = direction[1].clamp(0.0, 1.0);
        self.horizon * (1.0 - share) + self.zenith * share
    }
}

impl Object {
    /// Nothing where the reference does not know the shape: the reader notes it.
    fn read(index: usize, node: Node, reader: &mut Reader) -> Result<Option<Object>, String> {
        let mut fields = Fields::of_call(node)?;
        let name = match fields.take("name") {
            Some(Node::Text(name)) => name,
            Some(other) => return Err(format!("a name in quotes is wanted, not {other:?}")),
            None => format!("{} {index}", fields.owner()),
        };
        let material = reader.material(fields.take("material"))?;
        let translate = fields.vector("translate", Vec3::ZERO)?;
        let rotate_deg = fields.vector("rotate_deg", Vec3::ZERO)?;
        let scale = fields.read("scale", Vec3::ONE, |node| match node {
            Node::Number(_) => node.number().map(Vec3::splat),
            other => other.vector(),
        })?;
        if scale.0.contains(&0.0) {
            return Err(format!("{name}: `scale` must not be 0"));
        }
        let visible = fields.flag("visible", true)?;
        let casts_shadow = fields.flag("casts_shadow", true)?;
        let Some(shape) = Shape::read(&mut fields)? else {
            reader.unsupported.push(format!("{name}: the shape `{}`", fields.owner()));
            return Ok(None);
        };
        fields.finish().map_err(|error| format!("{name}: {error}"))?;
        if material.is_patterned() && !has_uv(&shape) {
            reader.unsupported.push(format!("{name}: a pattern where no uv is fixed"));
        }
        let transform = Transform::new(scale, rotate_deg, translate);
        Ok(Some(Object { shape, material, transform, visible, casts_shadow, index }))
    }
}

impl Settings {
    fn read(node: Option<Node>, reader: &mut Reader) -> Result<Settings, String> {
        let mut fields = Fields::new("render", node.unwrap_or(Node::List(Vec::new())))?;
        fields.number("shadow_samples", 16.0)?;
        fields.flag("texture_filter", true)?;
        match fields.take("tone_map") {
            None => {}
            Some(Node::Word(word)) if word == "None" => {}
            Some(other) => reader.unsupported.push(format!("the tone map {other:?}")),
        }
        let settings = Settings {
            max_bounces: fields.number("max_bounces", 5.0)?,
            shadows: fields.flag("shadows", true)?,
            transfer: fields.read("transfer", Transfer::Srgb, Transfer::read)?,
            exposure: fields.number("exposure", 0.0)?,
        };
        fields.finish()?;
        Ok(settings)
    }
}
