//! An object's place: scale, then rotate about x, then y, then z, then translate.

use super::vector::Vec3;

#[derive(Clone, Debug)]
pub struct Transform {
    scale: Vec3,
    /// Where the rotation takes x, y and z.
    axes: [Vec3; 3],
    translate: Vec3,
}

impl Transform {
    pub fn new(scale: Vec3, rotate_deg: Vec3, translate: Vec3) -> Transform {
        let axis = |i: usize| Vec3(std::array::from_fn(|j| if i == j { 1.0 } else { 0.0 }));
        let axes = std::array::from_fn(|i| rotate(axis(i), rotate_deg));
        Transform { scale, axes, translate }
    }

    pub fn point_to_object(&self, p: Vec3) -> Vec3 {
        self.direction_to_object(p - self.translate)
    }

    /// Keeps the stretch of the direction, so that t stays the same.
    pub fn direction_to_object(&self, d: Vec3) -> Vec3 {
        Vec3(self.axes.map(|axis| axis.dot(d))) / self.scale
    }

    /// By the inverse transpose.
    pub fn normal_to_world(&self, n: Vec3) -> Vec3 {
        let n = n / self.scale;
        (self.axes[0] * n[0] + self.axes[1] * n[1] + self.axes[2] * n[2]).unit()
    }
}

/// Right-handed turns about x, then y, then z.
fn rotate(v: Vec3, degrees: Vec3) -> Vec3 {
    (0..3).fold(v, |v, axis| {
        let (sin, cos) = degrees[axis].to_radians().sin_cos();
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut turned = v.0;
        turned[j] = cos * v[j] - sin * v[k];
        turned[k] = sin * v[j] + cos * v[k];
        Vec3(turned)
    })
}
