//! For programs: what was measured of two pictures.

use serde::Serialize;

use crate::judge::Verdict;

/// The numbers of a [`Verdict`].
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Measures {
    pub outliers: usize,
    pub structure: f64,
    pub window: f64,
    pub flip: f64,
}

impl Measures {
    pub fn of(verdict: &Verdict) -> Self {
        Self {
            outliers: verdict.outliers.count,
            structure: verdict.structure.mean,
            window: verdict.structure.least,
            flip: verdict.flip,
        }
    }
}
