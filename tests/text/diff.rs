//! `raytoy diff` as an author and a machine see it.

use std::io::Write;
use std::process::{Output, Stdio};

use crate::common::folder::{Folder, stderr, stdout};

const SCENE: &str = include_str!("changes/scene.ron");

#[test]
fn the_whole_text_for_people() {
    let folder = Folder::new();
    folder.write("old.ron", SCENE);
    let new = SCENE
        .replace("radius: 1,", "radius: 1.5,")
        .replace("        Torus(", "\n        Torus(name: \"ring\", ");
    folder.write("new.ron", &new);
    let told = diff(&folder, &["old.ron", "new.ron", "--no-picture"]);
    let said = stdout(&told);
    let (values, shader) = said.split_once("shader ").expect("there is a line on the shader");
    assert_eq!(
        values,
        "values   2 values differ\n  objects[\"ball\"].radius: 1 → 1.5  (old.ron:7 → new.ron:7)\n  \
         objects[3].name is new: \"ring\"  (new.ron:10)\n"
    );
    let lines: Vec<&str> = shader.lines().collect();
    assert!(lines[0].ends_with("; the window must build a new pipeline"), "{said}");
    for line in [
        "  the object \"Torus 3\" is gone",
        "  the object \"ring\" is new",
        "  the object \"ball\" moved or changed",
        "  -const OBJECT_TORUS_3: u32 = 3u;",
        "  +const OBJECT_RING: u32 = 3u;",
    ] {
        assert!(lines.contains(&line), "{line}\n\nis not in\n\n{said}");
    }
    assert!(
        lines.last().is_some_and(|l| l.ends_with("more lines; `--report diff.html` shows all")),
        "{said}"
    );
    assert_eq!((told.status.code(), stderr(&told)), (Some(0), String::new()));
    let same = diff(&folder, &["old.ron", "./old.ron", "--no-picture", "--exit-code"]);
    assert_eq!((stdout(&same).as_str(), same.status.code()), ("values   equal\nshader   equal\n", Some(0)));
}

#[test]
fn numbers_alone_need_no_other_pipeline() {
    let folder = Folder::new();
    folder.write("old.ron", "(objects: [Sphere(name: \"ball\", radius: 2)])");
    let first_lines = |new: &str| {
        folder.write("new.ron", new);
        let told = stdout(&diff(&folder, &["old.ron", "new.ron", "--no-picture"]));
        told.lines().filter(|line| !line.starts_with(' ')).collect::<Vec<_>>().join("\n")
    };
    let number = first_lines("(objects: [Sphere(name: \"ball\", radius: 3)])");
    let kept = "lines removed, 3 added; only numbers and comments differ, so the window keeps its pipeline";
    assert_eq!(number, format!("values   1 value differs\nshader   3 {kept}"));
    let camera = first_lines("(camera: (fov_deg: 30), objects: [Sphere(name: \"ball\", radius: 2)])");
    assert_eq!(camera, "values   1 value differs\nshader   equal");
    let structure = first_lines("(objects: [Sphere(name: \"ball\", radius: 2, rotate_deg: (0, 10, 0))])");
    assert!(structure.ends_with("; the window must build a new pipeline"), "{structure}");
}

#[test]
fn files_that_hold_something_else_are_named() {
    let folder = Folder::new();
    let pond = "/// Waves.\nfn pond(at: Surface) -> f32 {\n    return fract(at.uv.x);\n}\n";
    for (place, text) in [("a", pond.to_owned()), ("b", pond.replace("uv.x", "uv.y"))] {
        folder.write(&format!("{place}/scene.ron"), "(objects: [Sphere(material: (color: Pond()))])");
        folder.write(&format!("{place}/textures/pond.wgsl"), &text);
    }
    let told = diff(&folder, &["a/scene.ron", "b/scene.ron", "--no-picture", "--exit-code"]);
    assert_eq!(
        stdout(&told),
        "values   equal\nshader   the scene's own text is equal\n  \
         the content of the file `b/textures/pond.wgsl` differs\n"
    );
    assert_eq!(told.status.code(), Some(1));
    // Standard input is taken as if it lay beside the other scene, whose textures it finds.
    let piped =
        piped(&folder, &["-", "a/scene.ron", "--no-picture", "--exit-code"], &folder.read("a/scene.ron"));
    assert_eq!((stdout(&piped).as_str(), piped.status.code()), ("values   equal\nshader   equal\n", Some(0)));
}

#[test]
fn programs_get_all_of_it() {
    let folder = Folder::new();
    folder.write("old.ron", SCENE);
    folder.write(
        "new.ron",
        &SCENE.replace("\n        Plane(", "\n        Torus(),\n        Plane(").replace("0.2", "0.25"),
    );
    let told = diff(&folder, &["old.ron", "new.ron", "--no-picture", "--format", "json"]);
    let json: serde_json::Value = serde_json::from_str(&stdout(&told)).expect("it is JSON");
    assert_eq!(
        (&json["same"], &json["old"], &json["new"]),
        (&false.into(), &"old.ron".into(), &"new.ron".into())
    );
    assert_eq!(
        json["values"],
        serde_json::json!([
            {
                "path": "objects[\"die\"].parts[\"hole\"].radius",
                "kind": "changed",
                "old": { "path": "objects[4].parts[1].radius", "line": 12, "words": "0.2" },
                "new": { "path": "objects[5].parts[1].radius", "line": 13, "words": "0.25" },
            },
            { "path": "objects[0]", "kind": "new", "new": { "path": "objects[0]", "line": 6, "words": "Torus()" } },
        ])
    );
    let shader = &json["shader"];
    assert_eq!((&shader["same"], &shader["same_live"]), (&false.into(), &false.into()));
    assert_eq!(shader["objects_new"], serde_json::json!(["Sphere 3", "Torus 0", "Torus 4"]));
    let diff = shader["diff"].as_array().expect("it is a list");
    assert!(diff.len() > 40 && diff[0].as_str().is_some_and(|line| line.starts_with("@@ -")), "{diff:?}");
    assert!(json.get("picture").is_none());
}

#[test]
fn exit_codes_and_wrong_calls() {
    let folder = Folder::new();
    folder.write("a.ron", "(objects: [Sphere()])");
    folder.write("b.ron", "(objects: [Sphere(radius: 2)])");
    folder.write("wrong.ron", "(objects: [Spere()])");
    folder.write("plain.png", "\u{89}PNG");
    std::fs::write(folder.path().join("cut.png"), b"\x89PNG\r\n\x1a\n").expect("it is writable");
    let code = |arguments: &[&str]| diff(&folder, &[arguments, &["--no-picture"]].concat()).status.code();
    assert_eq!(code(&["a.ron", "a.ron", "--exit-code"]), Some(0));
    assert_eq!(code(&["a.ron", "b.ron"]), Some(0));
    assert_eq!(code(&["a.ron", "b.ron", "--exit-code"]), Some(1));
    assert_eq!(code(&["a.ron", "wrong.ron"]), Some(1));
    assert_eq!(code(&["wrong.ron", "wrong.ron", "--exit-code"]), Some(2));
    for (call, why) in [
        (&["a.ron", "nothing.ron"][..], "raytoy: there is no file `nothing.ron`\n"),
        (&["-", "-"], "raytoy: only one of the two scenes can come from standard input\n"),
        (&["a.ron", "cut.png"], "raytoy: cannot read `cut.png` as a PNG file: "),
        (&["a.ron", "b.ron", "--format", "junit"], "error: invalid value 'junit'"),
        (&["a.ron"], "error: the following required arguments"),
        (&["a.ron", "b.ron", "--samples", "0"], "error: invalid value '0'"),
    ] {
        let refused = diff(&folder, &[call, &["--no-picture"]].concat());
        assert_eq!((refused.status.code(), stdout(&refused)), (Some(2), String::new()), "{call:?}");
        assert!(stderr(&refused).starts_with(why), "{call:?}: {}", stderr(&refused));
    }
    let both = diff(&folder, &["wrong.ron", "plain.png", "--no-picture"]);
    assert!(
        stderr(&both).contains("did you mean `Sphere`?") && stderr(&both).contains("plain.png"),
        "{both:?}"
    );
}

fn diff(folder: &Folder, arguments: &[&str]) -> Output {
    folder.run(&[&["diff"], arguments].concat())
}

/// The same, with `input` at standard input.
fn piped(folder: &Folder, arguments: &[&str], input: &str) -> Output {
    let mut command = folder.command(&[&["diff"], arguments].concat());
    let streams = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = streams.spawn().expect("raytoy runs");
    let mut stdin = child.stdin.take().expect("it is piped");
    stdin.write_all(input.as_bytes()).expect("raytoy reads");
    drop(stdin);
    child.wait_with_output().expect("raytoy ends")
}
