//! What a picture needs besides its shader, as plain data: camera rays, a moment, uniforms, textures.
//!
//! In: [`crate::ir::Scene`]. Out: bytes and numbers that any host takes: a GPU, an export, the interpreter.

mod lens;
mod moment;
mod split;
mod texels;
mod uniforms;
mod view;

pub use self::lens::Lens;
pub use self::moment::Moment;
pub use self::split::Split;
pub use self::texels::{MODELS_ROW, TexelFormat, Texels, texels};
pub use self::uniforms::{FrameUniforms, sample_offset};
pub use self::view::View;
