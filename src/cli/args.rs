//! What can be asked for on the command line.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};

use super::words::{adapter, frames, language, rate, reach, share, size, time, view};
use crate::export::Language;
use crate::frame::View;
use crate::gpu::AdapterChoice;

/// A playground for procedural, ray-traced scenes.
#[derive(Parser)]
#[command(
    version,
    about,
    max_term_width = 100,
    arg_required_else_help = true,
    after_help = "\
Examples:
  raytoy view scenes/table.ron                 open a scene; edit it in any editor and see each save
  raytoy render scenes/glass.ron -o glass.png  draw a scene to a file
  raytoy check scenes/                         tell all mistakes in all scenes
  raytoy test                                  compare all scenes with their goldens
  raytoy textures Brick                        what Brick takes"
)]
pub struct Arguments {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Subcommand)]
pub enum Command {
    /// Open a scene in a window; each save of it shows at once
    View(ViewOptions),
    /// Draw scenes to PNG or EXR files, or their frames to a movie
    Render(RenderOptions),
    /// Print the scene that a PNG file drawn by raytoy carries
    Scene {
        /// The picture, or - for standard input
        picture: PathBuf,
    },
    /// Tell all mistakes in scenes and in texture or shape files
    Check(CheckOptions),
    /// Compare scenes with their goldens, and hold textures and shapes to their laws
    Test(TestOptions),
    /// Tell what differs between two scenes: values, shader and picture
    Diff(DiffOptions),
    /// Print the shader of a scene, the scene's own functions first
    Generate(GenerateOptions),
    /// List the textures and mappings, or tell all about one
    Textures { name: Option<String> },
    /// List the shapes, or tell all about one
    Shapes { name: Option<String> },
    /// Draw every texture and shape, your own too, and write a page about them
    Gallery {
        /// The folder for the pictures and the page, README.md
        #[arg(short, long, value_name = "FOLDER")]
        output: PathBuf,
    },
    /// Print completions for a shell
    Completions { shell: clap_complete::Shell },
}

/// Which files a scene may name.
#[derive(Args)]
pub struct RootOption {
    /// The folder in which all files of the scenes lie. Unless told, it is the folder that raytoy runs in
    /// where that holds the scene, else the scene's own
    #[arg(long, value_name = "FOLDER")]
    pub root: Option<PathBuf>,
}

#[derive(Args)]
pub struct CheckOptions {
    /// Scenes, .wgsl files, or folders of them
    #[arg(required = true, value_name = "PATH")]
    pub paths: Vec<PathBuf>,
    #[command(flatten)]
    pub root: RootOption,
}

#[derive(Args)]
pub struct ViewOptions {
    /// The scene
    pub scene: PathBuf,
    #[command(flatten)]
    pub root: RootOption,
    /// Size of the window, unless told as it was last, and 1280x720 at first
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub size: Option<[u32; 2]>,
    /// fastest, software, or a part of its name
    #[arg(long, default_value = "fastest", value_parser = adapter)]
    pub adapter: AdapterChoice,
    /// Print a line of JSON for each thing that happens, for programs that drive raytoy
    #[arg(long)]
    pub events: bool,
}

#[derive(Args)]
#[command(after_help = "\
Examples:
  raytoy render scenes/table.ron -o table.png --size 1920x1080 --samples 16
  raytoy render scenes/table.ron -o normals.png --view normal
  raytoy render scenes/table.ron -o both.png --split normal       the picture and its normals
  raytoy render scenes/table.ron -o tiles.png --view value --value tiles
  raytoy render scenes/table.ron -o table.exr     linear light, depth Z and object index, 32-bit floats
  raytoy render scenes/*.ron -o gallery/          a picture for each scene
  raytoy render wave.ron -o wave.mp4 --frames 0..120      four seconds of a scene that moves
  raytoy render wave.ron -o wave/####.png --frames 0..120     wave/0000.png to wave/0119.png
  cat scene.ron | raytoy render - -o - > picture.png")]
pub struct RenderOptions {
    /// Scenes, or - for standard input
    #[arg(required = true, value_name = "SCENE")]
    pub scenes: Vec<PathBuf>,
    /// A .png or .exr file, a folder, or - for a PNG on standard output; with --frames a .mp4, .webm or .gif
    /// movie, or pictures with their numbers in place of #, such as frames/####.png
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    /// Width and height of the picture
    #[arg(long, value_name = "WxH", default_value = "960x540", value_parser = size)]
    pub size: [u32; 2],
    /// Samples for each pixel; one goes through its centre
    #[arg(long, value_name = "N", default_value_t = 1)]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=65536))]
    pub samples: u32,
    /// Seconds since the scene began
    #[arg(long, value_name = "S", default_value_t = 0.0, allow_negative_numbers = true)]
    #[arg(value_parser = time)]
    pub time: f32,
    /// Draw the frames FROM to TO - 1; frame n shows the scene at n / fps seconds
    #[arg(long, value_name = "FROM..TO", conflicts_with = "time", value_parser = frames)]
    pub frames: Option<std::ops::Range<u32>>,
    /// Frames a second
    #[arg(long, value_name = "N", default_value_t = 30.0, requires = "frames", value_parser = rate)]
    pub fps: f64,
    /// color, normal, depth, position, uv, object, material, bounces, shadow, nan, cost, facing or value
    #[arg(long, value_name = "NAME", default_value = "color", value_parser = view)]
    pub view: View,
    /// Draw this other view right of a divider
    #[arg(long, value_name = "NAME", value_parser = view)]
    pub split: Option<View>,
    /// Where the divider is: 0 is the left edge, 1 the right one
    #[arg(long, value_name = "SHARE", default_value_t = 0.5, requires = "split", value_parser = share)]
    pub split_at: f32,
    /// What the view `value` shows: pattern (the default), distance, facing, u, v, footprint, or a texture
    /// that the scene declares
    #[arg(long, value_name = "NAME")]
    pub value: Option<String>,
    /// The number at which the colors of that view end
    #[arg(long, value_name = "N", default_value_t = 1.0, value_parser = reach)]
    pub reach: f32,
    /// Read the scene's numbers from a uniform buffer, as the window does, instead of writing them out
    #[arg(long)]
    pub live: bool,
    /// Write the adapter, the shader's size and the milliseconds of each stage as JSON
    #[arg(long, value_name = "FILE")]
    pub stats: Option<PathBuf>,
    #[command(flatten)]
    pub root: RootOption,
    /// fastest, software, or a part of its name
    #[arg(long, default_value = "fastest", value_parser = adapter)]
    pub adapter: AdapterChoice,
}

#[derive(Args)]
#[command(after_help = "\
With --standalone and --lang the shader needs no raytoy any more. Its head says how to draw it.
Images and models of the scene go to FILE.texels, beside it; a Shadertoy takes none.

Examples:
  raytoy generate scenes/table.ron                             the shader that raytoy runs
  raytoy generate scenes/table.ron --standalone -o table.wgsl  for a WebGPU page or program of yours
  raytoy generate scenes/table.ron --lang glsl -o table.glsl   to paste at shadertoy.com
  raytoy generate scenes/table.ron --lang spirv -o table.spv   for Vulkan")]
pub struct GenerateOptions {
    /// A scene, or - for standard input
    pub scene: PathBuf,
    /// Read the scene's numbers from a uniform buffer, as the window does
    #[arg(long, conflicts_with_all = ["standalone", "lang"])]
    pub live: bool,
    /// One WGSL file that any WebGPU program can draw
    #[arg(long)]
    pub standalone: bool,
    /// Such a file in another language: glsl, which is for Shadertoy, spirv, msl or hlsl; or wgsl
    #[arg(long, value_name = "NAME", value_parser = language)]
    pub lang: Option<Language>,
    /// Where to write it, standard output unless told
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub root: RootOption,
}

#[derive(Args)]
#[command(after_help = "\
A scene x.ron is compared with its generated text, x.wgsl, and a small picture, x.png, beside it.
Textures and shapes need no goldens. A file x.test.ron sets size, samples and limits of a test.

Examples:
  raytoy test                           all scenes, textures and shapes below this folder
  raytoy test scenes/table.ron --bless  write the goldens of a scene; look at them
  raytoy test scenes --bless glass      write what changed of those with glass in their names
  raytoy test --report report.html      a page with the pictures and diffs of all failures
  raytoy test --format junit > out.xml  for continuous integration")]
pub struct TestOptions {
    /// Scenes, .wgsl files, or folders of them
    #[arg(default_value = ".", value_name = "PATH")]
    pub paths: Vec<PathBuf>,
    /// Write the goldens that are missing or differ, of all tests or of those with TEXT in their names
    #[arg(long, value_name = "TEXT", num_args = 0..=1, default_missing_value = "")]
    pub bless: Option<String>,
    /// Only tests with this in their names
    #[arg(long, value_name = "TEXT")]
    pub filter: Option<String>,
    /// Print the names of the tests, and run none
    #[arg(long)]
    pub list: bool,
    /// A folder for the goldens, in which the scenes' folders are mirrored
    #[arg(long, value_name = "FOLDER")]
    pub goldens: Option<PathBuf>,
    /// Write a page with the pictures and diffs of all failures
    #[arg(long, value_name = "FILE")]
    pub report: Option<PathBuf>,
    /// What goes to standard output
    #[arg(long, value_enum, default_value = "human")]
    pub format: TestFormat,
    /// Tests at a time; as many as there are processors unless told
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=64))]
    pub jobs: Option<u32>,
    #[command(flatten)]
    pub root: RootOption,
    /// software (the default where there is such a driver), fastest, or a part of its name, whose pictures
    /// may lie in x.NAME.png
    #[arg(long, value_name = "NAME", value_parser = adapter)]
    pub adapter: Option<AdapterChoice>,
}

#[derive(Args)]
#[command(after_help = "\
Scenes are .ron files, or .png files that raytoy drew, which carry their scenes. One of them may
be - for standard input, which is taken as if it lay beside the other one.

The exit code is 0 also where something differs. With --exit-code it is 1 then, 0 where values,
shader and all pixels are the same, and 2 where a scene or the call is wrong.

Examples:
  raytoy diff old.ron new.ron
  raytoy diff old.ron new.ron --report diff.html  a page with both pictures beside each other
  raytoy diff drawn.png now.ron --no-picture      what changed since a picture was drawn
  git show HEAD:scenes/table.ron | raytoy diff - scenes/table.ron")]
pub struct DiffOptions {
    /// What was
    pub old: PathBuf,
    /// What is
    pub new: PathBuf,
    /// Draw no pictures
    #[arg(long)]
    pub no_picture: bool,
    /// Write a page with the pictures, the values and the diff of the shaders
    #[arg(long, value_name = "FILE")]
    pub report: Option<PathBuf>,
    /// What goes to standard output
    #[arg(long, value_enum, default_value = "human")]
    pub format: DiffFormat,
    /// Exit with 1 where something differs
    #[arg(long)]
    pub exit_code: bool,
    #[command(flatten)]
    pub root: RootOption,
    /// Width and height of the pictures
    #[arg(long, value_name = "WxH", default_value = "320x180", value_parser = size)]
    pub size: [u32; 2],
    /// Samples for each pixel; one goes through its centre
    #[arg(long, value_name = "N", default_value_t = 4)]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=65536))]
    pub samples: u32,
    /// Seconds since the scenes began
    #[arg(long, value_name = "S", default_value_t = 0.0, allow_negative_numbers = true)]
    #[arg(value_parser = time)]
    pub time: f32,
    /// fastest, software, or a part of its name
    #[arg(long, default_value = "fastest", value_parser = adapter)]
    pub adapter: AdapterChoice,
}

/// How the difference of two scenes is told.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum DiffFormat {
    Human,
    Json,
}

/// How the outcome of tests is told.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum TestFormat {
    Human,
    Json,
    Junit,
}
