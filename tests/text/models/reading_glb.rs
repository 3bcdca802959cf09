//! What a binary glTF file says, to the last digit.

use glam::{Vec2, Vec3};
use serde_json::{Value, json};

use super::glb_writer::{F32, U8, U16, U32, Writer};
use super::reading_obj::{faces, places};

const A: [f32; 3] = [0.0, 0.0, 0.0];
const B: [f32; 3] = [1.0, 0.0, 0.0];
const C: [f32; 3] = [1.0, 1.0, 0.0];
const D: [f32; 3] = [0.0, 1.0, 0.0];

/// Of `primitive`, which is told the accessor of the square's corners.
fn square(node: Value, primitive: impl Fn(&mut Writer, usize) -> Value) -> Vec<u8> {
    let mut writer = Writer::default();
    let positions = writer.vectors(&[A, B, C, D]);
    let primitive = primitive(&mut writer, positions);
    writer.mesh(json!([primitive]));
    writer.finish(json!([node]), &[0])
}

fn indexed(node: Value) -> Vec<u8> {
    square(node, |writer, positions| {
        let indices = writer.indices(&[0, 1, 2, 0, 2, 3], U16);
        json!({ "attributes": { "POSITION": positions }, "indices": indices })
    })
}

#[test]
fn indices_of_every_width_name_corners() {
    for component in [U8, U16, U32] {
        let file = square(json!({ "mesh": 0 }), |writer, positions| {
            let indices = writer.indices(&[0, 1, 2, 0, 2, 3], component);
            json!({ "attributes": { "POSITION": positions }, "indices": indices })
        });
        assert_eq!(places(&file), [[A, B, C], [A, C, D]]);
    }
}

#[test]
fn without_indices_corners_come_in_order() {
    let mut writer = Writer::default();
    let positions = writer.vectors(&[A, B, C, A, C, D, B]);
    writer.mesh(json!([{ "attributes": { "POSITION": positions } }]));
    assert_eq!(places(&writer.finish(json!([{ "mesh": 0 }]), &[0])), [[A, B, C], [A, C, D]]);
}

#[test]
fn strips_and_fans_keep_their_side() {
    let of = |mode: u32, order: &[u32]| {
        let file = square(json!({ "mesh": 0 }), |writer, positions| {
            let indices = writer.indices(order, U32);
            json!({ "attributes": { "POSITION": positions }, "indices": indices, "mode": mode })
        });
        places(&file)
    };
    assert_eq!(of(5, &[0, 1, 3, 2]), [[A, B, D], [D, B, C]]);
    assert_eq!(of(6, &[0, 1, 2, 3]), [[A, B, C], [A, C, D]]);
    // A strip that goes on elsewhere repeats corners.
    assert_eq!(of(5, &[0, 1, 3, 3, 1, 1, 1, 2, 3]), [[A, B, D], [D, B, C]]);
}

#[test]
fn points_and_lines_are_left_out() {
    let mut writer = Writer::default();
    let positions = writer.vectors(&[A, B, C, D]);
    let of = |mode: u32| json!({ "attributes": { "POSITION": positions }, "mode": mode });
    writer.mesh(json!([of(0), of(1), of(2), of(3), of(6)]));
    assert_eq!(places(&writer.finish(json!([{ "mesh": 0 }]), &[0])), [[A, B, C], [A, C, D]]);
}

#[test]
fn nodes_move_what_is_below_them() {
    let moved = indexed(json!({ "mesh": 0, "translation": [1, 2, 3], "scale": [2, 4, 1] }));
    assert_eq!(places(&moved)[0], [[1.0, 2.0, 3.0], [3.0, 2.0, 3.0], [3.0, 6.0, 3.0]]);
    // A quarter around z, as a matrix in columns.
    let turned = indexed(json!({ "mesh": 0, "matrix": [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 5, 1] }));
    let [a, b, c, d] = [[0.0, 0.0, 5.0], [0.0, 1.0, 5.0], [-1.0, 1.0, 5.0], [-1.0, 0.0, 5.0]];
    assert_eq!(places(&turned), [[d, a, c], [c, a, b]]);
    // A quarter around x, and the outer node after the inner one.
    let half = std::f32::consts::FRAC_1_SQRT_2;
    let mut writer = Writer::default();
    let positions = writer.vectors(&[A, B, C]);
    let mesh = writer.mesh(json!([{ "attributes": { "POSITION": positions } }]));
    let nodes = json!([
        { "children": [1], "rotation": [half, 0, 0, half] },
        { "children": [2], "translation": [0, 3, 0] },
        { "mesh": mesh, "scale": [2, 2, 2] },
    ]);
    let found = faces(&writer.finish(nodes, &[0]))[0].map(|corner| corner.position);
    let expected = [[0.0, 0.0, 3.0], [2.0, 0.0, 3.0], [2.0, 0.0, 5.0]].map(Vec3::from);
    assert!(found.iter().zip(expected).all(|(a, b)| a.distance(b) < 1e-5), "{found:?}");
}

#[test]
fn a_mirrored_node_keeps_the_outside_outside() {
    let normal = [0.6, 0.0, 0.8];
    let mut writer = Writer::default();
    let positions = writer.vectors(&[A, B, C]);
    let normals = writer.vectors(&[normal; 3]);
    let mesh = writer.mesh(json!([{ "attributes": { "POSITION": positions, "NORMAL": normals } }]));
    let file = writer.finish(json!([{ "mesh": mesh, "scale": [-2, 1, 1] }]), &[0]);
    let found = faces(&file)[0];
    let [a, b, c] = found.map(|corner| corner.position);
    assert_eq!((b - a).cross(c - a).normalize(), Vec3::Z);
    // As the inverse transpose has it: the surface is steeper where it is drawn out.
    let expected = Vec3::new(-0.3, 0.0, 0.8).normalize();
    assert!(found.iter().all(|corner| corner.normal.distance(expected) < 1e-6), "{found:?}");
}

#[test]
fn two_meshes_of_one_scene_are_one_model() {
    let mut writer = Writer::default();
    let (first, second) = (writer.vectors(&[A, B, C]), writer.vectors(&[A, C, D]));
    let one = writer.mesh(json!([{ "attributes": { "POSITION": first } }]));
    let two = writer.mesh(json!([{ "attributes": { "POSITION": second } }]));
    let nodes = json!([{ "mesh": one }, { "mesh": two }, { "mesh": one, "translation": [9, 0, 0] }]);
    // The third is in no scene.
    assert_eq!(places(&writer.finish(nodes, &[0, 1])), [[A, B, C], [A, C, D]]);
}

#[test]
fn uv_counts_from_the_top_in_every_width() {
    let expected = [[0.0, 1.0], [1.0, 0.8], [0.6, 0.0]].map(Vec2::from);
    for component in [U8, U16, F32] {
        let mut writer = Writer::default();
        let positions = writer.vectors(&[A, B, C]);
        let uvs = match component {
            U8 => writer.accessor(&[0, 0, 255, 51, 153, 255], U8, "VEC2", 3),
            U16 => {
                let all = [0_u16, 0, 65535, 13107, 39321, 65535];
                let bytes: Vec<u8> = all.iter().flat_map(|x| x.to_le_bytes()).collect();
                writer.accessor(&bytes, U16, "VEC2", 3)
            }
            _ => writer.vectors(&[[0.0, 0.0], [1.0, 0.2], [0.6, 1.0]]),
        };
        writer.mesh(json!([{ "attributes": { "POSITION": positions, "TEXCOORD_0": uvs } }]));
        let (mut document, bytes) = writer.parts(json!([{ "mesh": 0 }]), &[0]);
        document["accessors"][uvs]["normalized"] = json!(component != F32);
        let found = faces(&super::glb_writer::file(&document.to_string(), &bytes));
        let uvs = found[0].map(|corner| corner.uv);
        assert!(uvs.iter().zip(expected).all(|(a, b)| a.distance(b) < 1e-6), "{uvs:?}");
    }
}

#[test]
fn elements_may_lie_among_others() {
    // Position and normal of each corner side by side, after something else.
    let normal = [0.0, 0.6, 0.8];
    let words: Vec<f32> = [A, B, C].iter().flat_map(|p| [*p, normal].concat()).collect();
    let bytes: Vec<u8> = [7.0].iter().chain(&words).flat_map(|x: &f32| x.to_le_bytes()).collect();
    let mut writer = Writer::default();
    let positions = writer.accessor(&bytes, F32, "VEC3", 3);
    let normals = writer.accessor(&[], F32, "VEC3", 3);
    writer.mesh(json!([{ "attributes": { "POSITION": positions, "NORMAL": normals } }]));
    let (mut document, bytes) = writer.parts(json!([{ "mesh": 0 }]), &[0]);
    document["bufferViews"][0]["byteStride"] = json!(24);
    document["accessors"][positions]["byteOffset"] = json!(4);
    document["accessors"][normals]["bufferView"] = json!(0);
    document["accessors"][normals]["byteOffset"] = json!(16);
    let found = faces(&super::glb_writer::file(&document.to_string(), &bytes));
    assert_eq!(found[0].map(|corner| corner.position), [A, B, C].map(Vec3::from));
    let is_tilted = |n: Vec3| n.distance(normal.into()) < 1e-6;
    assert!(found[0].iter().all(|corner| is_tilted(corner.normal)), "{found:?}");
}

#[test]
fn whole_numbers_may_stand_for_positions() {
    let mut writer = Writer::default();
    let bytes: Vec<u8> =
        [0_i16, 0, 0, 32767, 0, 0, 32767, 32767, 0].iter().flat_map(|x| x.to_le_bytes()).collect();
    let positions = writer.accessor(&bytes, 5122, "VEC3", 3);
    writer.mesh(json!([{ "attributes": { "POSITION": positions } }]));
    let (mut document, bytes) = writer.parts(json!([{ "mesh": 0 }]), &[0]);
    document["extensionsRequired"] = json!(["KHR_mesh_quantization"]);
    for (is_normalized, size) in [(true, 1.0), (false, 32767.0)] {
        document["accessors"][positions]["normalized"] = json!(is_normalized);
        let found = places(&super::glb_writer::file(&document.to_string(), &bytes));
        assert_eq!(found, [[A, B, C].map(|p| p.map(|x| x * size))]);
    }
}

#[test]
fn what_a_file_says_of_looks_and_motion_is_left_aside() {
    let (mut document, bytes) = {
        let mut writer = Writer::default();
        let positions = writer.vectors(&[A, B, C]);
        writer.mesh(json!([{ "attributes": { "POSITION": positions }, "material": 0 }]));
        writer.parts(json!([{ "mesh": 0 }]), &[0])
    };
    document["materials"] = json!([{ "pbrMetallicRoughness": { "baseColorTexture": { "index": 0 } } }]);
    document["textures"] = json!([{ "extensions": { "EXT_texture_webp": { "source": 7 } } }]);
    document["extensionsRequired"] = json!(["EXT_texture_webp", "KHR_materials_unlit"]);
    assert_eq!(places(&super::glb_writer::file(&document.to_string(), &bytes)), [[A, B, C]]);
}
