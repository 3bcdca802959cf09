//! Names that a file's declarations may not have, since raytoy's shaders mean something else by them.
//!
//! In: a name. Out: who has it.

use std::collections::HashMap;
use std::sync::LazyLock;

use super::BUILT_IN;
use super::declarations::declarations;
use super::lexer::tokens;

/// What the text that is written for a scene declares.
const GENERATED: &str = "\
    ambientLight background heightAt isTextured lightAt live materialAt measuredAt normalAt partBlocks \
    rayTracePart rayTraceScene sceneBlocks setScene shown surfaceAt surfacePart LIGHTS TRANSMITS";

/// What Shadertoy and the languages of exports declare.
const EXPORTED: &str = "\
    mainImage main iResolution iTime iFrame iMouse";

const TYPES: &str = "\
    bool f16 f32 i32 u32 vec2 vec3 vec4 vec2i vec3i vec4i vec2u vec3u vec4u vec2f vec3f vec4f vec2h \
    vec3h vec4h mat2x2 mat2x3 mat2x4 mat3x2 mat3x3 mat3x4 mat4x2 mat4x3 mat4x4 mat2x2f mat2x3f mat2x4f \
    mat3x2f mat3x3f mat3x4f mat4x2f mat4x3f mat4x4f array atomic ptr sampler";

const FUNCTIONS: &str = "\
    bitcast all any select arrayLength abs acos acosh asin asinh atan atanh atan2 ceil clamp cos cosh \
    countLeadingZeros countOneBits countTrailingZeros cross degrees determinant distance dot \
    dot4U8Packed dot4I8Packed exp exp2 extractBits faceForward firstLeadingBit firstTrailingBit floor \
    fma fract frexp insertBits inverseSqrt ldexp length log log2 max min mix modf normalize pow \
    quantizeToF16 radians reflect refract reverseBits round saturate sign sin sinh smoothstep sqrt step \
    tan tanh transpose trunc dpdx dpdxCoarse dpdxFine dpdy dpdyCoarse dpdyFine fwidth fwidthCoarse \
    fwidthFine textureDimensions textureLoad textureSample textureSampleLevel pack4x8snorm pack4x8unorm \
    pack2x16snorm pack2x16unorm pack2x16float unpack4x8snorm unpack4x8unorm unpack2x16snorm \
    unpack2x16unorm unpack2x16float";

/// Who has `name` already.
pub fn owner(name: &str) -> Option<String> {
    static SHADERS: LazyLock<HashMap<String, &'static str>> = LazyLock::new(of_shaders);
    let is_in = |names: &str| names.split_whitespace().any(|taken| taken == name);
    if is_in(FUNCTIONS) || is_in(TYPES) {
        let noun = if is_in(TYPES) { "type" } else { "function" };
        return Some(format!("WGSL has a {noun} of this name"));
    }
    if let Some(file) = SHADERS.get(name) {
        return Some(format!("raytoy uses this name in {file}"));
    }
    if is_in(GENERATED) {
        return Some("raytoy uses this name in the shader of each scene".into());
    }
    is_in(EXPORTED).then(|| "exports use this name".into())
}

/// All that the files in shaders/ declare, but for the shapes: those may be hidden by an author's.
fn of_shaders() -> HashMap<String, &'static str> {
    let is_shared = |name: &str| name.strip_prefix("shaders/").is_some_and(|n| !n.contains('/'));
    let shared = BUILT_IN.iter().filter(|(name, _)| is_shared(name));
    let names = shared.flat_map(|(file, text)| {
        let found = declarations(&tokens(text)).into_iter().filter_map(|d| Some(d.name?.text.to_owned()));
        found.map(|name| (name, *file)).collect::<Vec<_>>()
    });
    names.collect()
}
