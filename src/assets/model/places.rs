//! Where corners lie: which of them meet, and whether their triangles enclose anything.
//!
//! In: triangles as they are read. Out: numbers that corners at one place share, and verdicts.

use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

use glam::DVec3;

use super::found::{Face, Found};

/// The bits of a position: equal for corners that meet, whatever the sign of a zero.
pub type Place = (u64, u32);

/// For keys made of bits of numbers, a million at a time.
pub type Mixed = BuildHasherDefault<Mixer>;

pub fn place(position: DVec3) -> Place {
    let [x, y, z] = (position + DVec3::ZERO).as_vec3().to_array().map(f32::to_bits);
    (u64::from(x) | u64::from(y) << 32, z)
}

/// The number of each corner's place.
pub fn numbered(faces: &[Face]) -> Vec<[usize; 3]> {
    let mut known: HashMap<Place, usize, Mixed> = HashMap::default();
    let mut number = |corner: &Found| {
        let next = known.len();
        *known.entry(place(corner.position)).or_insert(next)
    };
    faces.iter().map(|face| face.corners.each_ref().map(&mut number)).collect()
}

/// The same for each triangle with these corners on this side, whichever comes first.
pub fn of_triangle(face: &Face) -> u64 {
    let [a, b, c] = face.corners.each_ref().map(|corner| mixed(&[place(corner.position)]));
    let [x, y, z] = [[a, b], [b, c], [c, a]].map(|[from, to]| turned(from.wrapping_mul(3) ^ to));
    x.wrapping_add(y).wrapping_add(z)
}

/// Whether each edge joins two triangles that face the same side, so that they enclose something.
pub fn is_closed(faces: &[Face]) -> bool {
    // Each edge counts as a number that looks random, one direction up and the other one down: the sum is
    // nothing where each has its opposite, and else as good as never.
    let mut sum = 0_u64;
    for face in faces {
        let at = face.corners.each_ref().map(|corner| place(corner.position));
        for [a, b] in [[at[0], at[1]], [at[1], at[2]], [at[2], at[0]]] {
            let edge = mixed(&[a.min(b), a.max(b)]);
            sum = if a < b { sum.wrapping_add(edge) } else { sum.wrapping_sub(edge) };
        }
    }
    sum == 0
}

/// Whether closed triangles face inward: their volume is less than nothing (the divergence theorem).
pub fn is_inside_out(faces: &[Face]) -> bool {
    let Some(start) = faces.first().map(|face| face.corners[0].position) else { return false };
    let volume = |face: &Face| {
        let [a, b, c] = face.corners.each_ref().map(|corner| corner.position - start);
        a.dot(b.cross(c))
    };
    faces.iter().map(volume).sum::<f64>() < 0.0
}

fn mixed(places: &[Place]) -> u64 {
    let mut mixer = Mixer::default();
    for (first, second) in places {
        mixer.write_u64(*first);
        mixer.write_u32(*second);
    }
    mixer.finish()
}

/// A hash of whole numbers, far faster than that of std, and as good where nobody means harm.
#[derive(Default)]
pub struct Mixer(u64);

impl Hasher for Mixer {
    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|byte| self.write_u64(u64::from(*byte)));
    }

    fn write_u32(&mut self, number: u32) {
        self.write_u64(u64::from(number));
    }

    fn write_u64(&mut self, number: u64) {
        self.0 = turned(self.0 ^ number);
    }

    fn finish(&self) -> u64 {
        self.0
    }
}

/// The last step of SplitMix64 (Steele, Lea and Flood, Fast Splittable Pseudorandom Number Generators, 2014).
fn turned(x: u64) -> u64 {
    let x = x.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}
