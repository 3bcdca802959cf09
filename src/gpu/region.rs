//! A part of a picture that is drawn at once: rows, or in a picture that takes long a piece of one.

use std::ops::Range;

/// Pixels from the top left corner.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Region {
    pub columns: Range<u32>,
    pub rows: Range<u32>,
}

impl Region {
    /// What follows the first `done` pixels of a picture, by rows from the top: at least a pixel, and no more
    /// than `most`, in whole rows where it can be.
    pub fn after(done: u32, most: u32, [width, height]: [u32; 2]) -> Self {
        let (row, column) = (done / width, done % width);
        if column == 0 && most >= width {
            return Self { columns: 0..width, rows: row..row.saturating_add(most / width).min(height) };
        }
        let end = column.saturating_add(most.max(1)).min(width);
        Self { columns: column..end, rows: row..row + 1 }
    }

    /// Width and height, pixels.
    pub fn size(&self) -> [u32; 2] {
        [self.columns.len() as u32, self.rows.len() as u32]
    }

    /// Its first column and row.
    pub fn corner(&self) -> [u32; 2] {
        [self.columns.start, self.rows.start]
    }

    /// How many pixels it has.
    pub fn pixels(&self) -> u32 {
        self.columns.len() as u32 * self.rows.len() as u32
    }
}
