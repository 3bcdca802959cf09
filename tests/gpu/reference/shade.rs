//! The ray tree: nearest hits, hard shadows, and the radiance equation of LANGUAGE.md, "Materials".

use super::hit::nearest_hit;
use super::light::Arriving;
use super::material::Material;
use super::scene::{Object, Scene};
use super::surface::{outward_normal, uv};
use super::vector::Vec3;

/// Rays that leave a surface start this far off it, for each unit of the point's largest coordinate.
const OFFSET: f64 = 1e-9;
/// A branch that weighs less adds nothing.
const LEAST_WEIGHT: f64 = 1.0 / 512.0;
/// Where two surfaces coincide but for rounding, the first in the file is hit.
const TIE: f64 = 1e-12;

#[derive(Clone, Copy)]
pub struct Ray {
    pub origin: Vec3,
    /// Of length 1.
    pub direction: Vec3,
}

pub struct Hit<'a> {
    pub t: f64,
    pub object: &'a Object,
}

/// A hit point with what shading asks of it.
struct Point<'a> {
    position: Vec3,
    /// Turned to face the ray.
    normal: Vec3,
    /// Whether the ray comes from outside.
    entering: bool,
    uv: [f64; 2],
    material: &'a Material,
    /// Towards the ray's origin.
    view: Vec3,
}

/// The world normal at a hit, turned to face the ray.
pub fn facing_normal(ray: Ray, hit: &Hit) -> Vec3 {
    Point::new(ray, hit).normal
}

impl Object {
    pub fn hit(&self, origin: Vec3, direction: Vec3, t_max: f64) -> Option<f64> {
        let origin = self.transform.point_to_object(origin);
        let direction = self.transform.direction_to_object(direction);
        nearest_hit(&self.shape, origin.0, direction.0, 0.0, t_max)
    }
}

impl Scene {
    pub fn nearest(&self, ray: Ray) -> Option<Hit<'_>> {
        let mut nearest: Option<Hit> = None;
        for object in self.objects.iter().filter(|object| object.visible) {
            let t_max = nearest.as_ref().map_or(f64::INFINITY, |hit| hit.t * (1.0 - TIE));
            if let Some(t) = object.hit(ray.origin, ray.direction, t_max) {
                nearest = Some(Hit { t, object });
            }
        }
        nearest
    }

    /// What a ray sees whose branch weighs `weight`; the primary ray has depth 0. `media` are the indices of
    /// refraction that it is in, the innermost last.
    fn trace(&self, ray: Ray, media: &[f64], depth: u32, weight: f64) -> Vec3 {
        if f64::from(depth) > self.settings.max_bounces || weight < LEAST_WEIGHT {
            return Vec3::ZERO;
        }
        self.radiance(ray, self.nearest(ray).as_ref(), media, depth, weight)
    }

    /// radiance = (1 − F)·((1 − transmission)·local + transmission·refracted) + F·reflected.
    pub fn radiance(&self, ray: Ray, hit: Option<&Hit>, media: &[f64], depth: u32, weight: f64) -> Vec3 {
        let Some(hit) = hit else {
            return self.background.color(ray.direction);
        };
        let point = Point::new(ray, hit);
        let f = point.reflectance();
        let transmission = point.material.transmission.number(point.uv);
        let mut radiance = Vec3::ZERO;
        if f != 1.0 && transmission != 1.0 {
            radiance = radiance + self.local(&point) * ((1.0 - f) * (1.0 - transmission));
        }
        if transmission != 0.0 {
            let share = (1.0 - f) * transmission;
            let (through, behind) = point.refracted(media);
            let refracted = self.trace(through, &behind, depth + 1, weight * share);
            radiance = radiance + refracted * share;
        }
        if f != 0.0 {
            radiance = radiance + self.trace(point.reflected(), media, depth + 1, weight * f) * f;
        }
        radiance
    }

    /// emission + ambient·color + Σ visibility · intensity · light color
    /// · (color·max(n·l, 0) + specular·max(n·h, 0)^shininess).
    fn local(&self, point: &Point) -> Vec3 {
        let material = point.material;
        let color = material.color.color(point.uv);
        let specular = material.specular.number(point.uv);
        let shininess = material.shininess.number(point.uv);
        let mut sum = material.emission.color(point.uv) + self.ambient * color;
        for light in &self.lights {
            let arriving = light.arriving(point.position);
            let l = arriving.to.unit();
            let facing = point.normal.dot(l);
            if facing <= 0.0 || self.is_blocked(point, &arriving) {
                continue;
            }
            let half = (l + point.view).unit();
            let gloss = specular * point.normal.dot(half).max(0.0).powf(shininess);
            sum = sum + arriving.strength * (color * facing + Vec3::splat(gloss));
        }
        sum
    }

    fn is_blocked(&self, point: &Point, light: &Arriving) -> bool {
        let origin = point.off(point.normal);
        let (direction, t_max) =
            if light.endless { (light.to, f64::INFINITY) } else { (light.to + point.position - origin, 1.0) };
        self.settings.shadows
            && self
                .objects
                .iter()
                .any(|object| object.casts_shadow && object.hit(origin, direction, t_max).is_some())
    }
}

impl<'a> Point<'a> {
    fn new(ray: Ray, hit: &Hit<'a>) -> Point<'a> {
        let Object { shape, transform, material, .. } = hit.object;
        let in_object =
            transform.point_to_object(ray.origin) + transform.direction_to_object(ray.direction) * hit.t;
        let outward = Vec3(outward_normal(shape, in_object.0));
        let normal = transform.normal_to_world(outward);
        let entering = normal.dot(ray.direction) <= 0.0;
        Point {
            position: ray.origin + ray.direction * hit.t,
            normal: if entering { normal } else { -normal },
            entering,
            // Without a uv every texture of the material is constant: `Scene::parse` saw to it.
            uv: uv(shape, in_object, outward).unwrap_or_default(),
            material,
            view: -ray.direction,
        }
    }

    /// F: `reflectivity`, raised towards 1 at grazing angles where `fresnel` is given.
    fn reflectance(&self) -> f64 {
        let reflectivity = self.material.reflectivity.number(self.uv);
        match self.material.fresnel {
            Some(power) => {
                let grazing = (1.0 - self.normal.dot(self.view)).clamp(0.0, 1.0);
                reflectivity + (1.0 - reflectivity) * grazing.powf(power)
            }
            None => reflectivity,
        }
    }

    fn reflected(&self) -> Ray {
        let direction = self.normal * (2.0 * self.normal.dot(self.view)) - self.view;
        Ray { origin: self.off(self.normal), direction: direction.unit() }
    }

    /// Snell's law between the innermost media on both sides, and the media of the ray that goes on; under
    /// total internal reflection the reflected ray.
    fn refracted(&self, media: &[f64]) -> (Ray, Vec<f64>) {
        let ior = self.material.ior;
        let mut behind = media.to_vec();
        let mut before = media.last().copied().unwrap_or(1.0);
        if self.entering {
            behind.push(ior);
        } else if let Some(its) = media.iter().rposition(|medium| *medium == ior) {
            behind.remove(its);
        } else {
            before = ior;
            behind.pop();
        }
        let eta = before / behind.last().copied().unwrap_or(1.0);
        let cosine = self.normal.dot(self.view);
        let k = 1.0 - eta * eta * (1.0 - cosine * cosine);
        if k < 0.0 {
            return (self.reflected(), media.to_vec());
        }
        let direction = self.normal * (eta * cosine - k.sqrt()) - self.view * eta;
        (Ray { origin: self.off(-self.normal), direction: direction.unit() }, behind)
    }

    /// The point moved a little to the side that `normal` shows.
    fn off(&self, normal: Vec3) -> Vec3 {
        let size = self.position.map(f64::abs).largest().max(1.0);
        self.position + normal * (OFFSET * size)
    }
}
