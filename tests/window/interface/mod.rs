//! The parts of the tests of the panel, one for each thing that the panel does.

mod builder;
mod capture;
mod clock;
mod gallery;
mod harness;
mod history;
mod mistakes;
mod names;
mod shader;
mod tree;
mod untouched;
mod values;
mod viewport;
mod window;

/// A scene with a value of each kind.
const SCENE: &str = r##"(
    camera: (eye: (0, 0, 5), target: (0, 0, 0)), // looks along -z
    lights: [Point(position: (0, 5, 0), color: (4, 2, 1))],
    textures: { "tiles": Checker(odd: "tomato") },
    materials: { "gold": (color: "#ffd700"), "clay": (color: 0.5) },
    objects: [
        Sphere(name: "ball", radius: 1 /* one */, material: (color: "#ff0000", specular: Wave(shape: Saw), reflectivity: 0.25)),
        Box(name: "block", min: (-2, 0, 0), material: "gold"),
        Plane(name: "floor", material: (color: Ramp(by: Noise(scale: 2), stops: [(0, "red"), (0.5, "blue"), (1, 0.5)]))),
        Union(name: "both", parts: [Sphere(center: (0, 90, 0)), Box(max: (1, 91, 1))]),
    ],
)
"##;
