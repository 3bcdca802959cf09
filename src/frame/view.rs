//! What a picture shows: light, or one of the debug views.
//!
//! In: a name or a number of shaders/view.wgsl. Out: the other.

/// A debug view: the content of a picture. The numbers are those of shaders/view.wgsl.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum View {
    /// The light that reaches the camera.
    #[default]
    Color,
    /// World normals, -1 to 1 shown as 0 to 1.
    Normal,
    /// Distance along the ray, nearer is brighter.
    Depth,
    /// World position, its fraction of a unit.
    Position,
    /// Surface coordinates, their fraction of a unit.
    Uv,
    /// One color for each object.
    Object,
    /// The surface's own color, without light.
    Material,
    /// Depth of the ray tree, white where it was cut.
    Bounces,
    /// Unblocked share of the lights.
    Shadow,
    /// Light that is infinite or no number in magenta, on a dim grey picture.
    Nan,
    /// Work of all rays on a scale of doublings: black is 1, pale yellow 65536.
    Cost,
    /// Outsides of surfaces in blue, insides in orange.
    Facing,
    /// The number that the scene measures, blue below 0 and red above.
    Value,
    /// Surface coordinates as they are, and the object's index. For [`crate::gpu::Identity`].
    Place,
    /// World normals as they are, outward and without bumps. For [`crate::gpu::Identity`].
    Outward,
}

impl View {
    /// Those to look at, with the names by which they are asked for.
    pub const ALL: [(&str, View); 13] = [
        ("color", View::Color),
        ("normal", View::Normal),
        ("depth", View::Depth),
        ("position", View::Position),
        ("uv", View::Uv),
        ("object", View::Object),
        ("material", View::Material),
        ("bounces", View::Bounces),
        ("shadow", View::Shadow),
        ("nan", View::Nan),
        ("cost", View::Cost),
        ("facing", View::Facing),
        ("value", View::Value),
    ];

    /// The name by which it is asked for.
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(_, view)| *view == self).expect("all are there").0
    }
}
