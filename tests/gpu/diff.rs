//! `raytoy diff` where it draws: pictures side by side, the page, and pictures that stand for their scenes.

use std::process::Output;

use crate::common::folder::{Folder, stderr, stdout};
use crate::device;

#[test]
fn pictures_are_judged_and_shown_on_a_page() {
    if device::gpu().is_none() {
        return;
    }
    let folder = Folder::new();
    let scene = "(lights: [Point(position: (4, 6, 5))], objects: [Plane(name: \"floor\"), Sphere(name: \"<ball>\", center: (0, 1, 0))])";
    folder.write("old.ron", scene);
    folder.write("new.ron", &scene.replace("(0, 1, 0)", "(0, 1, 0), radius: 0.8"));
    let small = ["--adapter", "software", "--size", "96x54", "--samples", "1"];
    let diff = |arguments: &[&str]| diff(&folder, &[arguments, &small].concat());
    let told = diff(&["old.ron", "new.ron", "--report", "out.html"]);
    let said = stdout(&told);
    for line in [
        "picture  looks different\n",
        " pixels (",
        "FLIP is ",
        "; there was \"<ball>\" ",
        "; there is now \"<ball>\" ",
    ] {
        assert!(said.contains(line), "{line}\n\nis not in\n\n{said}");
    }
    assert!(stderr(&told).ends_with("The report is out.html.\n"), "{}", stderr(&told));
    let page = folder.read("out.html");
    assert_eq!(page.matches("src=\"data:image/png;base64,").count(), 5, "both twice, and what differs");
    for part in [
        "<h1>old.ron → new.ron</h1>",
        "type=\"range\"",
        "alt=\"old.ron\"",
        "<td><code>objects[&quot;&lt;ball&gt;&quot;].radius</code></td><td></td><td><ins>0.8</ins></td><td>new.ron:1</td>",
        "<h2>Shader</h2>",
        "<ins>+",
    ] {
        assert!(page.contains(part), "{part}");
    }
    assert!(!page.contains("http:") && !page.contains("https:") && !page.contains("<ball>"));
    let json = stdout(&diff(&["old.ron", "new.ron", "--format", "json"]));
    let json: serde_json::Value = serde_json::from_str(&json).expect("it is JSON");
    let picture = &json["picture"];
    assert_eq!((&picture["same"], &picture["looks_the_same"]), (&false.into(), &false.into()));
    let share = picture["objects_before"][0]["share"].as_f64();
    assert!(share.is_some_and(|share| share > 0.5 && share <= 1.0), "{picture}");
    assert!(picture["area"].as_array().is_some_and(|area| area.len() == 4) && picture["adapter"].is_string());
    let same = diff(&["old.ron", "old.ron", "--exit-code"]);
    assert_eq!(stdout(&same), "values   equal\nshader   equal\npicture  equal\n");
    assert_eq!(same.status.code(), Some(0));
    // What is hidden changes values alone.
    folder
        .write("hidden.ron", &scene.replace("Plane(", "Sphere(name: \"under\", center: (0, -9, 0)), Plane("));
    assert!(stdout(&diff(&["old.ron", "hidden.ron"])).ends_with("\npicture  equal\n"));
}

#[test]
fn a_picture_stands_for_its_scene() {
    if device::gpu().is_none() {
        return;
    }
    let folder = Folder::new();
    folder.write("ball.ron", "(objects: [Sphere(radius: 2)])");
    let render = ["render", "ball.ron", "-o", "ball.png", "--size", "16x9", "--adapter", "software"];
    assert!(folder.run(&render).status.success());
    folder.write("ball.ron", "(objects: [Sphere(radius: 3)])");
    let told = diff(&folder, &["ball.png", "ball.ron", "--no-picture"]);
    let line = "  objects[0].radius: 2 → 3  (ball.png:1 → ball.ron:1)\n";
    assert!(stdout(&told).starts_with(&format!("values   1 value differs\n{line}")), "{}", stdout(&told));
}

fn diff(folder: &Folder, arguments: &[&str]) -> Output {
    folder.run(&[&["diff"], arguments].concat())
}
