//! What differs between two scenes: values, shader, picture.

use super::{PictureDifference, ShaderDifference};
use crate::compile::{Compiled, on_deep_stack};
use crate::scene::{Change, changes, parse};

/// How two scenes differ.
#[derive(Clone, Debug)]
pub struct SceneDifference {
    /// What messages call the old scene and the new one.
    pub names: [String; 2],
    pub values: Vec<Change>,
    pub shader: ShaderDifference,
    /// None where no picture was asked for.
    pub picture: Option<PictureDifference>,
    /// What drew the pictures, if something did.
    pub adapter: Option<String>,
}

impl SceneDifference {
    /// All but the picture, which needs a GPU. Both have their numbers written out.
    pub fn between(old: &Compiled, new: &Compiled) -> Self {
        let tree = |compiled: &Compiled| {
            parse(&compiled.scene.name, &compiled.text).expect("what compiles was parsed before")
        };
        let values = on_deep_stack(|| changes((&tree(old), &old.text), (&tree(new), &new.text)));
        Self {
            names: [old, new].map(|compiled| compiled.scene.name.clone()),
            values,
            shader: ShaderDifference::between(old, new),
            picture: None,
            adapter: None,
        }
    }

    /// Whether nothing differs at all; a picture not to the last step of a channel.
    pub fn is_none(&self) -> bool {
        let same_picture = self.picture.as_ref().is_none_or(PictureDifference::is_none);
        self.values.is_empty() && self.shader.is_none() && same_picture
    }
}
