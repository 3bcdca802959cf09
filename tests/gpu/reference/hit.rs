//! Where a ray crosses a shape: every candidate by its closed form, then the nearest one in range.

use super::roots;
use super::shapes::Shape;
use super::solids;
use super::vector::Vec3;

/// The nearest crossing with t in (t_min, t_max), from outside or inside; t counts in `direction`.
pub fn nearest_hit(
    shape: &Shape,
    origin: [f64; 3],
    direction: [f64; 3],
    t_min: f64,
    t_max: f64,
) -> Option<f64> {
    let (origin, direction) = (Vec3(origin), Vec3(direction));
    // The ray's origin moves to its point nearest to the shape, so that distance costs no digits.
    let shift = (shape.center() - origin).dot(direction) / direction.dot(direction);
    crossings(shape, origin + direction * shift, direction)
        .into_iter()
        .map(|t| t + shift)
        .filter(|t| *t > t_min && *t < t_max)
        .min_by(f64::total_cmp)
}

/// All crossings of the whole line o + t·d, in no order; some may be NaN or infinite.
fn crossings(shape: &Shape, o: Vec3, d: Vec3) -> Vec<f64> {
    match *shape {
        Shape::Sphere { center, radius } => sphere(o - center, d, radius),
        Shape::Plane { normal, offset } => vec![(offset - normal.dot(o)) / normal.dot(d)],
        Shape::Box { min, max } => slabs(min, max, o, d),
        Shape::RoundedBox { min, max, radius } => rounded_box(min, max, radius, o, d),
        Shape::Cylinder { base, top, radius } => frustum(base, top, radius, radius, o, d),
        Shape::Cone { base, top, base_radius, top_radius } => {
            frustum(base, top, base_radius, top_radius, o, d)
        }
        Shape::Capsule { base, top, radius } => capsule(base, top, radius, o, d),
        Shape::Torus { center, axis, major_radius, minor_radius } => {
            torus(o - center, d, axis, major_radius, minor_radius)
        }
        Shape::Ellipsoid { center, radii } => sphere((o - center) / radii, d / radii, 1.0),
        Shape::Disk { center, normal, radius, inner_radius } => {
            let t = normal.dot(center - o) / normal.dot(d);
            let distance = (o + d * t - center).length();
            if (inner_radius..=radius).contains(&distance) { vec![t] } else { Vec::new() }
        }
        Shape::Triangle { a, b, c } => {
            parallelogram(a, b - a, c - a, o, d, |u, v| u >= 0.0 && v >= 0.0 && u + v <= 1.0)
        }
        Shape::Quad { corner, u, v } => {
            parallelogram(corner, u, v, o, d, |u, v| (0.0..=1.0).contains(&u) && (0.0..=1.0).contains(&v))
        }
        Shape::RoundedCone { base, top, base_radius, top_radius } => {
            solids::rounded_cone(base, top, base_radius, top_radius, o, d)
        }
        Shape::HexPrism { center, axis, radius, height } => {
            solids::polyhedron(&solids::hex_prism(center, axis, radius, height), o, d)
        }
        Shape::RoundedCylinder { base, top, radius, rounding } => {
            solids::rounded_cylinder(base, top, radius, rounding, o, d)
        }
        Shape::Wedge { min, max } => solids::polyhedron(&solids::wedge(min, max), o, d),
        Shape::Pyramid { base, top, base_size, top_size } => {
            solids::polyhedron(&solids::pyramid(base, top, base_size, top_size), o, d)
        }
        Shape::Paraboloid { base, top, radius } => {
            solids::turned(base, top, solids::paraboloid(base, top, radius), o, d)
        }
        Shape::Hyperboloid { base, top, end_radius, waist_radius } => {
            solids::turned(base, top, solids::hyperboloid(base, top, end_radius, waist_radius), o, d)
        }
        Shape::Superellipsoid { center, radii, exponents } => {
            solids::superellipsoid(o - center, d, radii, exponents)
        }
    }
}

/// |o + t·d|² = r².
pub fn sphere(o: Vec3, d: Vec3, radius: f64) -> Vec<f64> {
    roots::quadratic(d.dot(d), o.dot(d), o.dot(o) - radius * radius)
}

/// Where the line enters the last of three slabs and leaves the first.
pub fn slabs(min: Vec3, max: Vec3, o: Vec3, d: Vec3) -> Vec<f64> {
    let (low, high) = ((min - o) / d, (max - o) / d);
    let near = low.zip(high, f64::min).largest();
    let far = -(-low.zip(high, f64::max)).largest();
    if near <= far { vec![near, far] } else { Vec::new() }
}

/// Within min and max, with edges and corners rounded: the signed distance to a convex solid is
/// convex along a line.
fn rounded_box(min: Vec3, max: Vec3, radius: f64, o: Vec3, d: Vec3) -> Vec<f64> {
    let (center, core) = ((min + max) * 0.5, (max - min) * 0.5 - Vec3::splat(radius));
    let distance = |t: f64| {
        let q = (o + d * t - center).map(f64::abs) - core;
        q.map(|x| x.max(0.0)).length() + q.largest().min(0.0) - radius
    };
    match slabs(min, max, o, d)[..] {
        [near, far] => {
            let margin = 1e-6 * (1.0 + far - near);
            roots::convex(distance, near - margin, far + margin)
        }
        _ => Vec::new(),
    }
}

/// A side whose radius goes linearly from base to top, |q| = r(h), closed by two discs.
fn frustum(base: Vec3, top: Vec3, r0: f64, r1: f64, o: Vec3, d: Vec3) -> Vec<f64> {
    let length = (top - base).length();
    let axis = (top - base) * (1.0 / length);
    let slope = (r1 - r0) / length;
    let (h, k) = ((o - base).dot(axis), d.dot(axis));
    let (q, e) = (o - base - axis * h, d - axis * k);
    let radius = r0 + slope * h;
    let mut hits = roots::quadratic(
        e.dot(e) - slope * k * slope * k,
        q.dot(e) - radius * slope * k,
        q.dot(q) - radius * radius,
    );
    hits.retain(|t| (0.0..=length).contains(&(h + k * t)));
    for (height, radius) in [(0.0, r0), (length, r1)] {
        let t = (height - h) / k;
        if (q + e * t).length() <= radius {
            hits.push(t);
        }
    }
    hits
}

/// The points at one distance from a segment: a side between its ends, a ball beyond each.
pub fn capsule(base: Vec3, top: Vec3, radius: f64, o: Vec3, d: Vec3) -> Vec<f64> {
    let length = (top - base).length();
    let axis = (top - base) * (1.0 / length);
    let (h, k) = ((o - base).dot(axis), d.dot(axis));
    let (q, e) = (o - base - axis * h, d - axis * k);
    let mut hits = roots::quadratic(e.dot(e), q.dot(e), q.dot(q) - radius * radius);
    hits.retain(|t| (0.0..=length).contains(&(h + k * t)));
    hits.extend(sphere(o - base, d, radius).into_iter().filter(|t| h + k * t < 0.0));
    hits.extend(sphere(o - top, d, radius).into_iter().filter(|t| h + k * t > length));
    hits
}

/// (|p|² + R² − r²)² = 4·R²·(|p|² − (p·axis)²) along p = o + s·d/|d|, within the ball that holds it.
pub fn torus(o: Vec3, d: Vec3, axis: Vec3, major: f64, minor: f64) -> Vec<f64> {
    let speed = d.length();
    let d = d * (1.0 / speed);
    let (b, c) = (o.dot(d), o.dot(o));
    let (h, g) = (o.dot(axis), d.dot(axis));
    let reach = (b * b - c + (major + minor).powi(2)).sqrt() * (1.0 + 1e-9);
    if reach.is_nan() {
        return Vec::new();
    }
    let (k, four) = (c + major * major - minor * minor, 4.0 * major * major);
    let quartic = [
        k * k - four * (c - h * h),
        4.0 * b * k - 2.0 * four * (b - h * g),
        4.0 * b * b + 2.0 * k - four * (1.0 - g * g),
        4.0 * b,
        1.0,
    ];
    let hits = roots::polynomial(&quartic, -b - reach, -b + reach);
    hits.into_iter().map(|s| s / speed).collect()
}

/// Cramer's rule for corner + a·u + b·v = o + t·d, kept where `inside` takes (a, b).
fn parallelogram(
    corner: Vec3,
    u: Vec3,
    v: Vec3,
    o: Vec3,
    d: Vec3,
    inside: impl Fn(f64, f64) -> bool,
) -> Vec<f64> {
    let normal = u.cross(v);
    let t = normal.dot(corner - o) / normal.dot(d);
    let [a, b] = coordinates(o + d * t - corner, u, v);
    if inside(a, b) { vec![t] } else { Vec::new() }
}

/// (a, b) with q = a·u + b·v, for a point q of the plane of u and v.
pub fn coordinates(q: Vec3, u: Vec3, v: Vec3) -> [f64; 2] {
    let normal = u.cross(v);
    let area = normal.dot(normal);
    [q.cross(v).dot(normal) / area, u.cross(q).dot(normal) / area]
}
