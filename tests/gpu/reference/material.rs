//! Materials and the textures in them, with what a file declares by name.

use std::collections::BTreeMap;

use super::color::read_color;
use super::node::{Fields, Node};
use super::texture::{Texture, Tiles};
use super::vector::Vec3;

#[derive(Clone, Debug)]
pub struct Material {
    pub color: Texture,
    pub specular: Texture,
    pub shininess: Texture,
    pub reflectivity: Texture,
    pub fresnel: Option<f64>,
    pub transmission: Texture,
    pub ior: f64,
    pub emission: Texture,
}

impl Material {
    pub fn is_patterned(&self) -> bool {
        let textures = [
            &self.color,
            &self.specular,
            &self.shininess,
            &self.reflectivity,
            &self.transmission,
            &self.emission,
        ];
        !textures.iter().all(|texture| texture.is_constant())
    }
}

/// Resolves names while a scene is read, and collects what the reference cannot shade.
#[derive(Default)]
pub struct Reader {
    pub textures: BTreeMap<String, Node>,
    pub materials: BTreeMap<String, Node>,
    pub unsupported: Vec<String>,
}

impl Reader {
    /// A material by name or in place; matte grey 0.8 where it is left out.
    pub fn material(&mut self, node: Option<Node>) -> Result<Material, String> {
        let node = match node {
            None => Node::List(Vec::new()),
            Some(Node::Text(name)) => {
                self.materials.get(&name).cloned().ok_or_else(|| format!("no material is called {name:?}"))?
            }
            Some(node) => node,
        };
        let mut fields = Fields::new("material", node)?;
        let mut texture = |name: &str, default: f64| match fields.take(name) {
            Some(node) => self.texture(node).map_err(|error| format!("material: {name}: {error}")),
            None => Ok(Texture::grey(default)),
        };
        let color = texture("color", 0.8)?;
        let specular = texture("specular", 0.0)?;
        let shininess = texture("shininess", 50.0)?;
        let reflectivity = texture("reflectivity", 0.0)?;
        let transmission = texture("transmission", 0.0)?;
        let emission = texture("emission", 0.0)?;
        let fresnel = fields.read("fresnel", None, |node| node.number().map(Some))?;
        let ior = fields.number("ior", 1.5)?;
        if fields.take("bump").is_some() {
            self.unsupported.push("a material's `bump`".to_string());
        }
        fields.finish()?;
        Ok(Material { color, specular, shininess, reflectivity, fresnel, transmission, ior, emission })
    }

    fn texture(&mut self, node: Node) -> Result<Texture, String> {
        match node {
            Node::Text(name) if self.textures.contains_key(&name) => self.declared(&name),
            Node::Call(..) => self.call(Fields::of_call(node)?),
            constant => read_color(&constant).map(Texture::Constant),
        }
    }

    /// Reads a declared texture while its own name is hidden: one that names itself is an error.
    fn declared(&mut self, name: &str) -> Result<Texture, String> {
        let Some(node) = self.textures.remove(name) else {
            return Err(format!("no texture is called {name:?}"));
        };
        let texture = self.texture(node.clone());
        self.textures.insert(name.to_string(), node);
        texture
    }

    fn call(&mut self, mut fields: Fields) -> Result<Texture, String> {
        let form = match fields.owner() {
            "Checker" => Texture::Checker,
            "Stripes" => Texture::Stripes,
            name => {
                self.unsupported.push(format!("the texture `{name}`"));
                return Ok(Texture::Constant(Vec3::ZERO));
            }
        };
        if fields.take("at").is_some() {
            self.unsupported.push(format!("a mapping under `{}`", fields.owner()));
        }
        let scale = match fields.take("scale") {
            Some(node) => self.texture(node)?,
            None => Texture::grey(1.0),
        };
        let (even, odd) = (fields.need("even")?, fields.need("odd")?);
        let tiles = Tiles { scale, even: self.texture(even)?, odd: self.texture(odd)? };
        fields.finish()?;
        Ok(form(Box::new(tiles)))
    }
}
