//! Lights without size: where their light comes from and how much of it arrives.

use super::color::read_color;
use super::node::{Fields, Node};
use super::vector::Vec3;

#[derive(Clone, Debug)]
pub struct Light {
    place: Place,
    /// Color times intensity.
    strength: Vec3,
    inverse_square: bool,
}

#[derive(Clone, Debug)]
enum Place {
    Point(Vec3),
    /// The unit direction towards the light.
    Sky(Vec3),
    Spot {
        position: Vec3,
        forward: Vec3,
        cone: f64,
        blend: f64,
    },
}

/// What one light sends to a point: `to` ends at the light, or goes on forever.
pub struct Arriving {
    pub to: Vec3,
    pub endless: bool,
    pub strength: Vec3,
}

impl Light {
    /// Reads one light; a soft one shines from its middle.
    pub fn read(node: Node) -> Result<Light, String> {
        let mut fields = Fields::of_call(node)?;
        let place = match fields.owner() {
            "Point" => {
                fields.number("radius", 0.0)?;
                Place::Point(fields.need_vector("position")?)
            }
            "Directional" => {
                fields.number("angle_deg", 0.0)?;
                Place::Sky(-fields.need_vector("direction")?.unit())
            }
            "Spot" => {
                fields.number("radius", 0.0)?;
                let position = fields.need_vector("position")?;
                Place::Spot {
                    position,
                    forward: (fields.need_vector("target")? - position).unit(),
                    cone: fields.number("cone_deg", 30.0)?.to_radians(),
                    blend: fields.number("blend", 0.1)?,
                }
            }
            "Rect" => {
                let corner = fields.need_vector("corner")?;
                let middle = (fields.need_vector("u")? + fields.need_vector("v")?) * 0.5;
                Place::Point(corner + middle)
            }
            name => return Err(format!("the reference has no light `{name}`")),
        };
        let color = fields.read("color", Vec3::ONE, read_color)?;
        let intensity = fields.number("intensity", 1.0)?;
        let inverse_square = fields.read("falloff", false, |node| match node {
            Node::Word(word) if word == "None" => Ok(false),
            Node::Word(word) if word == "InverseSquare" => Ok(true),
            other => Err(format!("None or InverseSquare is wanted, not {other:?}")),
        })?;
        fields.finish()?;
        Ok(Light { place, strength: color * intensity, inverse_square })
    }

    pub fn arriving(&self, p: Vec3) -> Arriving {
        let (to, endless, share) = match self.place {
            Place::Point(position) => (position - p, false, 1.0),
            Place::Sky(towards) => (towards, true, 1.0),
            Place::Spot { position, forward, cone, blend } => {
                let to = position - p;
                (to, false, spot_share(-to.unit().dot(forward), cone, blend))
            }
        };
        let falloff = if self.inverse_square && !endless { 1.0 / to.dot(to) } else { 1.0 };
        Arriving { to, endless, strength: self.strength * (share * falloff) }
    }
}

/// The contract leaves the cone's edge open. Taken here: `cone` is the whole opening angle, as
/// `fov_deg` is, and its outer share `blend` fades. The fade, a smoothstep of the cosine, is raytoy's
/// own choice (shaders/light.wgsl), so here the reference is no independent witness.
fn spot_share(cosine: f64, cone: f64, blend: f64) -> f64 {
    let outer = (0.5 * cone).cos();
    let inner = (0.5 * cone * (1.0 - blend)).cos();
    if inner <= outer {
        return if cosine >= outer { 1.0 } else { 0.0 };
    }
    let x = ((cosine - outer) / (inner - outer)).clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}
