//! What a module on its own takes from files: images and models, as texels in a file that lies beside it.
//!
//! In: a scene, and its module. Out: a [`Beside`].

use naga::{GlobalVariable, Module, ResourceBinding};

use crate::bindings::{Binding, Content, SAMPLER};
use crate::frame::{Texels, texels};
use crate::ir::Scene;

/// The texture of Metal that shaders/standalone.wgsl has as its samples: those of files begin at 1.
pub const MSL_SAMPLES: u8 = 0;

/// A file of texels, and what a host binds them to.
#[derive(Default)]
pub struct Beside {
    /// Variables of bind group 1 that an entry point uses, by their numbers.
    pub resources: Vec<Resource>,
    /// One texture behind the other.
    pub texels: Vec<u8>,
    /// Names of the images and models that the texels were made of.
    pub files: Vec<String>,
}

/// A variable of the module, and what a host binds to it.
pub struct Resource {
    pub binding: Binding,
    pub ty: &'static str,
    pub name: String,
    /// The resources that a host binds to it.
    pub content: String,
}

/// Alignment of a texture's first byte: Vulkan copies from multiples of a texel's size, which is 16 at most.
const ALIGNMENT: usize = 16;

impl Beside {
    pub fn new(scene: &Scene, module: &Module) -> Self {
        let mut beside = Self::default();
        let variable = |binding: Binding| {
            let place = Some(ResourceBinding { group: binding.group, binding: binding.number });
            module.global_variables.iter().map(|(_, variable)| variable).find(|v| v.binding == place)
        };
        let sampler = variable(SAMPLER).filter(|_| !scene.images_in_use().is_empty());
        beside.resources.extend(sampler.map(|variable| {
            let content = "linear in a level and between levels; repeats to all sides".to_owned();
            Resource::new(variable, SAMPLER, content)
        }));
        for texels in texels(scene) {
            // A texture that the scene declares and nothing uses is bound to nothing.
            if let Some(variable) = variable(texels.binding) {
                let content = beside.put(&texels);
                beside.resources.push(Resource::new(variable, texels.binding, content));
                beside.files.extend(texels.files);
            }
        }
        beside
    }

    /// Lays a texture behind the others, and returns its description.
    fn put(&mut self, Texels { format, size: [width, height], levels, files, .. }: &Texels) -> String {
        let start = self.texels.len().next_multiple_of(ALIGNMENT);
        self.texels.resize(start, 0);
        levels.iter().for_each(|level| self.texels.extend(level));
        let format = format!("{format:?}").to_lowercase();
        let count = levels.len();
        let noun = if count == 1 { "level" } else { "levels" };
        format!("{format}, {width}x{height}, {count} {noun} from byte {start}: {}", files.join(", "))
    }
}

impl Resource {
    fn new(variable: &GlobalVariable, binding: Binding, content: String) -> Self {
        let ty = match binding.content {
            Content::Sampler => "sampler",
            Content::Words => "texture_2d<u32>",
            Content::Image | Content::Texels => "texture_2d<f32>",
            Content::Uniform | Content::Storage { .. } => unreachable!("what is a buffer is in no file"),
        };
        Self { binding, ty, name: variable.name.clone().unwrap_or_default(), content }
    }
}
