//! What moves the triangles of a glTF file: copies, hidden nodes, skins, morphs, sparse accessors, files beside it.

use std::sync::Arc;

use raytoy::assets::Model;
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;
use serde_json::{Value, json};

use super::decoded;
use super::glb_writer::{F32, U8, U16, Writer, file};
use super::reading_obj::places;

const A: [f32; 3] = [0.0, 0.0, 0.0];
const B: [f32; 3] = [1.0, 0.0, 0.0];
const C: [f32; 3] = [0.0, 1.0, 0.0];

fn moved(by: [f32; 3]) -> [[f32; 3]; 3] {
    [A, B, C].map(|p| [0, 1, 2].map(|i| p[i] + by[i]))
}

/// A file of one triangle; `change` may add to its document.
fn with(nodes: Value, change: impl Fn(&mut Writer, &mut Value)) -> Vec<u8> {
    let mut writer = Writer::default();
    let positions = writer.vectors(&[A, B, C]);
    let mut mesh = json!({ "attributes": { "POSITION": positions } });
    change(&mut writer, &mut mesh);
    writer.mesh(json!([mesh]));
    writer.finish(nodes, &[0])
}

#[test]
fn copies_stand_where_their_node_and_they_say() {
    let mut writer = Writer::default();
    let positions = writer.vectors(&[A, B, C]);
    writer.mesh(json!([{ "attributes": { "POSITION": positions } }]));
    let places_of = writer.vectors(&[[-3.0, 0.0, 0.0], [3.0, 0.0, 0.0]]);
    let scales = writer.vectors(&[[1.0; 3], [2.0; 3]]);
    // A half turn around z, as shares of 32767, then none.
    let turns: Vec<u8> = [0_i16, 0, 32767, 0, 0, 0, 0, 32767].iter().flat_map(|x| x.to_le_bytes()).collect();
    let turns = writer.accessor(&turns, 5122, "VEC4", 2);
    let attributes = json!({ "TRANSLATION": places_of, "SCALE": scales, "ROTATION": turns });
    let instancing = json!({ "EXT_mesh_gpu_instancing": { "attributes": attributes } });
    let node = json!({ "mesh": 0, "translation": [0, 5, 0], "extensions": instancing });
    let (mut document, bytes) = writer.parts(json!([node]), &[0]);
    document["accessors"][turns]["normalized"] = json!(true);
    document["extensionsRequired"] = json!(["EXT_mesh_gpu_instancing"]);
    let found = places(&file(&document.to_string(), &bytes));
    let expected = [
        [[-4.0, 5.0, 0.0], [-3.0, 4.0, 0.0], [-3.0, 5.0, 0.0]],
        [[3.0, 5.0, 0.0], [5.0, 5.0, 0.0], [3.0, 7.0, 0.0]],
    ];
    let off = found.iter().flatten().flatten().zip(expected.iter().flatten().flatten());
    assert!(found.len() == 2 && off.into_iter().all(|(a, b)| (a - b).abs() < 1e-5), "{found:?}");
}

#[test]
fn hidden_nodes_hide_what_is_below_them() {
    let hidden = json!({ "KHR_node_visibility": { "visible": false } });
    let nodes = json!([
        { "mesh": 0, "children": [1, 3] },
        { "mesh": 0, "translation": [2, 0, 0], "children": [2], "extensions": hidden },
        { "mesh": 0, "translation": [2, 0, 0] },
        { "mesh": 0, "translation": [0, 3, 0], "extensions": { "KHR_node_visibility": { "visible": true } } },
    ]);
    assert_eq!(places(&with(nodes, |_, _| {})), [moved(A), moved([0.0, 3.0, 0.0])]);
}

#[test]
fn a_skin_takes_corners_where_its_joints_are_and_not_its_node() {
    let mut writer = Writer::default();
    let positions = writer.vectors(&[A, B, C]);
    // The first corner hangs on both joints, the second on the second, the third on the first.
    let joints = writer.accessor(&[0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0], U8, "VEC4", 3);
    let weights = [[0.5_f32, 0.5, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0]];
    let weights: Vec<u8> = weights.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
    let weights = writer.accessor(&weights, F32, "VEC4", 3);
    let attributes = json!({ "POSITION": positions, "JOINTS_0": joints, "WEIGHTS_0": weights });
    writer.mesh(json!([{ "attributes": attributes }]));
    // The first joint is bound 1 to the right of where it stands.
    let bound: [[f32; 16]; 2] = [
        [1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1., 0., -1., 0., 0., 1.],
        [1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1.],
    ];
    let bound: Vec<u8> = bound.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
    let bound = writer.accessor(&bound, F32, "MAT4", 2);
    let nodes = json!([
        { "mesh": 0, "skin": 0, "scale": [9, 9, 9], "translation": [7, 7, 7] },
        { "translation": [0, 0, 2], "children": [2] },
        { "translation": [0, 4, 0] },
    ]);
    let (mut document, bytes) = writer.parts(nodes, &[0, 1]);
    document["skins"] = json!([{ "joints": [1, 2], "inverseBindMatrices": bound }]);
    let found = places(&file(&document.to_string(), &bytes));
    // By hand: a = ((-1, 0, 2) + (0, 4, 2)) / 2, b = (1, 4, 2), c = (-1, 1, 2).
    assert_eq!(found, [[[-1.0, 1.0, 2.0], [-0.5, 2.0, 2.0], [1.0, 4.0, 2.0]]]);
}

#[test]
fn morphs_add_by_their_weights() {
    let of = |nodes: Value, weights: Option<Value>| {
        let mut writer = Writer::default();
        let positions = writer.vectors(&[A, B, C]);
        let lifted = writer.vectors(&[A, A, [0.0, 2.0, 0.0]]);
        let pushed = writer.vectors(&[[0.0, 0.0, 1.0]; 3]);
        let targets = json!([{ "POSITION": lifted }, { "POSITION": pushed }]);
        writer.mesh(json!([{ "attributes": { "POSITION": positions }, "targets": targets }]));
        let (mut document, bytes) = writer.parts(nodes, &[0]);
        if let Some(weights) = weights {
            document["meshes"][0]["weights"] = weights;
        }
        places(&file(&document.to_string(), &bytes))
    };
    let top = |y: f32, z: f32| [[A, B, [0.0, y, 0.0]].map(|p| [p[0], p[1], z])];
    assert_eq!(of(json!([{ "mesh": 0 }]), None), top(1.0, 0.0));
    assert_eq!(of(json!([{ "mesh": 0 }]), Some(json!([0.5, 0]))), top(2.0, 0.0));
    // Those of the node count before those of the mesh.
    assert_eq!(of(json!([{ "mesh": 0, "weights": [1, 3] }]), Some(json!([0.5, 0]))), top(3.0, 3.0));
}

#[test]
fn sparse_accessors_replace_single_elements() {
    let mut writer = Writer::default();
    let positions = writer.vectors(&[A, B, A]);
    let zeros = writer.vectors(&[A, A, A]);
    let (one, two) = (writer.indices(&[2], U16), writer.indices(&[1, 2], U8));
    let (last, both) = (writer.vectors(&[C]), writer.vectors(&[B, C]));
    writer.mesh(json!([{ "attributes": { "POSITION": positions } }]));
    writer.mesh(json!([{ "attributes": { "POSITION": zeros } }]));
    let nodes = json!([{ "mesh": 0 }, { "mesh": 1, "translation": [5, 0, 0] }]);
    let (mut document, bytes) = writer.parts(nodes, &[0, 1]);
    // Views have the numbers of their accessors here.
    let sparse = |count: usize, indices: usize, width: u32, values: usize| {
        let indices = json!({ "bufferView": indices, "componentType": width });
        json!({ "count": count, "indices": indices, "values": { "bufferView": values } })
    };
    document["accessors"][positions]["sparse"] = sparse(1, one, U16, last);
    document["accessors"][zeros]["sparse"] = sparse(2, two, U8, both);
    document["accessors"][zeros].as_object_mut().unwrap().remove("bufferView");
    let found = places(&file(&document.to_string(), &bytes));
    assert_eq!(found, [moved(A), moved([5.0, 0.0, 0.0])]);
}

#[test]
fn without_normals_facets_are_flat_and_without_a_scene_all_nodes_count() {
    let mut writer = Writer::default();
    let positions = writer.vectors(&[A, B, C, [0.0, 0.2, 1.0]]);
    let indices = writer.indices(&[0, 2, 1, 0, 3, 2], U8);
    writer.mesh(json!([{ "attributes": { "POSITION": positions }, "indices": indices }]));
    let nodes = json!([{ "mesh": 0 }, { "children": [2] }, { "mesh": 0, "translation": [3, 0, 0] }]);
    let (mut document, bytes) = writer.parts(nodes, &[0]);
    document.as_object_mut().unwrap().retain(|key, _| key != "scene" && key != "scenes");
    let model = decoded(&file(&document.to_string(), &bytes)).unwrap();
    assert_eq!(model.triangles.len(), 4);
    for triangle in model.triangles.iter() {
        let [a, b, c] = triangle.map(|corner| corner.position);
        let flat = (b - a).cross(c - a).normalize();
        assert!(triangle.iter().all(|corner| corner.normal.distance(flat) < 1e-6), "{triangle:?}");
    }
}

#[test]
fn packed_files_are_told_by_the_name_of_what_packed_them() {
    let (document, bytes) = {
        let mut writer = Writer::default();
        let positions = writer.vectors(&[A, B, C]);
        writer.mesh(json!([{ "attributes": { "POSITION": positions } }]));
        writer.parts(json!([{ "mesh": 0 }]), &[0])
    };
    let extensions = [("KHR_draco_mesh_compression", "Draco"), ("EXT_meshopt_compression", "Meshopt")];
    for (extension, name) in extensions {
        let mut packed = document.clone();
        packed["extensionsUsed"] = json!([extension]);
        // As long as it can be read without, it is.
        assert_eq!(places(&file(&packed.to_string(), &bytes)), [moved(A)]);
        packed["extensionsRequired"] = json!([extension]);
        let told = decoded(&file(&packed.to_string(), &bytes)).unwrap_err();
        let expected = format!("is packed by {name} (`{extension}`), which raytoy does not read");
        assert!(told.starts_with(&expected), "{told}");
    }
}

#[test]
fn text_has_its_buffers_beside_it_or_in_it() {
    let mut writer = Writer::default();
    let positions = writer.vectors(&[A, B, C]);
    writer.mesh(json!([{ "attributes": { "POSITION": positions } }]));
    let (mut document, bytes) = writer.parts(json!([{ "mesh": 0 }]), &[0]);
    document["buffers"][0]["uri"] = json!("my%20corners.bin");
    let text = format!("\u{feff}{document}");
    let read = |bytes: &[u8]| {
        let bytes: Arc<[u8]> = bytes.into();
        Model::decode("a".into(), text.as_bytes(), &mut |name| {
            assert_eq!(name, "my corners.bin");
            Ok(bytes.clone())
        })
    };
    assert_eq!(read(&bytes).unwrap().triangles.len(), 1);
    assert!(read(&bytes[..20]).unwrap_err().starts_with("is damaged"));
    // 36 bytes are 48 digits, and one byte more is four.
    let digit = |six: u8| {
        b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"[usize::from(six)] as char
    };
    let digits = bytes.chunks(3).flat_map(|b| {
        [b[0] >> 2, (b[0] << 4 | b[1] >> 4) & 63, (b[1] << 2 | b[2] >> 6) & 63, b[2] & 63].map(digit)
    });
    let data = format!("data:application/octet-stream;base64,{}AA==", digits.collect::<String>());
    document["buffers"][0]["uri"] = json!(data);
    assert_eq!(places(document.to_string().as_bytes()), [moved(A)]);
    document["buffers"][0]["uri"] = json!("https://example.com/a.bin");
    assert!(decoded(document.to_string().as_bytes()).unwrap_err().contains("from the network"));
}

#[test]
fn an_edit_of_a_file_beside_a_model_is_one_of_the_model() {
    // All of its bytes are text, as far as anybody knows.
    let (from, to) = (f32::from_le_bytes(*b"0000"), f32::from_le_bytes(*b"1111"));
    let bytes = |x: f32| -> String {
        let all = [[from, from, from], [x, from, from], [from, x, from]];
        String::from_utf8(all.as_flattened().iter().flat_map(|x| x.to_le_bytes()).collect()).unwrap()
    };
    let document = json!({
        "asset": { "version": "2.0" }, "buffers": [{ "byteLength": 36, "uri": "b.bin" }],
        "bufferViews": [{ "buffer": 0, "byteLength": 36 }],
        "accessors": [{ "bufferView": 0, "componentType": F32, "type": "VEC3", "count": 3 }],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 } }] }], "nodes": [{ "mesh": 0 }],
    });
    let scene = "(objects: [Mesh(file: \"models/a.gltf\")])";
    let compiled = |x: f32, before: Option<&raytoy::Compiled>| {
        let sources = Sources::in_memory().with("a.ron", scene).with("models/a.gltf", &document.to_string());
        let sources = sources.with("models/b.bin", &bytes(x));
        crate::common::expect_compiled(raytoy::compile(&sources, "a.ron".as_ref(), Mode::Baked, before))
    };
    let first = compiled(to, None);
    let again = compiled(to, Some(&first));
    assert!(Arc::ptr_eq(&first.scene.models[0].triangles, &again.scene.models[0].triangles));
    let other = compiled(f32::from_le_bytes(*b"2222"), Some(&first));
    assert_ne!(other.scene.models, first.scene.models);
}
