//! A scene as a shader that needs no raytoy: for WebGPU, Shadertoy, Vulkan, Metal and Direct3D.
//!
//! In: a [`Compiled`] scene. Out: an [`Export`]: the bytes of a file, and of one beside it. Pure.

mod beside;
mod head;
mod integers;
mod native;
mod shadertoy;
mod standalone;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};

use self::standalone::{Standalone, settings};
use crate::compile::{Compiled, on_deep_stack};
use crate::wgsl::Host;

/// The language of the shader.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    Wgsl,
    /// GLSL ES 3.00 as Shadertoy takes it.
    Glsl,
    /// SPIR-V 1.0, little-endian.
    Spirv,
    /// Metal Shading Language 2.0.
    Msl,
    /// Shader model 5.1.
    Hlsl,
}

impl Language {
    /// All, with the names by which they are asked for.
    pub const ALL: [(&str, Language); 5] = [
        ("wgsl", Language::Wgsl),
        ("glsl", Language::Glsl),
        ("spirv", Language::Spirv),
        ("msl", Language::Msl),
        ("hlsl", Language::Hlsl),
    ];
}

/// A scene as files.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Export {
    pub shader: Vec<u8>,
    /// The texels of its textures, for a file beside it; empty where the scene reads no files. The head
    /// of the shader tells how to read it; SPIR-V has none, and the bindings and texels of WGSL.
    pub texels: Vec<u8>,
}

impl Export {
    /// The file with the texels of the shader in `file`: beside it, with `.texels` behind its name.
    pub fn texels_file(file: &Path) -> PathBuf {
        let mut beside = file.as_os_str().to_owned();
        beside.push(".texels");
        beside.into()
    }
}

/// Why a scene cannot stand on its own.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ExportError {
    /// It takes images or models from these files, which a Shadertoy cannot be given.
    NeedsFiles(Vec<String>),
    /// naga has something against it: a file of the author's has a name that an export uses, or a writer of
    /// naga lacks something.
    Refused(String),
}

impl std::fmt::Display for ExportError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            ExportError::NeedsFiles(files) => {
                let files: Vec<String> = files.iter().map(|file| format!("`{file}`")).collect();
                write!(
                    f,
                    "Shadertoy cannot read images and models from files: remove everything that uses {}",
                    files.join(", ")
                )
            }
            ExportError::Refused(why) => write!(f, "the scene cannot be exported: {why}"),
        }
    }
}

impl std::error::Error for ExportError {}

/// The scene as a shader in `language`, with its numbers as literals; the same bytes every time.
///
/// # Errors
/// If the scene cannot be exported.
pub fn export(compiled: &Compiled, language: Language) -> Result<Export, ExportError> {
    let scene = &compiled.scene;
    let host = match language {
        Language::Glsl => Host::Shadertoy { settings: settings(scene) },
        Language::Wgsl | Language::Spirv | Language::Msl | Language::Hlsl => Host::Any,
    };
    let write = || {
        let alone = Standalone::new(scene, host.clone())?;
        let shader = match language {
            Language::Wgsl => native::wgsl(scene, &alone).into_bytes(),
            Language::Glsl => shadertoy::glsl(scene, &alone)?.into_bytes(),
            Language::Spirv => native::spirv(&alone)?,
            Language::Msl => native::msl(scene, &alone)?.into_bytes(),
            Language::Hlsl => native::hlsl(scene, &alone)?.into_bytes(),
        };
        Ok(Export { shader, texels: alone.beside.texels })
    };
    on_deep_stack(|| {
        // naga's writers panic at some text that naga's own check lets pass.
        let written = catch_unwind(AssertUnwindSafe(write));
        written.unwrap_or_else(|panic| {
            let why = panic.downcast_ref::<String>().map_or("", String::as_str);
            Err(ExportError::Refused(format!("naga cannot write this shader: {why}")))
        })
    })
}
