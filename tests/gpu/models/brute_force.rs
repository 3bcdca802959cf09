//! All triangles of a model in f64, each asked about each ray.

use glam::DVec3;
use raytoy::assets::Model;

/// Triangles without any order.
pub struct Soup {
    pub triangles: Vec<[DVec3; 3]>,
    pub middle: DVec3,
    /// Of the ball around `middle` that holds all corners.
    pub radius: f64,
}

/// Where a ray crosses a triangle.
#[derive(Clone, Copy, Debug)]
pub struct Met {
    pub t: f64,
    pub triangle: usize,
    /// Outward, length 1.
    pub normal: DVec3,
}

impl Soup {
    pub fn of(model: &Model) -> Self {
        let corner = |c: &raytoy::assets::Corner| c.position.as_dvec3();
        let triangles: Vec<_> = model.triangles.iter().map(|t| [0, 1, 2].map(|i| corner(&t[i]))).collect();
        let corners = || triangles.iter().flatten().copied();
        let low = corners().reduce(DVec3::min).expect("a model has triangles");
        let high = corners().reduce(DVec3::max).expect("a model has triangles");
        let middle = 0.5 * (low + high);
        let radius = corners().map(|p| p.distance(middle)).fold(0.0, f64::max);
        Self { triangles, middle, radius }
    }

    pub fn normal(&self, triangle: usize) -> DVec3 {
        let [a, b, c] = self.triangles[triangle];
        (b - a).cross(c - a).normalize()
    }

    /// The first crossing beyond `t_min`.
    pub fn first(&self, origin: DVec3, direction: DVec3, t_min: f64) -> Option<Met> {
        let mut nearest: Option<(f64, usize)> = None;
        for (i, triangle) in self.triangles.iter().enumerate() {
            if let Some(t) = crossing(triangle, origin, direction)
                && t > t_min
                && nearest.is_none_or(|(least, _)| t < least)
            {
                nearest = Some((t, i));
            }
        }
        nearest.map(|(t, triangle)| Met { t, triangle, normal: self.normal(triangle) })
    }

    /// All crossings beyond 0, in order.
    pub fn all(&self, origin: DVec3, direction: DVec3) -> Vec<f64> {
        let found = self.triangles.iter().filter_map(|triangle| crossing(triangle, origin, direction));
        let mut found: Vec<f64> = found.filter(|t| *t > 0.0).collect();
        found.sort_by(f64::total_cmp);
        found
    }

    /// Whether the triangles go once around `p`, by the solid angles that they fill (Van Oosterom and
    /// Strackee, The Solid Angle of a Plane Triangle, 1983).
    pub fn holds(&self, p: DVec3) -> bool {
        let angle = |triangle: &[DVec3; 3]| {
            let [a, b, c] = triangle.map(|corner| corner - p);
            let [x, y, z] = [a.length(), b.length(), c.length()];
            let below = x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y;
            a.dot(b.cross(c)).atan2(below)
        };
        self.triangles.iter().map(angle).sum::<f64>() > std::f64::consts::PI
    }

    /// From `p` to the nearest triangle.
    pub fn distance(&self, p: DVec3) -> f64 {
        self.triangles.iter().map(|triangle| distance(triangle, p)).fold(f64::INFINITY, f64::min)
    }
}

/// By the volumes that the ray spans with the edges, so that triangles with a common edge agree about it.
fn crossing(triangle: &[DVec3; 3], origin: DVec3, direction: DVec3) -> Option<f64> {
    let [a, b, c] = triangle.map(|corner| corner - origin);
    let u = direction.dot(b.cross(c));
    let v = direction.dot(c.cross(a));
    let w = direction.dot(a.cross(b));
    let total = u + v + w;
    let is_inside = (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
    (is_inside && total != 0.0).then(|| {
        let point = (u * a + v * b + w * c) / total;
        point.dot(direction) / direction.length_squared()
    })
}

/// From `p` to a triangle.
pub fn distance(triangle: &[DVec3; 3], p: DVec3) -> f64 {
    let [a, b, c] = *triangle;
    let across = (b - a).cross(c - a);
    let edges = [(a, b), (b, c), (c, a)];
    if edges.iter().all(|(from, to)| (*to - *from).cross(p - *from).dot(across) >= 0.0) {
        return (p - a).dot(across).abs() / across.length();
    }
    let to_edge = |(from, to): (DVec3, DVec3)| {
        let share = (p - from).dot(to - from) / (to - from).length_squared();
        p.distance(from + share.clamp(0.0, 1.0) * (to - from))
    };
    edges.map(to_edge).into_iter().fold(f64::INFINITY, f64::min)
}
