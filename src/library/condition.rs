//! Conditions that the numbers of a shape keep to among each other, so that it has a size.
//!
//! In: a relation between parameters. Out: whether given numbers keep to it.

use glam::Vec3;

use super::Const;

/// Without it the shape would have no size.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Condition {
    pub relation: Relation,
    /// Indices of the parameters, in the order of the line.
    pub parameters: Vec<usize>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// Two points are apart.
    Apart,
    /// Two corners are apart along two axes at least.
    ApartAlongTwoAxes,
    /// Two directions are no multiples of each other.
    Slanted,
    /// Three points span a triangle.
    OffLine,
    /// The first number is less than the second.
    Less,
}

/// Coordinates nearer than this share of their size are the same to numbers of 32 bits.
const SAME: f32 = 2.4e-7;
/// And so are those nearer than this.
const LEAST_APART: f32 = 1e-9;
/// The sine of the least angle that directions have.
const LEAST_SINE: f32 = 1e-6;

impl Condition {
    /// Whether it holds for the arguments of a shape; None stands for a texture, of which it is not asked.
    pub fn holds(&self, arguments: &[Option<Const>]) -> bool {
        let given: Option<Vec<Const>> =
            self.parameters.iter().map(|index| arguments.get(*index).copied()?).collect();
        match given.as_deref() {
            Some([Const::Vec3(a), Const::Vec3(b)]) => match self.relation {
                Relation::ApartAlongTwoAxes => axes_apart(*a, *b) > 1,
                Relation::Slanted => are_slanted(*a, *b),
                _ => axes_apart(*a, *b) > 0,
            },
            Some([Const::Vec3(a), Const::Vec3(b), Const::Vec3(c)]) => are_slanted(*b - *a, *c - *a),
            Some([Const::F32(a), Const::F32(b)]) => a < b,
            _ => true,
        }
    }

    /// Whether it holds and leaves the shape flat all the same, so that it encloses nothing.
    pub fn leaves_flat(&self, arguments: &[Option<Const>]) -> bool {
        let given = |index: usize| arguments.get(self.parameters[index]).copied().flatten();
        match (self.relation, given(0), given(1)) {
            (Relation::ApartAlongTwoAxes, Some(Const::Vec3(a)), Some(Const::Vec3(b))) => {
                axes_apart(a, b) == 2
            }
            _ => false,
        }
    }
}

/// Along how many axes two points are apart.
fn axes_apart(a: Vec3, b: Vec3) -> usize {
    let is_apart = |axis: &usize| {
        let (a, b) = (a[*axis], b[*axis]);
        (a - b).abs() > (SAME * a.abs().max(b.abs())).max(LEAST_APART)
    };
    (0..3).filter(is_apart).count()
}

fn are_slanted(a: Vec3, b: Vec3) -> bool {
    let (a, b) = (a.as_dvec3(), b.as_dvec3());
    let longest = a.length_squared().max(b.length_squared());
    let least = f64::from(LEAST_APART);
    longest > least * least && a.cross(b).length() > f64::from(LEAST_SINE) * longest
}
