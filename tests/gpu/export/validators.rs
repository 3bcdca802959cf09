//! Khronos' validators, where they are installed: `apt install glslang-tools spirv-tools`.

use std::io::Write;
use std::process::{Command, Stdio};
use std::sync::Once;

/// What Shadertoy puts before a shader, and behind it.
const BEFORE: &str = "#version 300 es
precision highp float;
precision highp int;
uniform vec3 iResolution;
uniform float iTime;
uniform int iFrame;
uniform vec4 iMouse;
out vec4 shadertoy_out_color;
";
const BEHIND: &str = "
void main() {
    vec4 color = vec4(1e20);
    mainImage(color, gl_FragCoord.xy);
    shadertoy_out_color = vec4(color.xyz, 1.0);
}
";

/// What glslang has against a Shadertoy.
pub fn shadertoy_accepts(text: &str) -> Result<(), String> {
    static SKIPPED: Once = Once::new();
    let mut glslang = Command::new("glslangValidator");
    accepts(glslang.args(["--stdin", "-S", "frag"]), format!("{BEFORE}{text}{BEHIND}").as_bytes(), &SKIPPED)
}

/// What glslang has against `drawPicture` in HLSL.
pub fn direct3d_accepts(text: &str) -> Result<(), String> {
    static SKIPPED: Once = Once::new();
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let mut glslang = Command::new("glslangValidator");
    glslang.args(["--stdin", "-D", "-V", "-S", "frag", "-e", "drawPicture", "-o"]);
    let known: String = text.lines().map(known_to_glslang).collect();
    accepts(glslang.arg(folder.path().join("out.spv")), known.as_bytes(), &SKIPPED)
}

/// `line` without two things that compilers of Direct3D know and glslang does not: zero as an array, and a
/// constant that a function makes.
fn known_to_glslang(line: &str) -> String {
    match line.split_once(" = ") {
        Some((array, zero)) if zero.ends_with("])0;") => format!("{array};\n"),
        Some((model, made)) if model.starts_with("static const Model ") => {
            let root = made.trim_start_matches("ConstructModel(").trim_end_matches(");");
            format!("{model} = {{ {root} }};\n")
        }
        _ => format!("{line}\n"),
    }
}

/// What spirv-val has against a module for Vulkan.
pub fn vulkan_accepts(bytes: &[u8]) -> Result<(), String> {
    static SKIPPED: Once = Once::new();
    if !bytes.starts_with(&0x0723_0203_u32.to_le_bytes()) {
        return Err("it does not begin as SPIR-V does".into());
    }
    accepts(Command::new("spirv-val").args(["--target-env", "vulkan1.0", "-"]), bytes, &SKIPPED)
}

/// Past the capture of a test that passes: who runs the tests shall see it.
pub fn skip(why: &str) {
    let _ = writeln!(std::io::stderr(), "skipped: {why}");
}

/// What the validator says of its standard input, if that does not please it.
fn accepts(validator: &mut Command, input: &[u8], skipped: &Once) -> Result<(), String> {
    let piped = validator.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let Ok(mut child) = piped.spawn() else {
        let name = validator.get_program().to_string_lossy().into_owned();
        skipped.call_once(|| skip(&format!("there is no `{name}`")));
        return Ok(());
    };
    child.stdin.take().expect("it is piped").write_all(input).map_err(|error| error.to_string())?;
    let told = child.wait_with_output().map_err(|error| error.to_string())?;
    if told.status.success() {
        return Ok(());
    }
    Err(format!("{}{}", String::from_utf8_lossy(&told.stdout), String::from_utf8_lossy(&told.stderr)))
}
