//! Laws that textures and shapes keep whatever their arguments, and that need no golden to be judged by.
//!
//! In: [`Function`]s in a [`World`], and a [`Gpu`]. Out: the laws that they break, with an example of each.

mod arguments;
mod crossings;
mod panel;
mod random;
mod shapes;
mod textures;
pub mod values;
mod world;

use std::sync::Arc;

pub use panel::{Panel, on_floor};
pub use random::Random;
pub use shapes::check_shape;
pub use textures::check_textures;
pub use world::World;

use crate::diagnostic::Report;
use crate::gpu::{Gpu, GpuError};
use crate::library::{Function, Kind};

/// What holds for every texture or shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Law {
    IsFinite,
    StaysInRange,
    IsTheSameAgain,
    IsTheSameLiveAndBaked,
    IsHardUpClose,
    IsEvenFromAfar,
    IsMetByRays,
    KeepsToTheRay,
    HasItsSurfaceThere,
    HasUnitNormals,
    FacesTheRay,
    IsEnteredAndLeft,
    IsTheSameFromBehind,
}

impl Law {
    /// What holds, as a sentence.
    pub fn claim(self) -> &'static str {
        match self {
            Law::IsFinite => "all values are finite",
            Law::StaysInRange => {
                "values stay between 0 and 1, or where the doc line `/// gives LOW to HIGH` says"
            }
            Law::IsTheSameAgain => "the same question gets the same answer",
            Law::IsTheSameLiveAndBaked => "numbers as data give what numbers as text give",
            Law::IsHardUpClose => "a footprint of next to nothing changes next to nothing",
            Law::IsEvenFromAfar => "where a pixel covers very much, all pixels are nearly the same",
            Law::IsMetByRays => "some ray meets the shape",
            Law::KeepsToTheRay => "crossings lie between t_min and t_max",
            Law::HasItsSurfaceThere => "the surface is where the ray meets it",
            Law::HasUnitNormals => "normals have length 1",
            Law::FacesTheRay => "where a ray enters, the normal points against it",
            Law::IsEnteredAndLeft => "a ray from outside enters and leaves by turns, and ends outside",
            Law::IsTheSameFromBehind => "a ray that comes back meets first what it met last",
        }
    }
}

/// A law that does not hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Broken {
    /// Of the texture or shape.
    pub name: String,
    pub law: Law,
    /// The call, where it was asked, and what it gave.
    pub example: String,
}

impl std::fmt::Display for Broken {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} breaks the law that {}: {}", self.name, self.law.claim(), self.example)
    }
}

/// Why the laws could not be asked.
#[derive(Clone, Debug)]
pub enum Problem {
    /// The file has mistakes.
    Mistakes(Report),
    Gpu(GpuError),
}

impl From<Report> for Problem {
    fn from(report: Report) -> Self {
        Problem::Mistakes(report)
    }
}

impl From<GpuError> for Problem {
    fn from(error: GpuError) -> Self {
        match error {
            GpuError::Endless(report) => Problem::Mistakes(report),
            error => Problem::Gpu(error),
        }
    }
}

impl std::fmt::Display for Problem {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Problem::Mistakes(report) => write!(f, "{report}"),
            Problem::Gpu(error) => write!(f, "{error}"),
        }
    }
}

/// The laws that `function` breaks, once each.
///
/// # Errors
/// What is wrong with its file, or why the GPU refuses it.
pub fn check(gpu: &Gpu, world: &World, function: &Arc<Function>) -> Result<Vec<Broken>, Problem> {
    let found = match function.kind {
        Kind::Shape => check_shape(gpu, world, function)?,
        _ => check_textures(gpu, world, std::slice::from_ref(function))?,
    };
    let mut once: Vec<Broken> = vec![];
    for broken in found {
        if once.iter().all(|known| known.law != broken.law) {
            once.push(broken);
        }
    }
    Ok(once)
}
