//! An interpreter of naga's modules: no driver, no machine code.
//!
//! In: a valid module and its fragment shader. Out: the color and depth of each pixel of a square. The module
//! is lowered to a list of steps ([`Program`]); the [`Machine`] takes each of them for [`SIDE`] by [`SIDE`]
//! pixels at once, in loops that compilers turn into vector instructions.
//!
//! It is a crate of its own, since it needs full optimization, also where all else is built in a hurry.

mod image;
mod lanes;
mod lower;
mod machine;
mod op;
mod program;

pub use self::image::{Image, Level};
pub use self::lanes::{LANES, SIDE};
pub use self::lower::{Unsupported, lower};
pub use self::machine::{Inputs, Machine, OutOfTime};
pub use self::program::Program;
