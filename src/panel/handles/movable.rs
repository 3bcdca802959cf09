//! What of a scene a hand can move, and which of its fields say where it is.
//!
//! In: an [`Outline`], and what was changed since. Out: places and directions of the world, and the values
//! that their fields get. A solid whose transform is written is moved by `translate`, else one whose shape
//! has points by these, else by `translate` too. Points and corners of lights are theirs.

use glam::{DAffine3, DMat3, DVec3, Vec3};

use crate::ir::fields::OPERATIONS;
use crate::ir::{CsgOperation, placed};
use crate::outline::{Control, Field, Node, NodeKind, Outline};
use crate::scene::Path;

/// Something that a hand can move.
#[derive(Clone, Debug, PartialEq)]
pub enum Movable {
    Place(Place),
    Direction(Direction),
}

/// A place in the world, and the fields that move it.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// What the fields are called: `base, top`.
    pub name: String,
    /// In the world.
    pub at: Vec3,
    /// At least one; all of them move by the same.
    pub points: Vec<(Path, Vec3)>,
    /// From steps in the world to steps of the points.
    inward: DMat3,
}

/// A direction in the world, of any length but 0, and its field.
#[derive(Clone, Debug, PartialEq)]
pub struct Direction {
    pub path: Path,
    pub value: Vec3,
}

/// What is known of a scene: numbers set since the outline was made, and the middle of a shape without
/// points, by its index, in its own space.
pub struct Known<'a> {
    pub numbers: &'a dyn Fn(&Path) -> Option<Vec<f32>>,
    pub middle: &'a dyn Fn(usize) -> Option<Vec3>,
}

const TRANSFORM: [&str; 3] = ["translate", "rotate_deg", "scale"];
/// A part of a step that is smaller than this share of it is none: the hand moves along an axis.
const STILL: f64 = 1e-5;
/// Numbers have at most so many digits behind the point, and in front of it round to so many zeros.
const DIGITS: std::ops::RangeInclusive<i32> = -6..=9;

/// What can be moved of the object, part or light at `path`.
pub fn movables(outline: &Outline, path: &Path, known: &Known<'_>) -> Vec<Movable> {
    let mut around = vec![];
    let Some(node) = find(&outline.nodes, path, &mut around) else { return vec![] };
    match node.kind {
        NodeKind::Light => known.light(node),
        NodeKind::Object | NodeKind::Csg => {
            known.solid(node, &around).map(Movable::Place).into_iter().collect()
        }
        _ => vec![],
    }
}

impl Known<'_> {
    fn light(&self, node: &Node) -> Vec<Movable> {
        let vector = |label: &str| self.vector(field(node, label)?);
        let side = |label: &str| vector(label).unwrap_or(Vec3::ZERO);
        let mut found = vec![];
        if let Some(points) = self.points(node) {
            let at = mean(&points) + 0.5 * (side("u") + side("v"));
            found.push(Movable::Place(Place::new(points, at, DMat3::IDENTITY)));
        }
        if let (Some(target), Some(field)) = (vector("target"), field(node, "target")) {
            let points = vec![(field.path.clone(), target)];
            found.push(Movable::Place(Place::new(points, target, DMat3::IDENTITY)));
        }
        if let (Some(value), Some(field)) = (vector("direction"), field(node, "direction"))
            && value != Vec3::ZERO
        {
            found.push(Movable::Direction(Direction { path: field.path.clone(), value }));
        }
        found
    }

    fn solid(&self, node: &Node, around: &[&Node]) -> Option<Place> {
        let outer =
            around.iter().try_fold(DAffine3::IDENTITY, |outer, node| Some(outer * self.placed(node)?))?;
        let inward = outer.matrix3.inverse();
        let at = (outer * self.placed(node)?).transform_point3(self.middle(node)?.as_dvec3()).as_vec3();
        let is_placed = TRANSFORM.iter().any(|name| field(node, name).is_some_and(|f| f.span.is_some()));
        let points = match self.points(node).filter(|_| !is_placed) {
            Some(points) => points,
            None => {
                let field = field(node, "translate")?;
                vec![(field.path.clone(), self.vector(field)?)]
            }
        };
        (inward.is_finite() && at.is_finite()).then(|| Place::new(points, at, inward))
    }

    /// From the space of `node` into the one around.
    fn placed(&self, node: &Node) -> Option<DAffine3> {
        let [translate, rotate_deg, scale] = TRANSFORM.map(|name| match field(node, name) {
            Some(field) => self.vector(field),
            None => Some(if name == "scale" { Vec3::ONE } else { Vec3::ZERO }),
        });
        Some(placed(translate?.as_dvec3(), rotate_deg?, scale?))
    }

    /// In the space of `node`.
    fn middle(&self, node: &Node) -> Option<Vec3> {
        if let Some(points) = self.points(node) {
            return Some(mean(&points));
        }
        if let Some(object) = node.object {
            return Some((self.middle)(object).unwrap_or(Vec3::ZERO));
        }
        let operation = OPERATIONS.iter().find(|(group, _)| node.name.as_deref() == Some(group.name));
        let counts = match operation {
            // What is cut away says nothing of where the rest is.
            Some((_, CsgOperation::Difference)) => 1,
            _ => node.nodes.len(),
        };
        let middles = node.nodes.iter().take(counts).map(|part| {
            let middle = self.middle(part)?.as_dvec3();
            Some(self.placed(part)?.transform_point3(middle).as_vec3())
        });
        let middles = middles.collect::<Option<Vec<Vec3>>>()?;
        Some(middles.iter().sum::<Vec3>() / middles.len().max(1) as f32)
    }

    /// The points that `node` moves with; None where it has none, or where one is no vector.
    fn points(&self, node: &Node) -> Option<Vec<(Path, Vec3)>> {
        let points = node.fields.iter().filter(|field| field.is_point);
        let points = points.map(|field| Some((field.path.clone(), self.vector(field)?)));
        points.collect::<Option<Vec<_>>>().filter(|points| !points.is_empty())
    }

    /// What `field` says as three numbers.
    fn vector(&self, field: &Field) -> Option<Vec3> {
        let written = match &field.control {
            Control::Number { value, default, .. } => value.or(*default).map(|number| vec![number]),
            Control::Vector { value, default, .. } => value.clone().or_else(|| default.clone()),
            _ => return None,
        };
        match (self.numbers)(&field.path).or(written)?[..] {
            [x, y, z] => Some(Vec3::new(x, y, z)),
            [x] => Some(Vec3::splat(x)),
            _ => None,
        }
    }
}

impl Place {
    fn new(points: Vec<(Path, Vec3)>, at: Vec3, inward: DMat3) -> Self {
        let names =
            points.iter().filter_map(|(path, _)| path.to_string().rsplit('.').next().map(str::to_owned));
        Self { name: names.collect::<Vec<_>>().join(", "), at, points, inward }
    }

    /// How many digits behind the point a hand can mean, where a pixel is `pixel` wide, scene units.
    pub fn digits(&self, pixel: f32) -> i32 {
        let own = f64::from(pixel) * self.inward.determinant().abs().cbrt();
        (-own.log10().floor() as i32).clamp(*DIGITS.start(), *DIGITS.end())
    }

    /// The place once it has moved by about `by`, in the world: so that the numbers of its first point which
    /// change have `digits` behind the point. The others follow it.
    pub fn moved(&self, by: Vec3, digits: i32) -> Self {
        let step = self.inward * by.as_dvec3();
        let first = self.points[0].1.as_dvec3();
        let still = STILL * step.length();
        let part = |i: usize| match step[i].abs() > still {
            true => rounded(first[i] + step[i], digits) - first[i],
            false => 0.0,
        };
        let step = DVec3::new(part(0), part(1), part(2));
        let follow = |value: Vec3| {
            // What does not move stays to the last bit.
            let number = |i: usize| match step[i] == 0.0 {
                true => value[i],
                false => rounded(f64::from(value[i]) + step[i], digits + 3) as f32,
            };
            Vec3::new(number(0), number(1), number(2))
        };
        let points = self.points.iter().map(|(path, value)| (path.clone(), follow(*value))).collect();
        let at = self.at + (self.inward.inverse() * step).as_vec3();
        Self { points, at, ..self.clone() }
    }
}

impl Direction {
    /// The direction towards `unit`, which has length 1, as long as it was, with `digits` behind the point;
    /// None where that leaves nothing of it.
    pub fn turned(&self, unit: Vec3, digits: i32) -> Option<Self> {
        let value = self.value.length() * unit;
        let value = Vec3::from_array(value.to_array().map(|x| rounded(f64::from(x), digits) as f32));
        (value != Vec3::ZERO).then(|| Self { value, ..self.clone() })
    }

    /// How many digits behind the point a hand can mean.
    pub fn digits(&self) -> i32 {
        2 - f64::from(self.value.length()).log10().floor() as i32
    }
}

fn mean(points: &[(Path, Vec3)]) -> Vec3 {
    points.iter().map(|(_, value)| *value).sum::<Vec3>() / points.len() as f32
}

/// `x` with so many digits behind the point; in front of it, with so many zeros, where that is negative.
fn rounded(x: f64, digits: i32) -> f64 {
    let unit = 10_f64.powi(digits.abs());
    if digits < 0 { (x / unit).round() * unit } else { (x * unit).round() / unit }
}

fn field<'n>(node: &'n Node, label: &str) -> Option<&'n Field> {
    node.fields.iter().find(|field| field.label == label)
}

/// The node at `path`, and into `around` those that it lies in, the outermost first.
fn find<'n>(nodes: &'n [Node], path: &Path, around: &mut Vec<&'n Node>) -> Option<&'n Node> {
    for node in nodes {
        if node.path == *path {
            return Some(node);
        }
        around.push(node);
        if let Some(found) = find(&node.nodes, path, around) {
            return Some(found);
        }
        around.pop();
    }
    None
}
