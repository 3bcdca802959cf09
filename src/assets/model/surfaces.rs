//! Which corners at one place belong to one smooth surface, where a file gives no normals.
//!
//! In: triangles, and the number of each corner's place. Out: a number that corners at one place share if
//! they belong to one surface.

use std::collections::HashMap;

use glam::Vec3;

use super::found::{Face, Smoothing};
use super::places::Mixed;

/// Cosine of the angle between two triangles beyond which the edge between them is sharp, where a file
/// says nothing of smoothing: 50 degrees. Prisms of six sides have edges, pipes of eight sides have none.
const SHARP: f32 = 0.642_787_6;

/// The surface of each corner: the number of a corner of it, where corner i of face n has the number 3 n + i.
pub fn numbered(faces: &[Face], geometric_normals: &[Vec3], places: &[[usize; 3]]) -> Vec<[usize; 3]> {
    let mut groups: HashMap<(usize, u32), usize, Mixed> = HashMap::default();
    let mut edges: HashMap<(usize, usize), [usize; 2], Mixed> = HashMap::default();
    let mut leaders: Vec<usize> = (0..3 * faces.len()).collect();
    // A triangle without area has no side that could be smooth with another one.
    let solid = faces
        .iter()
        .zip(geometric_normals)
        .enumerate()
        .filter(|(_, (_, geometric_normal))| **geometric_normal != Vec3::ZERO);
    for (n, (face, geometric_normal)) in solid {
        for i in 0..3 {
            let here = 3 * n + i;
            match face.smoothing {
                Smoothing::Flat => {}
                Smoothing::Group(group) => {
                    let first = *groups.entry((places[n][i], group)).or_insert(here);
                    join(&mut leaders, first, here);
                }
                Smoothing::Creased => {
                    let next = 3 * n + (i + 1) % 3;
                    let [a, b] = [places[n][i], places[n][(i + 1) % 3]];
                    let (edge, ends) = if a < b { ((a, b), [here, next]) } else { ((b, a), [next, here]) };
                    let known = edges.insert(edge, ends);
                    if let Some(others) = known
                        && geometric_normals[others[0] / 3].dot(*geometric_normal) > SHARP
                    {
                        join(&mut leaders, others[0], ends[0]);
                        join(&mut leaders, others[1], ends[1]);
                    }
                }
            }
        }
    }
    (0..faces.len()).map(|n| [0, 1, 2].map(|i| leader(&mut leaders, 3 * n + i))).collect()
}

/// The corner that stands for all of a surface's at its place.
fn leader(leaders: &mut [usize], mut corner: usize) -> usize {
    while leaders[corner] != corner {
        leaders[corner] = leaders[leaders[corner]];
        corner = leaders[corner];
    }
    corner
}

fn join(leaders: &mut [usize], a: usize, b: usize) {
    let (a, b) = (leader(leaders, a), leader(leaders, b));
    leaders[a.max(b)] = a.min(b);
}
