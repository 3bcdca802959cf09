//! Whether what a ray meets lies in the light, and whether rays close by say the same.

use super::scene::Scene;
use super::shade::{Ray, facing_normal};
use super::vector::Vec3;

/// Nothing that is as near as this to a surface casts a shadow on it, for each unit of `size`.
const LEAST_LIFT: f64 = 1e-9;

impl Scene {
    /// Whether the first light reaches what pixel (i, j) shows; nothing where its ray leaves the scene.
    pub fn is_lit(&self, [i, j]: [usize; 2], [width, height]: [usize; 2]) -> Option<bool> {
        let (origin, direction) = self.camera.ray(i, j, width, height);
        self.lights_up(Ray { origin, direction }, LEAST_LIFT)
    }

    /// Whether that holds for rays that pass within `near`, and for points lifted up to `near` off the
    /// surface; for each unit of `size`.
    pub fn is_clear(&self, [i, j]: [usize; 2], [width, height]: [usize; 2], near: f64) -> bool {
        let (origin, direction) = self.camera.ray(i, j, width, height);
        let ray = Ray { origin, direction };
        let expected = self.lights_up(ray, LEAST_LIFT);
        let met = self.nearest(ray).map(|hit| (hit.t, size(origin + direction * hit.t, hit.t)));
        let (t, size) = met.unwrap_or((1.0, 1.0));
        let beside = if direction[1].abs() < 0.9 { Vec3::Y } else { Vec3::new(1.0, 0.0, 0.0) };
        let aside = direction.cross(beside).unit();
        let above = direction.cross(aside);
        let turn = near * size / t;
        let rays = (0..16).map(|k| {
            let (sin, cos) = (f64::from(k) * std::f64::consts::FRAC_PI_8).sin_cos();
            // Eight at `near`, and eight at half of it.
            let turn = turn * if k % 2 == 0 { 1.0 } else { 0.5 };
            Ray { origin, direction: (direction + (aside * cos + above * sin) * turn).unit() }
        });
        [ray].into_iter().chain(rays).all(|ray| {
            [LEAST_LIFT, 0.5 * near, near].into_iter().all(|lift| self.lights_up(ray, lift) == expected)
        })
    }

    fn lights_up(&self, ray: Ray, lift: f64) -> Option<bool> {
        let hit = self.nearest(ray)?;
        let point = ray.origin + ray.direction * hit.t;
        let normal = facing_normal(ray, &hit);
        let light = self.lights[0].arriving(point);
        let start = point + normal * (lift * size(point, hit.t));
        let (way, end) = match light.endless {
            true => (light.to, f64::INFINITY),
            false => (light.to + point - start, 1.0),
        };
        let blocks = || self.objects.iter().any(|o| o.casts_shadow && o.hit(start, way, end).is_some());
        Some(normal.dot(light.to) > 0.0 && !blocks())
    }
}

/// The largest of a point's coordinates and its distance.
fn size(point: Vec3, t: f64) -> f64 {
    point.map(f64::abs).largest().max(t)
}
