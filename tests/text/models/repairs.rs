//! Odd values: what can be read without them is read, and a warning counts them.

use glam::Vec3;
use raytoy::assets::Model;
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;
use serde_json::json;

use super::glb_writer::{Writer, file};
use super::reading_obj::{faces, places};
use super::{decoded, shapes};

/// A square of two triangles.
const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";

fn warnings(bytes: &[u8]) -> Vec<String> {
    decoded(bytes).unwrap_or_else(|why| panic!("it {why}")).warnings
}

#[test]
fn odd_values_of_texts_are_counted_and_not_more() {
    let cases: [(&str, usize, &[&str]); 13] = [
        (SQUARE, 2, &[]),
        // No number, none of C's ways to say so, and not in the file.
        (
            "vn nan nan nan\nf 2//1 3//1 4//1",
            3,
            &["has 3 invalid normals: the normals of the triangles are used there"],
        ),
        (
            "vn -1.#IND 0 0\nf 2//1 3 4",
            3,
            &["has an invalid normal: the normals of the triangles are used there"],
        ),
        (
            "vt 0 0\nf 2/9 3/1 4/1",
            3,
            &["has an invalid uv: images are laid on these triangles along an axis"],
        ),
        ("vt inf 0\nf 2/1 3/1 4", 3, &["has 2 invalid uv: images are laid on these triangles along an axis"]),
        ("f 1 2 9", 2, &["lacks 1 of its 3 triangles: line 7: the corner `9` is not in the file"]),
        ("f 1 2 0\nf 1 2 -99", 2, &["lacks 2 of its 4 triangles: line 7: the corner `0` is not in the file"]),
        (
            "f 1 2 x",
            2,
            &["lacks 1 of its 3 triangles: line 7: expected a corner such as `7` or `7/2/5`, found `x`"],
        ),
        (
            "v 1 nan 3\nf 1 2 5",
            2,
            &["lacks 1 of its 3 triangles: line 7: expected 3 numbers up to 1e9, found `1 nan 3`"],
        ),
        // A corner that no face has does no harm.
        ("v 1 nan 3", 2, &[]),
        ("v 1", 2, &[]),
        (
            "cstype bezier\nsurf 0 1 0 1 1 2 3 4\nend",
            2,
            &["has a free-form curve or surface: only its faces are shown"],
        ),
        ("l 1 2\np 3\nusemtl a\nvp 1 2\nunheard of", 2, &[]),
    ];
    for (more, count, expected) in cases {
        let text = if more == SQUARE { SQUARE.to_owned() } else { format!("{SQUARE}{more}\n") };
        assert_eq!(warnings(text.as_bytes()), expected, "{more}");
        assert_eq!(decoded(text.as_bytes()).unwrap().triangles.len(), count, "{more}");
    }
    let normals = faces(format!("{SQUARE}vn nan nan nan\nf 2//1 3//1 4//1\n").as_bytes());
    assert!(normals.iter().flatten().all(|corner| corner.normal.distance(Vec3::Z) < 1e-6));
}

#[test]
fn a_file_that_loses_most_is_refused() {
    let told = decoded(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n").unwrap_err();
    assert_eq!(told, "is damaged: line 5: the corner `4` is not in the file");
    assert_eq!(
        decoded(b"v 0,5 1,0 2\nv 1,0 2,0 1\nv 0,1 0 1\nf 1 2 3\n").unwrap_err(),
        "is damaged: line 1: expected 3 numbers up to 1e9, found `0,5 1,0 2`"
    );
}

#[test]
fn what_is_no_model_is_called_by_its_name() {
    let cases: [(&[u8], &str); 7] = [
        (
            b"version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n",
            "is a pointer of Git LFS, not the model: run `git lfs pull` to fetch it",
        ),
        (b"\xff\xfev\x00 \x00", "is text in UTF-16: save it as UTF-8"),
        (b"\xef\xbb\xbf \n", "is empty"),
        (
            b"{\"asset\": {\"version\": \"1.0\"}, \"meshes\": {\"a\": {}}}",
            "is glTF 1.0: export it as glTF 2.0",
        ),
        (b"glTF\x01\0\0\0\x14\0\0\0\0\0\0\0\0\0\0\0", "is glTF 1.0: export it as glTF 2.0"),
        (b"{\"name\": \"package\"}", "is JSON, but not glTF"),
        (b"solid cube\nfacet normal 0 0 1\n", "is neither Wavefront OBJ nor glTF"),
    ];
    for (bytes, expected) in cases {
        assert_eq!(decoded(bytes).unwrap_err(), expected);
    }
}

#[test]
fn comments_and_names_may_end_in_a_backslash() {
    let expected = places(SQUARE.as_bytes());
    for end in ["\n", "\r\n", "\r"] {
        for odd in ["# C:\\models\\", "usemtl shop\\wood\\", "mtllib \\", "o a\\", "g a b \\", "#\\", "\\"] {
            let text =
                SQUARE.replace("v 1 0", &format!("{odd}\nv 1 0")).replace("f 1 3", &format!("{odd}\nf 1 3"));
            let behind =
                SQUARE.replace("\nv", &format!(" {}\nv", if odd.starts_with('#') { odd } else { "" }));
            assert_eq!(places(text.replace('\n', end).as_bytes()), expected, "{text:?}");
            assert_eq!(places(behind.replace('\n', end).as_bytes()), expected, "{behind:?}");
        }
        // And a line of numbers goes on.
        let text = SQUARE.replace("f 1 2 3", "f 1 \\\n 2 \\ \n3").replace("v 1 1 0", "v \\\n1 1\\\n0");
        assert_eq!(places(text.replace('\n', end).as_bytes()), expected, "{text:?}");
    }
    let marked = [b"\xef\xbb\xbf", SQUARE.as_bytes()].concat();
    assert_eq!(places(&marked), expected);
    // Lines are counted as editors count them.
    let told = decoded(b"# a\rv 0 0 0\r\n\nf 1 \\\n2 9\n").unwrap_err();
    assert!(told.contains("line 4: "), "{told}");
}

#[test]
fn odd_values_of_binary_files_are_counted_and_not_more() {
    let nan = [f32::NAN, 0.0, 0.0];
    let corners = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], nan];
    let mut writer = Writer::default();
    let positions = writer.vectors(&corners);
    let normals = writer.vectors(&[[0.0, 0.0, 1.0], nan, [0.0, 0.0, 1.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]]);
    let indices = writer.indices(&[0, 1, 2, 0, 2, 3, 0, 1, 4, 0, 1, 99], super::glb_writer::U16);
    let primitive = json!({ "attributes": { "POSITION": positions, "NORMAL": normals }, "indices": indices });
    writer.mesh(json!([primitive, { "attributes": { "POSITION": positions }, "mode": 0 }]));
    let (mut document, bytes) = writer.parts(json!([{ "mesh": 0 }]), &[0]);
    document["extensionsUsed"] = json!(["KHR_materials_unlit", "ACME_warp"]);
    // As some programs write it: without limits, and padded with zeros.
    document["accessors"].as_array_mut().unwrap().iter_mut().for_each(|accessor| {
        accessor.as_object_mut().unwrap().retain(|key, _| key != "min" && key != "max");
    });
    let mut json = document.to_string();
    (0..5).for_each(|_| json.push('\0'));
    let model: Model = decoded(&file(&json, &bytes)).unwrap();
    assert_eq!(model.triangles.len(), 2);
    let expected = [
        "uses `ACME_warp`, which raytoy does not support",
        "has a part of points or lines: only its triangles are shown",
        "lacks 2 of its 4 triangles: a corner has invalid numbers, or numbers beyond 1e9",
        "has an invalid normal: the normals of the triangles are used there",
    ];
    assert_eq!(model.warnings, expected);
    document["extensionsRequired"] = json!(["ACME_warp"]);
    let told = decoded(&file(&document.to_string(), &bytes)).unwrap_err();
    assert_eq!(told, "needs `ACME_warp`, which raytoy does not support: export the model without it");
}

#[test]
fn a_warning_stands_where_the_scene_names_the_file() {
    let scene = "(objects: [Mesh(file: \"a.obj\"), Mesh(file: \"a.obj\", translate: (2, 0, 0))])";
    let model = format!("{}f 1 2 99\n", shapes::made("cube.obj").unwrap());
    let sources = Sources::in_memory().with("a.ron", scene).with("a.obj", &model);
    let outcome = raytoy::compile(&sources, "a.ron".as_ref(), Mode::Baked, None);
    assert!(outcome.compiled.is_some());
    let told = outcome.report.to_string();
    assert!(
        told.starts_with("warning: `a.obj` lacks 1 of its 13 triangles: line 15: the corner `99`"),
        "{told}"
    );
    assert!(told.contains("a.ron:1:23") && told.matches("warning").count() == 1, "{told}");
}
