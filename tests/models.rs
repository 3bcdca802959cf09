//! Models from files: what is read from them, what rays meet, and that no ray slips through.

mod common;
// A folder of the same name is where the parts lie.
#[path = "models/mod.rs"]
mod parts;
