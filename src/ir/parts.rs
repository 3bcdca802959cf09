//! Which objects a solid is made of.

use super::Solid;

impl Solid {
    /// Whether it is or has this one of [`super::Scene::objects`].
    pub fn has(&self, object: usize) -> bool {
        match self {
            Solid::Object(index) => *index == object,
            Solid::Combination(combination) => combination.parts.iter().any(|part| part.has(object)),
        }
    }
}
