//! Handles by which a hand moves things in the picture: where they are, and which values they change.
//!
//! In: an outline, a camera, the pointer. Out: new values for fields of the scene. Nothing here draws or
//! knows of a window. Places on the screen are pixels of the picture, from its top left corner.

mod ball;
mod hand;
mod look;
mod movable;
mod tripod;

pub use ball::Ball;
pub use hand::{Handles, Viewport};
pub use movable::{Direction, Known, Movable, Place, movables};
pub use tripod::{GAP, Handle, Tripod, to_segment};
