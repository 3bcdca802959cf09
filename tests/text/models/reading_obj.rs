//! What an OBJ file says, to the last digit.

use glam::{Vec2, Vec3};
use raytoy::assets::Corner;

use super::decoded;
use crate::common::read;

/// The triangles of a text, each from its least corner on, sorted.
pub fn faces(bytes: &[u8]) -> Vec<[Corner; 3]> {
    let model = decoded(bytes).unwrap_or_else(|why| panic!("it {why}"));
    let key = |c: &Corner| c.position.to_array().map(|x| (f64::from(x) * 1e6).round() as i64);
    let mut found: Vec<[Corner; 3]> = model
        .triangles
        .iter()
        .map(|t| {
            let first = (0..3).min_by_key(|i| key(&t[*i])).expect("there are three");
            [0, 1, 2].map(|i| t[(first + i) % 3])
        })
        .collect();
    found.sort_by_key(|t| t.each_ref().map(key));
    found
}

/// The places of the same.
pub fn places(bytes: &[u8]) -> Vec<[[f32; 3]; 3]> {
    faces(bytes).iter().map(|t| t.map(|corner| corner.position.to_array())).collect()
}

const A: [f32; 3] = [0.0, 0.0, 0.0];
const B: [f32; 3] = [1.0, 0.0, 0.0];
const C: [f32; 3] = [1.0, 1.0, 0.0];
const D: [f32; 3] = [0.0, 1.0, 0.0];
const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

fn square(rest: &str) -> Vec<u8> {
    format!("{SQUARE}{rest}").into_bytes()
}

#[test]
fn faces_of_four_corners_are_two_triangles() {
    assert_eq!(places(&square("f 1 2 3 4")), [[A, B, C], [A, C, D]]);
    assert_eq!(places(&square("f 1 2 3")), [[A, B, C]]);
    // Points and lines have no area.
    assert_eq!(places(&square("f 1 2 3\nf 1\nf 1 2\nl 1 2 3\np 4")), [[A, B, C]]);
}

#[test]
fn polygons_with_corners_that_point_inward_are_filled_and_no_more() {
    // An arrow, an E, and a square with a corner in the middle of a side; areas by hand.
    let arrow = ("v 0 0 0\nv 2 2 0\nv 0 1 0\nv -2 2 0\n", 2.0);
    let letter = (
        "v 0 0 0\nv 3 0 0\nv 3 1 0\nv 1 1 0\nv 1 2 0\nv 3 2 0\nv 3 3 0\nv 1 3 0\nv 1 4 0\nv 3 4 0\nv 3 5 0\nv 0 5 0\n",
        11.0,
    );
    let side = ("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\n", 4.0);
    for (corners, area) in [arrow, letter, side] {
        let count = corners.lines().count();
        for start in 0..count {
            for turn in [false, true] {
                // From each corner on, in both directions, and in each plane.
                let order = (0..count).map(|i| 1 + (start + if turn { count - i } else { i }) % count);
                let face = order.map(|i| format!(" {i}")).collect::<String>();
                for axes in [[0, 1, 2], [1, 2, 0], [2, 0, 1]] {
                    let turned = corners.lines().map(|line| {
                        let p: Vec<&str> = line.split(' ').skip(1).collect();
                        format!("v {} {} {}\n", p[axes[0]], p[axes[1]], p[axes[2]])
                    });
                    let text = turned.collect::<String>() + "f" + &face;
                    let found = faces(text.as_bytes());
                    let normals = found.iter().map(|t| {
                        let [a, b, c] = t.map(|corner| corner.position);
                        0.5 * (b - a).cross(c - a)
                    });
                    let normals: Vec<Vec3> = normals.collect();
                    let whole: Vec3 = normals.iter().sum();
                    assert_eq!(found.len(), count - 2, "{text}");
                    assert!((whole.length() - area).abs() < 1e-5, "{text} fills {whole}");
                    assert!(normals.iter().all(|n| n.dot(whole) > 0.0), "{text} has triangles turned over");
                }
            }
        }
    }
}

#[test]
fn a_spiral_of_a_thousand_corners_is_filled() {
    let count = 500;
    // Out along one side of the band, and back along the other.
    let corner = |i: usize| {
        let (turn, width) = if i < count { (i, 1.0) } else { (2 * count - 1 - i, 0.6) };
        let angle = 12.0 * std::f32::consts::PI * turn as f32 / (count - 1) as f32;
        let radius = 2.0 + angle / std::f32::consts::TAU + 0.5 * width;
        [radius * angle.cos(), radius * angle.sin()]
    };
    let corners: Vec<[f32; 2]> = (0..2 * count).map(corner).collect();
    let next = corners.iter().cycle().skip(1);
    let twice: f32 = corners.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum();
    let text: String = corners.iter().map(|[x, y]| format!("v {x} {y} 0\n")).collect();
    let text = (1..=corners.len()).fold(text + "f", |text, i| format!("{text} {i}"));
    let areas = faces(text.as_bytes()).into_iter().map(|triangle| {
        let [a, b, c] = triangle.map(|corner| corner.position);
        0.5 * (b - a).cross(c - a).z
    });
    let areas: Vec<f32> = areas.collect();
    assert_eq!(areas.len(), corners.len() - 2);
    assert!(areas.iter().all(|area| area * twice > 0.0), "triangles are turned over");
    let whole: f32 = areas.iter().sum();
    assert!((whole - 0.5 * twice).abs() < 1e-3 * whole.abs(), "{whole} of {}", 0.5 * twice);
}

#[test]
fn a_polygon_of_many_corners_is_a_fan() {
    let count = 2000;
    let corner = |i: usize| {
        let (sin, cos) = (i as f32 / count as f32 * std::f32::consts::TAU).sin_cos();
        format!("v {cos} {sin} 0\n")
    };
    let text = (0..count).map(corner).collect::<String>() + "f";
    let text = (1..=count).fold(text, |text, i| format!("{text} {i}"));
    assert_eq!(faces(text.as_bytes()).len(), count - 2);
}

#[test]
fn indices_count_from_the_start_or_back_from_the_face() {
    let expected = [[A, B, C], [A, C, D]];
    assert_eq!(places(&square("f -4 -3 -2 -1")), expected);
    let between = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -4 -2 -1";
    assert_eq!(places(between), expected);
    // Some programs write faces first.
    assert_eq!(places(format!("f 1 2 3 4\n{SQUARE}").as_bytes()), expected);
}

#[test]
fn how_lines_are_written_makes_no_difference() {
    let plain = square("f 1 2 3 4");
    let expected = faces(&plain);
    let text = String::from_utf8(plain).unwrap();
    let written = [
        text.replace('\n', "\r\n"),
        text.replace('\n', "  # a comment\n\n# f 1 2 3\n"),
        text.replace(' ', " \t ").replace('\n', " \n"),
        text.replace("v ", "  v ") + "\n",
        format!("mtllib a.mtl\no thing\ng one two\ns off\nusemtl red\nvp 1 2\n{text}\ng\nunheard of\n"),
        text.replace('\n', " 1.0\n").replace("f 1 2 3 4 1.0", "f 1 2 3 4"),
        text.replace("0\n", "0 0.5 0.25 1\n"),
        text.replace("1 ", "+1.0e0 ").replace("f +1.0e0", "f 1"),
    ];
    for other in written {
        assert_eq!(faces(other.as_bytes()), expected, "{other}");
    }
    // A comment in another encoding.
    assert_eq!(faces(&[b"# caf\xe9\n".as_slice(), text.as_bytes()].concat()), expected);
}

#[test]
fn groups_are_one_model() {
    let text = square("o a\ng left\nusemtl x\nf 1 2 3\no b\nusemtl y\nf 1 3 4\n");
    assert_eq!(places(&text), [[A, B, C], [A, C, D]]);
}

#[test]
fn normals_and_uv_are_those_that_corners_name() {
    let lists = "vn 0 0.6 0.8\nvn 0 0 1\nvt 0.25 0.5\nvt 0.75\nvt 3 4 5\n";
    let found = faces(&square(&format!("{lists}f 1/1/1 2/2/1 3/-1/-1\n")));
    let tilted = Vec3::new(0.0, 0.6, 0.8);
    let normals = found[0].map(|corner| corner.normal);
    assert!(normals.iter().zip([tilted, tilted, Vec3::Z]).all(|(a, b)| a.distance(b) < 1e-6), "{normals:?}");
    let uvs = found[0].map(|corner| corner.uv);
    assert_eq!(uvs, [Vec2::new(0.25, 0.5), Vec2::new(0.75, 0.0), Vec2::new(3.0, 4.0)]);
}

#[test]
fn a_corner_takes_nothing_from_the_one_before() {
    // One face with normals and uv, then one without; and the other way round.
    let lists = "vn 0 0.6 0.8\nvt 9 9\n";
    for faces_of in ["f 1/1/1 2/1/1 3/1/1\nf 1 3 4\n", "f 1 3 4\nf 1/1/1 2/1/1 3/1/1\n"] {
        let found = faces(&square(&format!("{lists}{faces_of}")));
        assert_eq!(found[1].map(|corner| corner.uv), [A, C, D].map(|p| Vec2::new(p[0], p[1])), "{faces_of}");
        assert!(found[1].iter().all(|corner| corner.normal.distance(Vec3::Z) < 1e-6), "{faces_of}");
        assert!(found[0].iter().all(|corner| corner.uv == Vec2::splat(9.0)), "{faces_of}");
    }
    // Only uv, only normals.
    let found = faces(&square(&format!("{lists}f 1/1 2/1/ 3/1\nf 1//1 3//1 4//1\n")));
    assert!(
        found[0].iter().all(|corner| corner.uv == Vec2::splat(9.0) && corner.normal.distance(Vec3::Z) < 0.4)
    );
    assert!(found[1].iter().all(|corner| corner.normal.y > 0.59 && corner.uv.length() < 2.0));
    // A file that has no uv at all may name some.
    assert_eq!(places(&square("f 1/1 2/2 3/3")), [[A, B, C]]);
}

#[test]
fn normals_on_the_wrong_side_are_turned() {
    let found = faces(&square("vn 0 0.6 -0.8\nf 1//1 2//1 3//1\n"));
    assert!(found[0].iter().all(|corner| corner.normal.distance(Vec3::new(0.0, -0.6, 0.8)) < 1e-6));
    // One of no length is none.
    let found = faces(&square("vn 0 0 0\nf 1//1 2//1 3//1\n"));
    assert!(found[0].iter().all(|corner| corner.normal.distance(Vec3::Z) < 1e-6));
}

#[test]
fn the_knot_of_the_gallery_has_the_corners_of_its_file() {
    let text = read("scenes/models/knot.obj");
    let numbers = |line: &str| line.split(' ').skip(1).map(|w| w.to_owned()).collect::<Vec<String>>();
    let corners: Vec<[f32; 3]> = text
        .lines()
        .filter(|line| line.starts_with("v "))
        .map(|line| {
            <[f32; 3]>::try_from(numbers(line).iter().map(|x| x.parse().unwrap()).collect::<Vec<_>>())
                .unwrap()
        })
        .collect();
    let mut expected = vec![];
    for line in text.lines().filter(|line| line.starts_with("f ")) {
        let i: Vec<usize> =
            numbers(line).iter().map(|w| w.split('/').next().unwrap().parse().unwrap()).collect();
        expected.extend((2..i.len()).map(|k| [i[0], i[k - 1], i[k]].map(|n| corners[n - 1])));
    }
    let rounded = |triangles: &[[[f32; 3]; 3]]| {
        let mut keys: Vec<Vec<u32>> = triangles
            .iter()
            .map(|t| {
                let mut corners: Vec<Vec<u32>> =
                    t.iter().map(|p| p.iter().map(|x| x.to_bits()).collect()).collect();
                let first = (0..3).min_by_key(|i| corners[*i].clone()).unwrap();
                corners.rotate_left(first);
                corners.concat()
            })
            .collect();
        keys.sort();
        keys
    };
    assert_eq!(rounded(&places(text.as_bytes())), rounded(&expected));
    assert_eq!(expected.len(), 4800);
    assert!(decoded(text.as_bytes()).unwrap().is_closed);
}

#[test]
fn a_line_may_go_on_in_the_next() {
    assert_eq!(places(&square("f 1 2 \\\n3 4")), [[A, B, C], [A, C, D]]);
    assert_eq!(places(&square("f 1 2 \\\r\n3 4")), [[A, B, C], [A, C, D]]);
}

#[test]
fn a_closed_model_that_faces_inward_is_turned() {
    let cube = super::shapes::made("cube.obj").unwrap();
    let turned = cube.lines().map(|line| match line.strip_prefix("f ") {
        Some(face) => "f ".to_owned() + &face.split(' ').rev().collect::<Vec<_>>().join(" ") + "\n",
        None => line.to_owned() + "\n",
    });
    let volume = |text: &str| -> f32 {
        let all = faces(text.as_bytes());
        all.iter().map(|t| t[0].position.dot(t[1].position.cross(t[2].position)) / 6.0).sum()
    };
    let turned: String = turned.collect();
    assert!((volume(&cube) - 8.0).abs() < 1e-4 && (volume(&turned) - 8.0).abs() < 1e-4);
    assert!(decoded(turned.as_bytes()).unwrap().is_closed);
    // One that has a hole may show its inside on purpose.
    let open = turned.rsplit_once("f ").unwrap().0;
    assert!(volume(open) < 0.0 && !decoded(open.as_bytes()).unwrap().is_closed);
}

#[test]
fn a_triangle_counts_once() {
    assert_eq!(places(&square("f 1 2 3\nf 3 1 2\nf 2 3 1\n")), [[A, B, C]]);
    // Its other side is another one, and together they enclose nothing but themselves.
    let both = decoded(&square("f 1 2 3\nf 3 2 1\n")).unwrap();
    assert!(both.triangles.len() == 2 && both.is_closed);
    // What has no area but three corners may close a seam; what has two closes nothing.
    let seam = b"v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nf 1 3 4\nf 1 2 3\nf 1 1 2\n";
    assert_eq!(decoded(seam).unwrap().triangles.len(), 2);
}
