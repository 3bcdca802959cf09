//! A number of each point that the camera sees, for whoever wants to look at that instead of the light.
//!
//! In: a name. Out: a [`Measure`].

use super::Scene;

/// Which number it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// What the surface's color is made of: what its ramp goes by, its pattern where that is a number, else
    /// the color's luminance.
    Pattern,
    /// Along the ray from the camera, scene units.
    Distance,
    /// The cosine between the normal and the way to the camera.
    Facing,
    U,
    V,
    /// Width of the pixel at the point, in the object's units.
    Footprint,
    /// One of [`Scene::textures`], on all surfaces; of a color the luminance.
    Texture(usize),
}

impl Measure {
    /// Those that every scene has, with the names by which they are asked for.
    pub const ALL: [(&str, Measure); 6] = [
        ("pattern", Measure::Pattern),
        ("distance", Measure::Distance),
        ("facing", Measure::Facing),
        ("u", Measure::U),
        ("v", Measure::V),
        ("footprint", Measure::Footprint),
    ];

    /// What `name` asks for: one of [`Measure::ALL`], or a texture that `scene` declares.
    pub fn named(scene: &Scene, name: &str) -> Option<Self> {
        let own = Self::ALL.iter().find(|(known, _)| *known == name).map(|(_, measure)| *measure);
        let declared = || scene.textures.iter().position(|texture| texture.name == name);
        own.or_else(|| declared().map(Measure::Texture))
    }

    /// The name by which it is asked for in `scene`.
    pub fn name(self, scene: &Scene) -> &str {
        match self {
            Measure::Texture(index) => &scene.textures[index].name,
            other => Self::ALL.iter().find(|(_, known)| *known == other).expect("all others are there").0,
        }
    }
}
