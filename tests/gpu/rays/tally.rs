//! What came of many rays.

/// What came of the rays at one shape.
#[derive(Default)]
pub struct Tally {
    pub rays: u64,
    /// Of them, those that pass too near to an edge or silhouette to be judged.
    pub excluded: u64,
    /// What only one of the two meets.
    pub false_hits: u64,
    pub misses: u64,
    /// From the crossing to the surface, as a share of the distance, or of the shape's radius if that is more.
    pub surface: Vec<f32>,
    /// The same along the ray.
    pub along: Vec<f32>,
    /// Between the normals there, radians.
    pub normal: Vec<f32>,
    /// The same, but the reference's at the very point that the probe gives.
    pub own_normal: Vec<f32>,
    /// The ray that is farthest off, or that one of the two misses.
    pub worst: Option<(f64, String)>,
}

impl Tally {
    pub fn judged(&self) -> u64 {
        self.rays - self.excluded
    }

    pub fn join(&mut self, mut other: Tally) {
        self.rays += other.rays;
        self.excluded += other.excluded;
        self.false_hits += other.false_hits;
        self.misses += other.misses;
        self.surface.append(&mut other.surface);
        self.along.append(&mut other.along);
        self.normal.append(&mut other.normal);
        self.own_normal.append(&mut other.own_normal);
        if let Some((off, ray)) = other.worst {
            self.note(off, || ray);
        }
    }

    pub fn note(&mut self, off: f64, ray: impl FnOnce() -> String) {
        if self.worst.as_ref().is_none_or(|(most, _)| off > *most) {
            self.worst = Some((off, ray()));
        }
    }
}

/// The largest of `values`, and what a `share` of them stays below.
pub fn extent(values: &mut [f32], share: f64) -> (f32, f32) {
    values.sort_by(f32::total_cmp);
    let at =
        |share: f64| values.get((values.len().saturating_sub(1) as f64 * share).round() as usize).copied();
    (at(1.0).unwrap_or(0.0), at(share).unwrap_or(0.0))
}
