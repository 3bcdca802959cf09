//! The corners of a primitive of a glTF file, as they stand in the scene: morphed, then moved by a node or a
//! skin.

use glam::{DMat3, DMat4, DVec3, Vec2, Vec3};

use super::Reader;
use super::document::{Attributes, Primitive};
use super::elements::{Elements, Kind};
use crate::assets::model::found::Found;

/// What moves all corners of a primitive.
pub enum Mover<'a> {
    Node(Placing),
    /// Where its joints take them.
    Skin(&'a [DMat4]),
}

/// A matrix, with what normals go by.
pub struct Placing {
    matrix: DMat4,
    turned: DMat3,
    pub mirrors: bool,
}

impl Placing {
    pub fn new(matrix: DMat4) -> Self {
        let turned = DMat3::from_mat4(matrix).inverse().transpose();
        Self { matrix, turned, mirrors: matrix.determinant() < 0.0 }
    }
}

/// The lists of a primitive.
pub struct Corners<'a> {
    pub positions: Elements<'a>,
    pub normals: Option<Elements<'a>>,
    uvs: Option<Elements<'a>>,
    /// What each morph adds to positions and normals, by its weight.
    morphs: Vec<(f32, Option<Elements<'a>>, Option<Elements<'a>>)>,
    /// Sets of four joints and their weights.
    bonds: Vec<(Elements<'a>, Elements<'a>)>,
}

impl<'a> Reader<'a> {
    /// None where it has no positions.
    pub fn corners(&self, primitive: &Primitive, weights: &[f32]) -> Result<Option<Corners<'_>>, String> {
        let all = &primitive.attributes;
        let Some(positions) = self.named(all, "POSITION", Kind::Vec3)? else { return Ok(None) };
        let used = primitive.targets.iter().zip(weights).filter(|(_, weight)| **weight != 0.0);
        let morph = |(target, weight): (&Attributes, &f32)| {
            let of = |name| self.named(target, name, Kind::Vec3);
            Ok((*weight, of("POSITION")?, of("NORMAL")?))
        };
        let mut bonds = vec![];
        for set in 0.. {
            let of = |name| self.named(all, &format!("{name}_{set}"), Kind::Vec4);
            let (Some(joints), Some(weights)) = (of("JOINTS")?, of("WEIGHTS")?) else { break };
            bonds.push((joints, weights));
        }
        Ok(Some(Corners {
            positions,
            normals: self.named(all, "NORMAL", Kind::Vec3)?,
            uvs: self.named(all, "TEXCOORD_0", Kind::Vec2)?,
            morphs: used.map(morph).collect::<Result<_, String>>()?,
            bonds,
        }))
    }
}

impl Corners<'_> {
    /// Corner `i`, and whether its neighbours come in the other order; None where the file has none.
    pub fn at(&self, i: usize, mover: &Mover<'_>) -> Option<(Found, bool)> {
        let has = |elements: &&Elements<'_>| i < elements.count;
        let vector = |elements: &Elements<'_>| Vec3::from(elements.vector(i)).as_dvec3();
        let mut position = Some(&self.positions).filter(has).map(vector)?;
        let mut normal = self.normals.as_ref().filter(has).map(vector);
        for (weight, positions, normals) in &self.morphs {
            let weight = f64::from(*weight);
            position += weight * positions.as_ref().filter(has).map_or(DVec3::ZERO, vector);
            let added = normals.as_ref().filter(has).map_or(DVec3::ZERO, vector);
            normal = normal.map(|normal| normal + weight * added);
        }
        let blended = match mover {
            Mover::Skin(joints) => Some(Placing::new(self.blended(i, joints))),
            Mover::Node(_) => None,
        };
        let placing = match (&blended, mover) {
            (None, Mover::Node(placing)) => placing,
            (placing, _) => placing.as_ref()?,
        };
        let found = Found {
            position: placing.matrix.transform_point3(position),
            normal: normal.map(|normal| (placing.turned * normal).as_vec3()),
            uv: self.uvs.as_ref().filter(has).map(|all| {
                // glTF counts v from the top of an image.
                let [u, v] = all.vector(i);
                Vec2::new(u, 1.0 - v)
            }),
        };
        Some((found, placing.mirrors))
    }

    /// The mean of the joints that corner `i` hangs on.
    fn blended(&self, i: usize, joints: &[DMat4]) -> DMat4 {
        let (mut sum, mut total) = (DMat4::ZERO, 0.0);
        for (indices, weights) in
            self.bonds.iter().filter(|(joints, weights)| i < joints.count.min(weights.count))
        {
            let weights: [f32; 4] = weights.vector(i);
            for (index, weight) in indices.vector::<4>(i).into_iter().zip(weights) {
                if let Some(joint) = joints.get(index as usize).filter(|_| weight > 0.0) {
                    sum += *joint * f64::from(weight);
                    total += f64::from(weight);
                }
            }
        }
        if total > 0.0 { sum * (1.0 / total) } else { joints.first().copied().unwrap_or(DMat4::IDENTITY) }
    }
}
