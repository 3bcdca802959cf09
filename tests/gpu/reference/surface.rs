//! The outward normal and the uv of a point on a shape.

use super::hit::coordinates;
use super::shapes::Shape;
use super::solids;
use super::vector::Vec3;

/// The unit normal that points out of the shape at a point p of its surface.
pub fn outward_normal(shape: &Shape, p: [f64; 3]) -> [f64; 3] {
    let p = Vec3(p);
    let normal = match *shape {
        Shape::Sphere { center, .. } => p - center,
        Shape::Plane { normal, .. } | Shape::Disk { normal, .. } => normal,
        Shape::Box { min, max } => box_face(min, max, p),
        Shape::RoundedBox { min, max, radius } => {
            let core = (max - min) * 0.5 - Vec3::splat(radius);
            let q = p - (min + max) * 0.5;
            let outside = q - q.zip(core, |x, limit| x.clamp(-limit, limit));
            if radius > 0.0 { outside } else { box_face(min, max, p) }
        }
        Shape::Cylinder { base, top, radius } => frustum(base, top, radius, radius, p),
        Shape::Cone { base, top, base_radius, top_radius } => frustum(base, top, base_radius, top_radius, p),
        Shape::Capsule { base, top, .. } => {
            let axis = top - base;
            let share = (p - base).dot(axis) / axis.dot(axis);
            p - base - axis * share.clamp(0.0, 1.0)
        }
        Shape::Torus { center, axis, major_radius, .. } => {
            let q = p - center;
            q - (q - axis * q.dot(axis)).unit() * major_radius
        }
        Shape::Ellipsoid { center, radii } => (p - center) / (radii * radii),
        Shape::Triangle { a, b, c } => (b - a).cross(c - a),
        Shape::Quad { u, v, .. } => u.cross(v),
        Shape::RoundedCone { base, top, base_radius, top_radius } => {
            solids::rounded_cone_normal(base, top, base_radius, top_radius, p)
        }
        Shape::HexPrism { center, axis, radius, height } => {
            solids::polyhedron_normal(&solids::hex_prism(center, axis, radius, height), p)
        }
        Shape::RoundedCylinder { base, top, radius, rounding } => {
            solids::rounded_cylinder_normal(base, top, radius, rounding, p)
        }
        Shape::Wedge { min, max } => solids::polyhedron_normal(&solids::wedge(min, max), p),
        Shape::Pyramid { base, top, base_size, top_size } => {
            solids::polyhedron_normal(&solids::pyramid(base, top, base_size, top_size), p)
        }
        Shape::Paraboloid { base, top, radius } => {
            solids::turned_normal(base, top, solids::paraboloid(base, top, radius), p)
        }
        Shape::Hyperboloid { base, top, end_radius, waist_radius } => {
            solids::turned_normal(base, top, solids::hyperboloid(base, top, end_radius, waist_radius), p)
        }
        Shape::Superellipsoid { center, radii, exponents } => {
            solids::superellipsoid_normal(p - center, radii, exponents)
        }
    };
    normal.unit().0
}

/// The face whose plane p is nearest to, by its share of the half size.
fn box_face(min: Vec3, max: Vec3, p: Vec3) -> Vec3 {
    let (half, q) = ((max - min) * 0.5, p - (min + max) * 0.5);
    let depth = q.map(f64::abs) - half;
    let face = depth.largest();
    let axis = (0..3).find(|i| depth[*i] == face).unwrap_or(0);
    Vec3(std::array::from_fn(|i| if i == axis { q[i].signum() } else { 0.0 }))
}

/// The end disc or the side, whichever p is nearest to.
fn frustum(base: Vec3, top: Vec3, r0: f64, r1: f64, p: Vec3) -> Vec3 {
    let length = (top - base).length();
    let axis = (top - base) * (1.0 / length);
    let slope = (r1 - r0) / length;
    let h = (p - base).dot(axis);
    let q = p - base - axis * h;
    let side = (q.length() - r0 - slope * h).abs() / slope.hypot(1.0);
    if side <= h.abs() && side <= (length - h).abs() {
        q.unit() - axis * slope
    } else if h.abs() < (length - h).abs() {
        -axis
    } else {
        axis
    }
}

/// The uv that the scene language fixes, for a point and its outward normal; nothing elsewhere.
pub fn uv(shape: &Shape, p: Vec3, normal: Vec3) -> Option<[f64; 2]> {
    match *shape {
        Shape::Plane { .. } | Shape::Box { .. } => match normal.0.map(|x| x.abs() == 1.0) {
            [true, _, _] => Some([p[2], p[1]]),
            [_, true, _] => Some([p[0], p[2]]),
            [_, _, true] => Some([p[0], p[1]]),
            _ => None,
        },
        Shape::Quad { corner, u, v } => {
            let [a, b] = coordinates(p - corner, u, v);
            Some([a * u.length(), b * v.length()])
        }
        Shape::Sphere { center, radius } => {
            let q = p - center;
            let latitude = q[1].atan2(q[0].hypot(q[2]));
            Some([radius * q[2].atan2(q[0]), radius * latitude])
        }
        _ => None,
    }
}

/// Whether `uv` answers for every point of the shape.
pub fn has_uv(shape: &Shape) -> bool {
    match *shape {
        Shape::Plane { normal, .. } => uv(shape, Vec3::ZERO, normal.unit()).is_some(),
        Shape::Box { .. } | Shape::Quad { .. } | Shape::Sphere { .. } => true,
        _ => false,
    }
}
