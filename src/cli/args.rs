//! The commands, arguments and options of the command line.

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
  raytoy check scenes/                         report all mistakes in all scenes
  raytoy test                                  compare all scenes with their stored results
  raytoy textures Brick                        print the parameters of Brick"
)]
pub struct Arguments {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Subcommand)]
pub enum Command {
    /// Open a scene in a window, and draw it again after each save
    View(ViewOptions),
    /// Draw scenes to PNG or EXR files, or a moving scene to a movie
    Render(RenderOptions),
    /// Print the scene stored in a PNG file that raytoy drew
    Scene {
        /// The picture, or - for standard input
        picture: PathBuf,
    },
    /// Report all mistakes in scenes and in texture or shape files
    Check(CheckOptions),
    /// Compare scenes with their stored results (goldens), and check the laws of textures and shapes
    Test(TestOptions),
    /// Report the differences between two scenes: values, shader and picture
    Diff(DiffOptions),
    /// Print the shader of a scene
    Generate(GenerateOptions),
    /// List the textures and mappings, or describe one
    Textures { name: Option<String> },
    /// List the shapes, or describe one
    Shapes { name: Option<String> },
    /// Draw all textures and shapes, also your own, and write a page that shows them
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
    /// Folder that contains all files of the scenes [default: the current folder if it contains the scene,
    /// otherwise the folder of the scene]
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
    /// Window size [default: the last one used, 1280x720 the first time]
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub size: Option<[u32; 2]>,
    /// GPU to draw with: fastest, software, or a part of its name
    #[arg(long, default_value = "fastest", value_parser = adapter)]
    pub adapter: AdapterChoice,
    /// Print a line of JSON for each event, for programs that control raytoy
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
  raytoy render scenes/table.ron -o table.exr     light, depth and object index as 32-bit floats
  raytoy render scenes/*.ron -o gallery/          one picture for each scene
  raytoy render wave.ron -o wave.mp4 --frames 0..120      the first four seconds of a moving scene
  raytoy render wave.ron -o wave/####.png --frames 0..120     wave/0000.png to wave/0119.png
  cat scene.ron | raytoy render - -o - > picture.png")]
pub struct RenderOptions {
    /// Scenes, or - for standard input
    #[arg(required = true, value_name = "SCENE")]
    pub scenes: Vec<PathBuf>,
    /// A .png or .exr file, a folder, or - for a PNG on standard output. With --frames: a .mp4, .webm or .gif
    /// movie, or numbered pictures such as frames/####.png, where # stands for a digit
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    /// Width and height of the picture
    #[arg(long, value_name = "WxH", default_value = "960x540", value_parser = size)]
    pub size: [u32; 2],
    /// Samples for each pixel; a single sample goes through its center
    #[arg(long, value_name = "N", default_value_t = 1)]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=65536))]
    pub samples: u32,
    /// Time of the picture, in seconds
    #[arg(long, value_name = "S", default_value_t = 0.0, allow_negative_numbers = true)]
    #[arg(value_parser = time)]
    pub time: f32,
    /// Draw the frames FROM to TO - 1. Frame n shows the scene at n / fps seconds
    #[arg(long, value_name = "FROM..TO", conflicts_with = "time", value_parser = frames)]
    pub frames: Option<std::ops::Range<u32>>,
    /// Frames for each second
    #[arg(long, value_name = "N", default_value_t = 30.0, requires = "frames", value_parser = rate)]
    pub fps: f64,
    /// color, normal, depth, position, uv, object, material, bounces, shadow, nan, cost, facing or value
    #[arg(long, value_name = "NAME", default_value = "color", value_parser = view)]
    pub view: View,
    /// Draw a second view to the right of a dividing line
    #[arg(long, value_name = "NAME", value_parser = view)]
    pub split: Option<View>,
    /// Position of the dividing line: 0 is the left edge, 1 is the right edge
    #[arg(long, value_name = "SHARE", default_value_t = 0.5, requires = "split", value_parser = share)]
    pub split_at: f32,
    /// The number that `--view value` shows: pattern (the default), distance, facing, u, v, footprint, or a
    /// texture that the scene declares
    #[arg(long, value_name = "NAME")]
    pub value: Option<String>,
    /// The largest number that `--view value` has a color for
    #[arg(long, value_name = "N", default_value_t = 1.0, value_parser = reach)]
    pub reach: f32,
    /// Read the scene's numbers from a uniform buffer, as the window does
    #[arg(long)]
    pub live: bool,
    /// Write the GPU's name, the shader's size and the milliseconds of each stage as JSON
    #[arg(long, value_name = "FILE")]
    pub stats: Option<PathBuf>,
    #[command(flatten)]
    pub root: RootOption,
    /// GPU to draw with: fastest, software, or a part of its name
    #[arg(long, default_value = "fastest", value_parser = adapter)]
    pub adapter: AdapterChoice,
}

#[derive(Args)]
#[command(after_help = "\
With --standalone or --lang the shader works without raytoy. Comments at its start explain how to
draw it. Images and models go to a second file, FILE.texels, which Shadertoy cannot read.

Examples:
  raytoy generate scenes/table.ron                             the shader that raytoy runs
  raytoy generate scenes/table.ron --standalone -o table.wgsl  for your own WebGPU page or program
  raytoy generate scenes/table.ron --lang glsl -o table.glsl   to paste at shadertoy.com
  raytoy generate scenes/table.ron --lang spirv -o table.spv   for Vulkan")]
pub struct GenerateOptions {
    /// A scene, or - for standard input
    pub scene: PathBuf,
    /// Read the scene's numbers from a uniform buffer, as the window does
    #[arg(long, conflicts_with_all = ["standalone", "lang"])]
    pub live: bool,
    /// Print one WGSL file that any WebGPU program can draw
    #[arg(long)]
    pub standalone: bool,
    /// Print such a file in another language: glsl (for Shadertoy), spirv, msl, hlsl or wgsl
    #[arg(long, value_name = "NAME", value_parser = language)]
    pub lang: Option<Language>,
    /// Output file [default: standard output]
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub root: RootOption,
}

#[derive(Args)]
#[command(after_help = "\
A golden is a stored result that a person has looked at. A scene x.ron has two beside it: x.wgsl,
the shader, and x.png, a small picture. The file x.test.ron sets size, samples and limits of a test.
Goldens of a scene that no longer exists fail, and --bless with its name removes them.

Examples:
  raytoy test                           all scenes, textures and shapes below this folder
  raytoy test scenes/table.ron --bless  write the goldens of a scene; then look at them
  raytoy test scenes --bless glass      write the changed goldens with glass in their names
  raytoy test --report report.html      a page with the pictures and diffs of all failures
  raytoy test --format junit > out.xml  for continuous integration")]
pub struct TestOptions {
    /// Scenes, .wgsl files, or folders of them
    #[arg(default_value = ".", value_name = "PATH")]
    pub paths: Vec<PathBuf>,
    /// Write the goldens that are missing or different. TEXT selects tests by a part of their names
    #[arg(long, value_name = "TEXT", num_args = 0..=1, default_missing_value = "")]
    pub bless: Option<String>,
    /// Run only the tests with TEXT in their names
    #[arg(long, value_name = "TEXT")]
    pub filter: Option<String>,
    /// Print the names of the tests and run none of them
    #[arg(long)]
    pub list: bool,
    /// Folder for the goldens; it gets the same subfolders as the scenes [default: beside each scene]
    #[arg(long, value_name = "FOLDER")]
    pub goldens: Option<PathBuf>,
    /// Write a page with the pictures and diffs of all failures
    #[arg(long, value_name = "FILE")]
    pub report: Option<PathBuf>,
    /// Format of the result
    #[arg(long, value_enum, default_value = "human")]
    pub format: TestFormat,
    /// Number of tests that run at once [default: the number of processors, at most 8]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=64))]
    pub jobs: Option<u32>,
    #[command(flatten)]
    pub root: RootOption,
    /// GPU to draw with, as in render [default: software if installed]. x.NAME.png is its golden
    #[arg(long, value_name = "NAME", value_parser = adapter)]
    pub adapter: Option<AdapterChoice>,
}

#[derive(Args)]
#[command(after_help = "\
Each scene is a .ron file, or a .png file that raytoy drew: such pictures contain their scenes. One
of the two may be -, for standard input. Its file names count from the folder of the other scene.

The exit code is 0, even if the scenes differ. With --exit-code it is 0 if values, shader and all
pixels are equal, 1 if anything differs, and 2 if a scene or the call is wrong.

Examples:
  raytoy diff old.ron new.ron
  raytoy diff old.ron new.ron --report diff.html  a page with the two pictures side by side
  raytoy diff drawn.png now.ron --no-picture      the changes since a picture was drawn
  git show HEAD:scenes/table.ron | raytoy diff - scenes/table.ron")]
pub struct DiffOptions {
    /// The scene before
    pub old: PathBuf,
    /// The scene after
    pub new: PathBuf,
    /// Draw no pictures
    #[arg(long)]
    pub no_picture: bool,
    /// Write a page with the pictures, the values and the diff of the shaders
    #[arg(long, value_name = "FILE")]
    pub report: Option<PathBuf>,
    /// Format of the result
    #[arg(long, value_enum, default_value = "human")]
    pub format: DiffFormat,
    /// Exit with 1 if anything differs
    #[arg(long)]
    pub exit_code: bool,
    #[command(flatten)]
    pub root: RootOption,
    /// Width and height of the pictures
    #[arg(long, value_name = "WxH", default_value = "320x180", value_parser = size)]
    pub size: [u32; 2],
    /// Samples for each pixel; a single sample goes through its center
    #[arg(long, value_name = "N", default_value_t = 4)]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=65536))]
    pub samples: u32,
    /// Time of the pictures, in seconds
    #[arg(long, value_name = "S", default_value_t = 0.0, allow_negative_numbers = true)]
    #[arg(value_parser = time)]
    pub time: f32,
    /// GPU to draw with: fastest, software, or a part of its name
    #[arg(long, default_value = "fastest", value_parser = adapter)]
    pub adapter: AdapterChoice,
}

/// Output format of `raytoy diff`.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum DiffFormat {
    Human,
    Json,
}

/// Output format of `raytoy test`.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum TestFormat {
    Human,
    Json,
    Junit,
}
