//! Which of a scene's materials and images the shader asks for; others are declared only.
//!
//! In: a [`Scene`]. Out: indices.

use std::collections::BTreeSet;

use super::points::Point;
use super::{Material, Measure, Scene, Value};

impl Scene {
    /// What WebGPU lets a shader look up, without the models and the picture that gathers samples.
    pub const MAX_IMAGES: usize = 14;

    /// The materials that something is made of. A scene with mistakes may lack some.
    pub fn materials_in_use(&self) -> impl Iterator<Item = &Material> {
        let used: BTreeSet<usize> = self.primitives.iter().map(|primitive| primitive.material).collect();
        used.into_iter().filter_map(|index| self.materials.get(index))
    }

    /// The indices of the images that are looked up, in the order in which they are bound. One that is only
    /// measured comes last, so that the others are bound alike where nothing is measured.
    pub fn images_in_use(&self) -> Vec<usize> {
        let arguments = self.primitives.iter().flat_map(|primitive| &primitive.arguments);
        let properties = self.materials_in_use().flat_map(|material| {
            let bump = material.bump.iter().map(|bump| &bump.height);
            material.properties.iter().map(|(_, value)| value).chain(bump)
        });
        let mut bound: Vec<usize> = self.images_of(arguments.chain(properties).chain([&self.background]));
        if let Some(Measure::Texture(index)) = self.measure {
            let measured = self.images_of([&Value::Texture(index)]);
            let more: Vec<_> = measured.into_iter().filter(|image| !bound.contains(image)).collect();
            bound.extend(more);
        }
        bound
    }

    /// The images in `values`, in ascending order.
    fn images_of<'v>(&self, values: impl IntoIterator<Item = &'v Value>) -> Vec<usize> {
        let mut found = BTreeSet::new();
        let mut seen = BTreeSet::new();
        let mut open = vec![Point::of(values)];
        while let Some(point) = open.pop() {
            found.extend(point.images);
            open.extend(point.others.into_iter().map(|(_, other)| other));
            for index in point.named.into_iter().filter(|index| seen.insert(*index)) {
                open.extend(self.textures.get(index).map(|texture| Point::of([&texture.value])));
            }
        }
        found.into_iter().collect()
    }
}
