//! The comment at the head of an export: what it is, and how to draw it.
//!
//! In: a scene, and its module. Out: lines of comment.

use naga::{ScalarKind, TypeInner, VectorSize};

use super::beside::{Beside, MSL_SAMPLES, Resource};
use super::standalone::{Standalone, settings};
use crate::bindings::{Binding, Content, FRAME, SAMPLES};
use crate::ir::Scene;
use crate::library::Const;
use crate::wgsl::{Source, title_of};

/// How a language speaks of what a host binds.
pub struct Dialect {
    /// How raytoy is asked for it.
    option: &'static str,
    host: &'static str,
    /// How each kind of resource is bound.
    uniform: fn(Binding) -> String,
    samples: fn(Binding) -> String,
    texture: fn(Binding) -> String,
    sampler: fn(Binding) -> String,
}

pub const WGSL: Dialect = Dialect {
    option: "--standalone",
    host: "any WebGPU program",
    uniform: Binding::attributes,
    samples: Binding::attributes,
    texture: Binding::attributes,
    sampler: Binding::attributes,
};

pub const MSL: Dialect = Dialect {
    option: "--lang msl",
    host: "any Metal program",
    uniform: |binding| format!("[[buffer({})]]", binding.number),
    samples: |_| format!("[[texture({MSL_SAMPLES})]]"),
    texture: |binding| format!("[[texture({})]]", binding.number),
    sampler: |binding| format!("[[sampler({})]]", binding.number),
};

pub const HLSL: Dialect = Dialect {
    option: "--lang hlsl",
    host: "any Direct3D program",
    uniform: |binding| register('b', binding),
    samples: |binding| register('t', binding),
    texture: |binding| register('t', binding),
    sampler: |binding| register('s', binding),
};

/// The head of a module with the entry points of shaders/standalone.wgsl.
pub fn standalone(scene: &Scene, alone: &Standalone, dialect: &Dialect) -> String {
    let Dialect { option, host, .. } = dialect;
    let (frame, samples) = ((dialect.uniform)(FRAME), (dialect.samples)(SAMPLES));
    let (size, fields) = frame_layout(&alone.module);
    let table: String = fields.iter().map(|field| line(field, &settings(scene))).collect();
    let files = files(&alone.beside, dialect);
    let tangent = (scene.camera.fov / 2.0).tan();
    let how = format!(
        "
To draw it with {host}, one sample a pixel:
  vertex entry     coverPicture, without buffers: 3 vertices, a triangle that covers the target
  fragment entry   drawPicture, to a target such as bgra8unorm; not to one that ends in -srgb, since the
                   colors have the scene's transfer curve already
  uniform buffer   {frame}, {size} bytes, for the fragment entry

  byte  type   field           what goes there, little-endian
{table}{files}
Another camera: forward = normalize(target - eye), right = normalize(cross(forward, upwards)),
up = cross(right, forward); then right and up times {tangent}.

To draw many samples a pixel, n = 0, 1, 2 and so on:
  1. drawLight instead of drawPicture, to a texture of floats such as rgba16float, with sample = n, another
     jitter, and blending: source * c + target * (1 - c), where the blend constant c is 1 / (n + 1).
  2. coverPicture and showSamples to the screen, with that texture at {samples}.

"
    );
    commented(&(opening(scene, option) + &how))
}

/// Lists the contents for a language in which the scene's own section does not list what is in it.
pub fn translated(scene: &Scene, alone: &Standalone, dialect: &Dialect) -> String {
    plain(&(standalone(scene, alone, dialect) + &contents(&alone.source)))
}

/// The head of a Shadertoy.
pub fn shadertoy(scene: &Scene, source: &Source) -> String {
    let how = "
Paste all of it at shadertoy.com/new, in place of what is there.

  setScene()   the camera, and what the scene says under `render`: numbers to play with
  shown()      exposure, tone map and transfer curve
  iTime        is the time of what moves
  iMouse       is where the pointer was last pressed, for scenes that ask for it

naga has translated it from WGSL. To read it with its comments: raytoy generate --standalone

";
    plain(&(commented(&(opening(scene, "--lang glsl") + how)) + &contents(source)))
}

fn opening(scene: &Scene, option: &str) -> String {
    let title = in_one_line(title_of(scene));
    let version = env!("CARGO_PKG_VERSION");
    let call = format!("raytoy generate {title} {option}");
    format!("{title}: a scene as a shader of its own\nWritten by raytoy {version}: {call}\n")
}

/// The bytes of `Frame`, and for each field where it begins, its type and its name.
fn frame_layout(module: &naga::Module) -> (u32, Vec<(u32, &'static str, &str)>) {
    let frame = module.types.iter().find(|(_, ty)| ty.name.as_deref() == Some("Frame"));
    let Some((_, naga::Type { inner: TypeInner::Struct { members, span }, .. })) = frame else {
        unreachable!("shaders/frame.wgsl declares it, and all entry points use it")
    };
    let fields = members.iter().map(|member| {
        let ty = match module.types[member.ty].inner {
            TypeInner::Vector { size: VectorSize::Bi, .. } => "vec2f",
            TypeInner::Vector { .. } => "vec3f",
            TypeInner::Scalar(naga::Scalar { kind: ScalarKind::Uint, .. }) => "u32",
            _ => "f32",
        };
        (member.offset, ty, member.name.as_deref().unwrap_or_default())
    });
    (*span, fields.collect())
}

/// A field of `Frame`: where it lies, what the scene says of it, and what it is.
fn line((offset, ty, field): &(u32, &str, &str), settings: &[(&str, Const)]) -> String {
    let what = match *field {
        "eye" => "the camera's place",
        "time" => "seconds since the scene began",
        "right" => "the camera's right, as long as tan(fov / 2)",
        "pixel_spread" => "divided by the target's height in pixels; 0 samples patterns at points",
        "up" => "the camera's up, as long as that",
        "max_bounces" => "reflections and refractions in a row",
        "forward" => "the way the camera looks, of length 1",
        "shadow_samples" => "rays to each light that has a size; 0 for no shadows",
        "resolution" => "width and height of the target, pixels",
        "mouse" => "where the pointer was last pressed, pixels from the top left",
        "jitter" => "0, 0; for many samples another offset each from the pixel's middle, -1 to 1",
        "sample" => "0; for many samples n",
        _ => "0: only raytoy itself uses it",
    };
    let setting = settings.iter().find(|(name, _)| name == field);
    let number = setting.map_or(String::new(), |(_, value)| {
        // A zero has no sign.
        let numbers: Vec<String> = value.numbers().iter().map(|x| (x + 0.0).to_string()).collect();
        numbers.join(", ") + ": "
    });
    format!("  {offset:4}  {ty:5}  {field:14}  {number}{what}\n")
}

/// How to bind what lies beside the module; nothing where nothing does.
fn files(beside: &Beside, dialect: &Dialect) -> String {
    if beside.resources.is_empty() {
        return String::new();
    }
    let row = |Resource { binding, ty, name, content }: &Resource| {
        let place = match binding.content == Content::Sampler {
            true => (dialect.sampler)(*binding),
            false => (dialect.texture)(*binding),
        };
        format!("  {place:22}  {ty:15}  {name:12}  {}\n", in_one_line(content))
    };
    let table: String = beside.resources.iter().map(row).collect();
    format!(
        "
Images and models are textures, for the fragment entry too. Their texels are in the file beside this one
that has its name and .texels behind, {} bytes, little-endian. There each texture has its levels, the
largest first, each other one half as wide and as high as the one before it, rounded down, but at least 1;
and each level its rows, from the top, without gaps.

  bound to                type             name          what goes there
{table}",
        beside.texels.len()
    )
}

/// A register of HLSL, in the space of its group; space 0 is nowhere written out.
fn register(kind: char, binding: Binding) -> String {
    let space = if binding.group == 0 { String::new() } else { format!(", space{}", binding.group) };
    format!("register({kind}{}{space})", binding.number)
}

/// The list of objects, shapes and textures that a scene's own section opens with.
fn contents(source: &Source) -> String {
    let list = source.generated().lines().take_while(|line| line.starts_with("//"));
    list.map(|line| format!("{line}\n")).collect::<String>() + "\n"
}

/// `text` without what ends a line of WGSL, and with it the comment.
fn in_one_line(text: &str) -> String {
    text.replace(|c: char| c.is_control() || matches!(c, '\u{2028}' | '\u{2029}'), " ")
}

fn commented(text: &str) -> String {
    text.lines().map(|line| format!("// {line}").trim_end().to_owned() + "\n").collect()
}

/// Comments for compilers that take a backslash at the end of a line as a line that goes on, and of letters
/// only those of ASCII.
fn plain(text: &str) -> String {
    text.replace(|c: char| c == '\\' || !c.is_ascii(), "_")
}
