//! Polyhedra, rounded solids and solids of revolution: where a line crosses them, and how they face.

use super::hit::{capsule, slabs, sphere, torus};
use super::roots;
use super::vector::Vec3;

/// A plane with the solid behind it: the points p with normal·p = offset. The normal has length 1.
type Face = (Vec3, f64);

/// Rounding must not lose a crossing near an edge, where two faces could each leave it to the other.
const EDGE: f64 = 1e-12;

fn face(outward: Vec3, point: Vec3) -> Face {
    let normal = outward.unit();
    (normal, normal.dot(point))
}

/// Two directions across an axis: x as nearly as may be, or z where the axis is nearest to x; then the other.
fn tangents(axis: Vec3) -> [Vec3; 2] {
    let size = axis.map(f64::abs);
    let along_x = size[0] > size[1] && size[0] > size[2];
    let first = if along_x { Vec3::new(0.0, 0.0, 1.0) } else { Vec3::new(1.0, 0.0, 0.0) };
    let u = (first - axis * first.dot(axis)).unit();
    [u, axis.cross(u)]
}

/// Corners at every 60 degrees, the first along the first tangent.
pub fn hex_prism(center: Vec3, axis: Vec3, radius: f64, height: f64) -> Vec<Face> {
    let [u, v] = tangents(axis);
    let corner = |k: usize| {
        let (sin, cos) = (60.0 * k as f64).to_radians().sin_cos();
        (u * cos + v * sin) * radius
    };
    let side = |k: usize| {
        let middle = (corner(k) + corner(k + 1)) * 0.5;
        face(middle, center + middle)
    };
    let end = axis * (0.5 * height);
    (0..6).map(side).chain([face(end, center + end), face(-end, center - end)]).collect()
}

/// The lower half of a box: its ramp goes from the least x and y to the greatest.
pub fn wedge(min: Vec3, max: Vec3) -> Vec<Face> {
    let size = max - min;
    let ramp = Vec3::new(-size[1], size[0], 0.0);
    let [x, y, z] = [Vec3::new(1.0, 0.0, 0.0), Vec3::Y, Vec3::new(0.0, 0.0, 1.0)];
    vec![face(x, max), face(-y, min), face(z, max), face(-z, min), face(ramp, min)]
}

pub fn pyramid(base: Vec3, top: Vec3, base_size: f64, top_size: f64) -> Vec<Face> {
    let axis = (top - base).unit();
    let [u, v] = tangents(axis);
    let side = |out: Vec3| {
        let low = base + out * (0.5 * base_size);
        let up = top + out * (0.5 * top_size) - low;
        face(out * up.dot(axis) - axis * up.dot(out), low)
    };
    [u, -u, v, -v].into_iter().map(side).chain([face(axis, top), face(-axis, base)]).collect()
}

/// Where the line meets the plane of a face behind all the others.
pub fn polyhedron(faces: &[Face], o: Vec3, d: Vec3) -> Vec<f64> {
    let crossings = faces.iter().map(|(normal, offset)| (offset - normal.dot(o)) / normal.dot(d));
    let is_inside = |p: Vec3| faces.iter().all(|(normal, offset)| normal.dot(p) <= offset + EDGE);
    crossings.filter(|t| is_inside(o + d * *t)).collect()
}

/// The normal of the face that p lies on.
pub fn polyhedron_normal(faces: &[Face], p: Vec3) -> Vec3 {
    let height = |face: &Face| face.0.dot(p) - face.1;
    let outermost = faces.iter().max_by(|a, b| height(a).total_cmp(&height(b)));
    outermost.map_or(Vec3::ZERO, |face| face.0)
}

/// A line beside an axis: its height above the base and its way from the axis, each with its change per t.
struct Beside {
    axis: Vec3,
    length: f64,
    h: f64,
    k: f64,
    q: Vec3,
    e: Vec3,
}

impl Beside {
    fn new(base: Vec3, top: Vec3, o: Vec3, d: Vec3) -> Beside {
        let length = (top - base).length();
        let axis = (top - base) * (1.0 / length);
        let (h, k) = ((o - base).dot(axis), d.dot(axis));
        Beside { axis, length, h, k, q: o - base - axis * h, e: d - axis * k }
    }

    fn height(&self, t: f64) -> f64 {
        self.h + self.k * t
    }

    fn axis_distance(&self, t: f64) -> f64 {
        (self.q + self.e * t).length()
    }
}

/// The sine of the angle between the side and the axis, and the heights of the circles where the side
/// touches the balls. Where one ball holds the other, no height lies between them.
fn tangent_circles(length: f64, r0: f64, r1: f64) -> (f64, [f64; 2]) {
    let sine = ((r0 - r1) / length).clamp(-1.0, 1.0);
    (sine, [r0 * sine, length + r1 * sine])
}

/// Two balls and the cone that touches both: cos·|q| + sin·h = r0.
pub fn rounded_cone(base: Vec3, top: Vec3, r0: f64, r1: f64, o: Vec3, d: Vec3) -> Vec<f64> {
    let line = Beside::new(base, top, o, d);
    let (sine, [low, high]) = tangent_circles(line.length, r0, r1);
    let cosine2 = 1.0 - sine * sine;
    let (reach, growth) = (r0 - sine * line.h, -sine * line.k);
    let mut hits = roots::quadratic(
        cosine2 * line.e.dot(line.e) - growth * growth,
        cosine2 * line.q.dot(line.e) - reach * growth,
        cosine2 * line.q.dot(line.q) - reach * reach,
    );
    hits.retain(|t| (low..=high).contains(&line.height(*t)));
    hits.extend(sphere(o - base, d, r0).into_iter().filter(|t| line.height(*t) < low));
    hits.extend(sphere(o - top, d, r1).into_iter().filter(|t| line.height(*t) > high));
    hits
}

pub fn rounded_cone_normal(base: Vec3, top: Vec3, r0: f64, r1: f64, p: Vec3) -> Vec3 {
    let at = Beside::new(base, top, p, Vec3::ZERO);
    match tangent_circles(at.length, r0, r1) {
        (sine, [low, _]) if at.h <= low && sine > -1.0 => p - base,
        (sine, [_, high]) if at.h >= high && sine < 1.0 => p - top,
        (sine, _) => at.q.unit() * (1.0 - sine * sine).sqrt() + at.axis * sine,
    }
}

/// A side and two discs, and a quarter of a torus at either rim.
pub fn rounded_cylinder(base: Vec3, top: Vec3, radius: f64, rounding: f64, o: Vec3, d: Vec3) -> Vec<f64> {
    let line = Beside::new(base, top, o, d);
    let bevel = rounding.min(radius).min(0.5 * line.length);
    let (ring, inset) = (radius - bevel, line.axis * bevel);
    if ring == 0.0 {
        return capsule(base + inset, top - inset, radius, o, d);
    }
    let (low, high) = (bevel, line.length - bevel);
    let side = line.q.dot(line.q) - radius * radius;
    let mut hits = roots::quadratic(line.e.dot(line.e), line.q.dot(line.e), side);
    hits.retain(|t| (low..=high).contains(&line.height(*t)));
    let discs = [0.0, line.length].map(|height| (height - line.h) / line.k);
    hits.extend(discs.into_iter().filter(|t| line.axis_distance(*t) <= ring));
    for (center, edge, way) in [(base + inset, low, -1.0), (top - inset, high, 1.0)] {
        let rim = torus(o - center, d, line.axis, ring, bevel);
        let is_outer = |t: &f64| (line.height(*t) - edge) * way > 0.0 && line.axis_distance(*t) > ring;
        hits.extend(rim.into_iter().filter(is_outer));
    }
    hits
}

/// Away from the nearest point of the cylinder without its rounding.
pub fn rounded_cylinder_normal(base: Vec3, top: Vec3, radius: f64, rounding: f64, p: Vec3) -> Vec3 {
    let at = Beside::new(base, top, p, Vec3::ZERO);
    let bevel = rounding.min(radius).min(0.5 * at.length);
    let axis_distance = at.q.length();
    let (out, up) = (axis_distance - radius, (at.h - at.length).max(-at.h));
    let along = if at.h > 0.5 * at.length { at.axis } else { -at.axis };
    if bevel == 0.0 {
        return if out > up { at.q } else { along };
    }
    at.q * ((out + bevel).max(0.0) / axis_distance.max(1e-300)) + along * (up + bevel).max(0.0)
}

/// A solid of revolution: the square of the radius at height h is s0 + s1·h + s2·h².
pub type Profile = [f64; 3];

pub fn paraboloid(base: Vec3, top: Vec3, radius: f64) -> Profile {
    [radius * radius, -radius * radius / (top - base).length(), 0.0]
}

pub fn hyperboloid(base: Vec3, top: Vec3, end_radius: f64, waist_radius: f64) -> Profile {
    let length = (top - base).length();
    let opening = (end_radius.powi(2) - waist_radius.powi(2)) / (0.5 * length).powi(2);
    [end_radius.powi(2), -opening * length, opening]
}

/// |q|² = s(h) between base and top, closed by two discs.
pub fn turned(base: Vec3, top: Vec3, [s0, s1, s2]: Profile, o: Vec3, d: Vec3) -> Vec<f64> {
    let line = Beside::new(base, top, o, d);
    let square = |h: f64| s0 + (s1 + s2 * h) * h;
    let mut hits = roots::quadratic(
        line.e.dot(line.e) - s2 * line.k * line.k,
        line.q.dot(line.e) - (0.5 * s1 + s2 * line.h) * line.k,
        line.q.dot(line.q) - square(line.h),
    );
    hits.retain(|t| (0.0..=line.length).contains(&line.height(*t)));
    for height in [0.0, line.length] {
        let t = (height - line.h) / line.k;
        if line.axis_distance(t).powi(2) <= square(height) {
            hits.push(t);
        }
    }
    hits
}

/// The end disc or the side, whichever p is nearest to.
pub fn turned_normal(base: Vec3, top: Vec3, [s0, s1, s2]: Profile, p: Vec3) -> Vec3 {
    let at = Beside::new(base, top, p, Vec3::ZERO);
    let slope = at.q * 2.0 - at.axis * (s1 + 2.0 * s2 * at.h);
    let side = (at.q.dot(at.q) - s0 - (s1 + s2 * at.h) * at.h).abs() / slope.length();
    // A disc without size is no face: the top of a paraboloid.
    let reach = |height: f64, off: f64| if s0 + (s1 + s2 * height) * height > 1e-12 { off } else { f64::MAX };
    match [reach(0.0, at.h.abs()), reach(at.length, (at.length - at.h).abs())] {
        [low, high] if side <= low && side <= high => slope,
        [low, high] if low < high => -at.axis,
        _ => at.axis,
    }
}

/// ((|x|^(2/e) + |z|^(2/e))^(e/n) + |y|^(2/n))^(n/2) = 1 in units of the radii. With exponents up to 2
/// the left side is a norm, and so convex along a line.
pub fn superellipsoid(o: Vec3, d: Vec3, radii: Vec3, [e, n]: [f64; 2]) -> Vec<f64> {
    let norm = |t: f64| {
        let q = ((o + d * t) / radii).map(f64::abs);
        let level = q[0].powf(2.0 / e) + q[2].powf(2.0 / e);
        (level.powf(e / n) + q[1].powf(2.0 / n)).powf(0.5 * n) - 1.0
    };
    match slabs(-radii, radii, o, d)[..] {
        [near, far] => {
            let margin = 1e-6 * (1.0 + far - near);
            roots::convex(norm, near - margin, far + margin)
        }
        _ => Vec::new(),
    }
}

/// The gradient of the same, a factor aside.
pub fn superellipsoid_normal(p: Vec3, radii: Vec3, [e, n]: [f64; 2]) -> Vec3 {
    let q = (p / radii).map(f64::abs);
    let level = (q[0].powf(2.0 / e) + q[2].powf(2.0 / e)).max(f64::MIN_POSITIVE).powf(e / n - 1.0);
    let [x, z] = [q[0], q[2]].map(|x| level * x.powf(2.0 / e - 1.0));
    let slope = Vec3::new(x, q[1].powf(2.0 / n - 1.0), z);
    slope.zip(p, f64::copysign) / radii
}
