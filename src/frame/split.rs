//! Two views of one moment beside each other, in one picture.
//!
//! In: the view on the left, and a [`Split`]. Out: which columns of the picture show what.

use std::ops::Range;

use super::View;

/// Another view right of a divider.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Split {
    pub view: View,
    /// The place of the divider, as a share of the picture's width: 0 is the left edge, 1 the right one.
    pub at: f32,
}

impl Split {
    /// The first column right of the divider, in a picture `width` pixels wide.
    pub fn column(self, width: u32) -> u32 {
        (self.at.clamp(0.0, 1.0) * width as f32).round() as u32
    }
}

impl View {
    /// The columns that show light, in a picture of this view, `width` pixels wide, which `split` divides.
    pub fn columns_of_light(self, split: Option<Split>, width: u32) -> Range<u32> {
        let divider = split.map_or(width, |split| split.column(width));
        let right = split.map_or(self, |split| split.view);
        match (self == View::Color, right == View::Color) {
            (true, true) => 0..width,
            (true, false) => 0..divider,
            (false, true) => divider..width,
            (false, false) => 0..0,
        }
    }
}
