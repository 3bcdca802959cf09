//! Models from files: what is read, what is repaired, which edges are smooth, what is refused.

mod damage;
mod glb_writer;
mod posing;
mod reading_glb;
mod reading_obj;
mod reload;
mod remote;
mod repairs;
mod smoothing;
mod tree;

use crate::shared_models::{decoded, random, shapes};
