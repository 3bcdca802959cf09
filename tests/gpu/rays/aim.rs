//! Rays that are hard to get right: along edges and axes, past corners, grazing, from inside, from the surface.

use glam::DVec3;
use raytoy::gpu::Ray;

use super::Subject;

impl Subject {
    pub fn ray(&self, random: &mut Random, distance: Option<f64>) -> Ray {
        let (origin, direction) = match distance {
            Some(distance) => self.outer_ray(random, distance + self.radius),
            None => self.inner_ray(random),
        };
        let stretch = if random.below(4) == 0 { 10_f64.powf(random.signed()) } else { 1.0 };
        let direction = (direction.normalize() * stretch).as_vec3();
        Ray { origin: origin.as_vec3(), t_min: 0.0, direction, t_max: 1e30 }
    }

    fn outer_ray(&self, random: &mut Random, away: f64) -> (DVec3, DVec3) {
        let near = 1e-4 * self.radius + 2e-6 * away;
        let aside = |random: &mut Random| random.unit() * near * 10_f64.powf(1.5 * random.signed() + 0.5);
        let towards = |random: &mut Random, target: DVec3| {
            let origin = (self.middle + away * random.unit()).as_vec3().as_dvec3();
            (origin, target - origin)
        };
        let anywhere = self.anywhere(random);
        match random.below(20) {
            // Along an edge, an axis or a normal, or in a plane across it.
            0..4 => {
                let way = self.way(random);
                (anywhere - way * away, way)
            }
            4..6 => {
                let way = random.unit().cross(self.way(random)).normalize_or(DVec3::Y);
                (anywhere - way * away, way)
            }
            // Through or past a corner.
            6..8 => {
                let target = self.places[random.below(self.places.len())];
                towards(random, target)
            }
            8..10 => {
                let target = self.places[random.below(self.places.len())] + aside(random);
                towards(random, target)
            }
            // Past an edge or a silhouette.
            10..12 => {
                let (origin, direction) = towards(random, anywhere);
                let beside = self.anywhere(random) - origin;
                let edge = self.edge(origin, direction, beside);
                (origin, edge + aside(random))
            }
            // Grazing.
            12..15 => {
                let (origin, direction) = towards(random, anywhere);
                let Some((t, normal)) = self.meets(origin, direction, 0.0) else {
                    return (origin, direction);
                };
                let way = random.unit().cross(normal).normalize_or(DVec3::Y);
                let height =
                    self.radius * 10_f64.powf(2.0 * random.signed() - 3.0) * random.signed().signum();
                (origin + direction * t + height * normal - way * away, way)
            }
            _ => towards(random, anywhere),
        }
    }

    fn inner_ray(&self, random: &mut Random) -> (DVec3, DVec3) {
        let origin = self.anywhere(random);
        let direction = if random.below(4) == 0 { self.way(random) } else { random.unit() };
        // A plane goes on where coordinates have few digits left.
        let is_here = |t: f64| t * direction.length() < 4.0 * self.radius;
        let met = self.meets(origin, direction, 0.0).filter(|(t, _)| is_here(*t) && random.below(2) == 0);
        let Some((t, normal)) = met else { return (origin, direction) };
        // A ray that a surface sends: as far off it as raytoy starts one, and now and then along it.
        let p = origin + direction * t;
        let side = random.signed().signum();
        let start = p + side * 1e-5 * p.abs().max_element().max(t) * normal;
        let away = if random.below(3) == 0 { random.unit() } else { side * normal + random.unit() };
        let along = random.unit().cross(normal) + side * 1e-2 * random.signed() * normal;
        (start, if random.below(4) == 0 { along } else { away })
    }

    /// Between two directions, of which one meets what the other does not: where that changes.
    fn edge(&self, origin: DVec3, from: DVec3, to: DVec3) -> DVec3 {
        let face = |direction| self.meets(origin, direction, 0.0).map(|(_, normal)| normal);
        let first = face(from);
        let is_first = |direction| match (first, face(direction)) {
            (Some(a), Some(b)) => a.dot(b) > 0.766,
            (a, b) => a.is_none() && b.is_none(),
        };
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..24 {
            let middle = 0.5 * (low + high);
            if is_first(from.lerp(to, middle)) { low = middle } else { high = middle }
        }
        from.lerp(to, low)
    }

    fn anywhere(&self, random: &mut Random) -> DVec3 {
        self.middle + self.radius * 1.05 * random.signed().abs().cbrt() * random.unit()
    }

    fn way(&self, random: &mut Random) -> DVec3 {
        self.ways[random.below(self.ways.len())] * random.signed().signum()
    }
}

/// SplitMix64.
pub struct Random(pub u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ (x >> 31)
    }

    fn below(&mut self, count: usize) -> usize {
        (self.next() % count as u64) as usize
    }

    /// -1 to 1.
    fn signed(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// A direction.
    fn unit(&mut self) -> DVec3 {
        loop {
            let v = DVec3::new(self.signed(), self.signed(), self.signed());
            if (1e-3..1.0).contains(&v.length()) {
                return v.normalize();
            }
        }
    }
}
