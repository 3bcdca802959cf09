//! Where the nodes of a glTF file stand: each by itself, copied, or as the joint of a skin.

use glam::{DAffine3, DMat4, DQuat, DVec3, Quat, Vec3};

use super::Reader;
use super::document::{Document, Instancing, Node, Skin, at};
use super::elements::Kind;
use crate::assets::model::MAX_TRIANGLES;
use crate::assets::model::found::too_many;

/// The matrix of each node to the scene.
///
/// # Errors
/// That no tree is made of them, in words that follow the file's name.
pub fn to_scene(document: &Document) -> Result<Vec<DMat4>, String> {
    let mut parents = vec![None; document.nodes.len()];
    for (index, node) in document.nodes.iter().enumerate() {
        for child in &node.children {
            at(&document.nodes, *child, "node")?;
            if parents[*child].replace(index).is_some() {
                return Err("is damaged: a node has two parents".into());
            }
        }
    }
    let mut matrices = vec![DMat4::IDENTITY; document.nodes.len()];
    let mut count = 0;
    let roots = (0..parents.len()).filter(|index| parents[*index].is_none());
    let mut waiting: Vec<(usize, DMat4)> = roots.map(|root| (root, DMat4::IDENTITY)).collect();
    while let Some((index, outer)) = waiting.pop() {
        let node = &document.nodes[index];
        count += 1;
        matrices[index] = outer * local(node);
        waiting.extend(node.children.iter().map(|child| (*child, matrices[index])));
    }
    if count < matrices.len() {
        return Err("is damaged: a node is its own ancestor".into());
    }
    Ok(matrices)
}

/// The nodes of the scene that can be seen.
///
/// # Errors
/// That one is not in the file, in words that follow its name.
pub fn visible(document: &Document) -> Result<Vec<usize>, String> {
    let mut found = vec![];
    let mut is_known = vec![false; document.nodes.len()];
    let mut waiting = document.roots()?;
    while let Some(index) = waiting.pop() {
        let node = at(&document.nodes, index, "node")?;
        if std::mem::replace(&mut is_known[index], true) {
            return Err("is damaged: a node has two parents".into());
        }
        if node.extensions.visibility.as_ref().is_none_or(|visibility| visibility.visible) {
            found.push(index);
            waiting.extend(&node.children);
        }
    }
    Ok(found)
}

fn local(node: &Node) -> DMat4 {
    if let Some(matrix) = &node.matrix {
        return DMat4::from_cols_array(matrix);
    }
    let scale = node.scale.map_or(DVec3::ONE, DVec3::from);
    let turn = node.rotation.map_or(DQuat::IDENTITY, DQuat::from_array);
    let turn = if turn.length_squared() > 0.0 { turn.normalize() } else { DQuat::IDENTITY };
    let translation = node.translation.map_or(DVec3::ZERO, DVec3::from);
    DAffine3::from_scale_rotation_translation(scale, turn, translation).into()
}

impl Reader<'_> {
    /// Where the copies of a node stand in its own space (`EXT_mesh_gpu_instancing`).
    pub fn instances(&self, instancing: &Instancing) -> Result<Vec<DMat4>, String> {
        let of = |name: &str, kind| self.named(&instancing.attributes, name, kind);
        let translations = of("TRANSLATION", Kind::Vec3)?;
        let rotations = of("ROTATION", Kind::Vec4)?;
        let scales = of("SCALE", Kind::Vec3)?;
        let counts = [&translations, &rotations, &scales].map(|all| all.as_ref().map(|all| all.count));
        let count = counts.into_iter().flatten().min().unwrap_or(1);
        if count > MAX_TRIANGLES {
            return Err(too_many());
        }
        let instance = |i: usize| {
            let scale = scales.as_ref().map_or(Vec3::ONE, |all| all.vector(i).into());
            let turn = rotations.as_ref().map_or(Quat::IDENTITY, |all| Quat::from_array(all.vector(i)));
            let turn = turn.as_dquat();
            let turn = if turn.length_squared() > 0.0 { turn.normalize() } else { DQuat::IDENTITY };
            let translation = translations.as_ref().map_or(Vec3::ZERO, |all| all.vector(i).into());
            DMat4::from_scale_rotation_translation(scale.as_dvec3(), turn, translation.as_dvec3())
        };
        Ok((0..count).map(instance).collect())
    }

    /// Where the joints of a skin take its corners.
    pub fn joints(&self, skin: &Skin) -> Result<Vec<DMat4>, String> {
        let inverses = skin.inverse_bind_matrices;
        let inverses = inverses.map(|index| self.elements(index, Kind::Mat4)).transpose()?;
        let joint = |(i, node): (usize, &usize)| {
            let matrix = *at(&self.matrices, *node, "node")?;
            let inverse = inverses.as_ref().filter(|all| i < all.count).map(|all| all.vector::<16>(i));
            Ok(matrix * inverse.map_or(DMat4::IDENTITY, |m| DMat4::from_cols_array(&m.map(f64::from))))
        };
        skin.joints.iter().enumerate().map(joint).collect()
    }
}
