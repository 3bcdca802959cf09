//! Commands: which there are, the keys that give them, and what becomes of each.

mod perform;
mod table;

pub use self::perform::keys_of;
pub use self::table::{COMMANDS, Command, DIGITS, GESTURES};
