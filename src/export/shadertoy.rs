//! A scene as a Shadertoy.
//!
//! In: a module without files. Out: GLSL ES 3.00 with one function, `mainImage`, for Shadertoy to call.

use naga::back::glsl::{Options, PipelineOptions, Version, Writer, WriterFlags};
use naga::proc::BoundsCheckPolicies;
use naga::valid::ModuleInfo;
use naga::{Expression, Handle, MathFunction, Module, ScalarKind, TypeInner};

use super::standalone::Standalone;
use super::{ExportError, head};
use crate::ir::Scene;

/// Texts of shaders/shadertoy.wgsl as naga writes them and as Shadertoy needs them. It declares the inputs
/// itself, and calls a function with the output and the pixel.
const CHANGES: [(&str, &str); 8] = [
    ("#version 300 es\n\nprecision highp float;\nprecision highp int;\n\n", ""),
    ("vec3 iResolution = vec3(0.0);\n\n", ""),
    ("float iTime = 0.0;\n\n", ""),
    ("int iFrame = 0;\n\n", ""),
    ("vec4 iMouse = vec4(0.0);\n\n", ""),
    ("layout(location = 0) out vec4 _fs2p_location0;\n\n", ""),
    (
        "void main() {\n    vec4 fragCoord = gl_FragCoord;\n",
        "void mainImage(out vec4 fragColor, in vec2 fragCoord) {\n",
    ),
    ("    _fs2p_location0 = vec4(", "    fragColor = vec4("),
];

/// The names that Shadertoy declares.
const INPUTS: [&str; 4] = ["iResolution", "iTime", "iFrame", "iMouse"];

/// Functions that only later versions of GLSL have.
const LATER: [(MathFunction, &str); 11] = [
    (MathFunction::CountOneBits, "countOneBits"),
    (MathFunction::ReverseBits, "reverseBits"),
    (MathFunction::CountLeadingZeros, "countLeadingZeros"),
    (MathFunction::CountTrailingZeros, "countTrailingZeros"),
    (MathFunction::FirstLeadingBit, "firstLeadingBit"),
    (MathFunction::FirstTrailingBit, "firstTrailingBit"),
    (MathFunction::ExtractBits, "extractBits"),
    (MathFunction::InsertBits, "insertBits"),
    (MathFunction::Ldexp, "ldexp"),
    (MathFunction::Unpack4xI8, "unpack4xI8"),
    (MathFunction::Unpack4xU8, "unpack4xU8"),
];

/// naga's translation of shaders/shadertoy.wgsl, with what Shadertoy wants otherwise put right.
pub fn glsl(scene: &Scene, alone: &Standalone) -> Result<String, ExportError> {
    let Standalone { source, module, info, beside } = alone;
    let module = &with_locals_apart(module);
    if !beside.files.is_empty() {
        return Err(ExportError::NeedsFiles(beside.files.clone()));
    }
    refuse_unknown(module, info)?;
    let options =
        Options { version: Version::new_gles(300), writer_flags: WriterFlags::empty(), ..Default::default() };
    let pipeline = PipelineOptions {
        shader_stage: naga::ShaderStage::Fragment,
        entry_point: "mainImage".into(),
        multiview: None,
    };
    let mut text = String::new();
    let policies = BoundsCheckPolicies::default();
    Writer::new(&mut text, module, info, &options, &pipeline, policies)
        .and_then(|mut writer| writer.write())
        .map_err(|error| ExportError::Refused(error.to_string()))?;
    for (from, to) in CHANGES {
        // naga gives another name to what would be called as something before it.
        if text.matches(from).count() != 1 {
            let why = "a texture or shape uses a name that belongs to Shadertoy, such as `iTime`";
            return Err(ExportError::Refused(why.into()));
        }
        text = text.replacen(from, to, 1);
    }
    Ok(head::shadertoy(scene, source) + &text)
}

/// naga names what is within functions before what is outside, so that a variable `iTime` would take that
/// name away.
fn with_locals_apart(module: &Module) -> Module {
    let mut module = module.clone();
    let rename = |name: &mut String| {
        if INPUTS.contains(&name.as_str()) {
            name.push('_');
        }
    };
    for (_, function) in module.functions.iter_mut() {
        function.arguments.iter_mut().filter_map(|argument| argument.name.as_mut()).for_each(rename);
        function.local_variables.iter_mut().filter_map(|(_, local)| local.name.as_mut()).for_each(rename);
        function.named_expressions.values_mut().for_each(rename);
    }
    module
}

/// # Errors
/// If a function uses what naga writes although GLSL ES 3.00 lacks it: `select` of whole numbers or
/// switches, each component by itself.
fn refuse_unknown(module: &Module, info: &ModuleInfo) -> Result<(), ExportError> {
    for (handle, function) in module.functions.iter() {
        let ty = |expression: Handle<Expression>| info[handle][expression].ty.inner_with(&module.types);
        let is_unknown = |expression: &Expression| match expression {
            Expression::Select { condition, accept, .. } => {
                matches!(ty(*condition), TypeInner::Vector { .. })
                    && ty(*accept).scalar_kind() != Some(ScalarKind::Float)
            }
            _ => false,
        };
        let name = function.name.as_deref().unwrap_or_default();
        let later = function.expressions.iter().find_map(|(_, expression)| match expression {
            Expression::Math { fun, .. } => LATER.iter().find(|(later, _)| later == fun),
            _ => None,
        });
        if let Some((_, later)) = later {
            return Err(ExportError::Refused(format!("Shadertoy has no `{later}`, which `{name}` uses")));
        }
        if function.expressions.iter().any(|(_, expression)| is_unknown(expression)) {
            return Err(ExportError::Refused(format!(
                "Shadertoy has no `select` for vectors of whole numbers, which `{name}` uses; \
                 write one for each component"
            )));
        }
    }
    Ok(())
}
