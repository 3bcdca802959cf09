//! Planes of numbers and filters over them that are products of a row and a column.

/// Numbers by rows from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane {
    pub width: usize,
    pub values: Vec<f64>,
}

impl Plane {
    /// Filtered along x by `kernel` of odd length with its middle at the pixel. What lies outside is as the
    /// nearest edge is.
    pub fn across(&self, kernel: &[f64]) -> Plane {
        let (width, reach) = (self.width, kernel.len() / 2);
        let mut values = vec![0.0; self.values.len()];
        let mut padded = vec![0.0; width + 2 * reach];
        for (row, sums) in self.values.chunks_exact(width).zip(values.chunks_exact_mut(width)) {
            padded[..reach].fill(row[0]);
            padded[reach..reach + width].copy_from_slice(row);
            padded[reach + width..].fill(row[width - 1]);
            for (weight, shifted) in kernel.iter().zip(padded.windows(width)) {
                add(sums, *weight, shifted);
            }
        }
        Plane { width, values }
    }

    /// Convolves along y.
    pub fn down(&self, kernel: &[f64]) -> Plane {
        let (width, reach) = (self.width, kernel.len() / 2);
        let last = self.values.len() / width - 1;
        let mut values = vec![0.0; self.values.len()];
        for (y, sums) in values.chunks_exact_mut(width).enumerate() {
            for (k, weight) in kernel.iter().enumerate() {
                let row = (y + k).saturating_sub(reach).min(last) * width;
                add(sums, *weight, &self.values[row..row + width]);
            }
        }
        Plane { width, values }
    }
}

fn add(sums: &mut [f64], weight: f64, values: &[f64]) {
    // By four, since tests are built with few optimisations.
    let (mut fours, mut rest) = (sums.chunks_exact_mut(4), values.chunks_exact(4));
    for (sums, values) in (&mut fours).zip(&mut rest) {
        sums[0] += weight * values[0];
        sums[1] += weight * values[1];
        sums[2] += weight * values[2];
        sums[3] += weight * values[3];
    }
    for (sum, value) in fours.into_remainder().iter_mut().zip(rest.remainder()) {
        *sum += weight * value;
    }
}
