//! One ray's crossing beside the reference's, and whether it can be judged at all.

use std::f64::consts::PI;

use glam::DVec3;
use raytoy::gpu::{Crossing, Ray};

use super::{Subject, Tally};
use crate::reference::{Shape, outward_normal};

impl Subject {
    pub fn judge(&self, tally: &mut Tally, ray: &Ray, found: Option<&Crossing>) {
        let (origin, direction) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
        let expected = self.meets(origin, direction, 0.0);
        tally.rays += 1;
        if !self.is_clear(origin, direction, expected) {
            tally.excluded += 1;
            return;
        }
        let told = || format!("{ray:?} expected {expected:?} found {found:?}");
        match (expected, found) {
            (None, None) => {}
            (None, Some(_)) => {
                tally.false_hits += 1;
                tally.note(1e9, told);
            }
            (Some(_), None) => {
                tally.misses += 1;
                tally.note(1e9, told);
            }
            (Some((t, normal)), Some(hit)) => {
                let along = (f64::from(hit.t) - t).abs() * direction.length();
                let slant = direction.normalize().dot(normal).abs();
                let scale = (t * direction.length()).max(self.radius);
                let actual = hit.normal.as_dvec3();
                // What is no number is as wrong as can be.
                let off = |normal: DVec3| actual.cross(normal).length().atan2(actual.dot(normal)).min(PI);
                let own = outward_normal(&self.shape, hit.position.as_dvec3().to_array());
                let turn = off(normal);
                tally.own_normal.push(off(DVec3::from_array(own)) as f32);
                tally.surface.push((along * slant / scale) as f32);
                tally.along.push((along / scale) as f32);
                tally.normal.push(turn as f32);
                tally.note((along * slant / scale).max(1e-2 * turn), told);
            }
        }
    }

    /// Whether all rays that pass within 1e-4 of the radius and 2e-6 of the distance meet the same face.
    fn is_clear(&self, origin: DVec3, direction: DVec3, expected: Option<(f64, DVec3)>) -> bool {
        let unit = direction.normalize();
        let away = match expected {
            Some((t, _)) => t * direction.length(),
            None => (self.middle - origin).dot(unit),
        };
        let away = away.max(0.1 * self.radius);
        let near = 1e-4 * self.radius + 2e-6 * away;
        let is_plane = matches!(self.shape, Shape::Plane { .. });
        if is_plane || matches!(self.shape, Shape::Disk { .. } | Shape::Triangle { .. } | Shape::Quad { .. })
        {
            // Seen edge on, it is all silhouette; and between the rays around it a sharp corner may be missed.
            let normal = DVec3::from_array(outward_normal(&self.shape, self.middle.to_array()));
            let passes = |p: &DVec3| (*p - origin).reject_from_normalized(unit).length() < near;
            let mut corners = self.places.iter().filter(|p| p.distance(self.middle) > 0.3 * self.radius);
            if unit.dot(normal).abs() * self.radius < near || corners.any(passes) {
                return false;
            }
        }
        let pass = origin + unit * (self.middle - origin).dot(unit).max(0.0);
        if expected.is_none() && !is_plane && pass.distance(self.middle) > 1.001 * self.radius + 2.0 * near {
            return true;
        }
        if is_plane || origin.distance(self.middle) < 1.01 * self.radius {
            // A ray that starts on the surface may or may not meet it there.
            let start = 2e-6 * self.radius / direction.length();
            let t = expected.map(|(t, _)| t);
            let same = |t_min: f64| match (t, self.meets(origin, direction, t_min).map(|(t, _)| t)) {
                (Some(a), Some(b)) => (a - b).abs() * direction.length() < 1e-9 * (away + self.radius),
                (a, b) => a.is_none() && b.is_none(),
            };
            if !same(-start) || !same(start) {
                return false;
            }
        }
        let u = unit.any_orthonormal_vector();
        let v = unit.cross(u);
        (0..8).all(|i| {
            let (sin, cos) = (f64::from(i) * std::f64::consts::FRAC_PI_4).sin_cos();
            let beside = unit * away + near * (cos * u + sin * v);
            match (expected, self.meets(origin, beside, 0.0)) {
                (None, None) => true,
                (Some((t, normal)), Some((s, other))) => {
                    let step = (s * beside - t * direction).dot(normal).abs();
                    // cos 20°: another face, or the same one seen edge on.
                    step < 2.0 * near && other.dot(normal) > 0.94
                }
                _ => false,
            }
        })
    }
}
