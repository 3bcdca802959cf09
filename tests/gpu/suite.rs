//! `raytoy test` as an author and a machine see it: goldens, settings, laws, formats, exit codes.

use crate::device;
use std::ops::Deref;
use std::process::Output;

use crate::common::folder::{Folder, stdout as said};

const BALL: &str = "// A ball on a floor.
(
    lights: [Point(position: (4, 6, 5))],
    objects: [
        Plane(name: \"floor\", material: (color: 0.4)),
        Sphere(name: \"ball\", center: (0, 1, 0), material: (color: Pond())),
    ],
)
";

const POND: &str = "/// Waves that run outwards from the origin.
///
/// scale = 1, 0.1 to 100: waves per scene unit
fn pond(at: Surface, scale: f32) -> f32 {
    return 0.5 + 0.5 * sin(6.2831853 * fract(length(at.uv) * scale));
}
";

/// A folder with a scene, and a texture that it uses.
struct Project(Folder);

#[test]
fn from_nothing_to_green_takes_one_bless() {
    let Some(project) = Project::new() else { return };
    let missing = project.test(&[]);
    assert_eq!(
        said(&missing),
        "FAILED   scenes/ball.ron\n    the golden `scenes/ball.wgsl` is missing\n    the golden `scenes/ball.png` is missing\n    \
         if the new output is right: raytoy test scenes/ball.ron --bless\n\
         ok       scenes/textures/pond.wgsl\n1 passed, 1 failed\n"
    );
    assert_eq!(missing.status.code(), Some(1));
    assert!(
        !project.has("scenes/ball.wgsl") && !project.has("scenes/ball.png"),
        "nothing is created unasked"
    );
    let blessed = project.test(&["scenes/ball.ron", "--bless"]);
    assert_eq!(
        said(&blessed),
        "ok       scenes/ball.ron\n    wrote scenes/ball.wgsl (new)\n    wrote scenes/ball.png (new)\n1 passed, 0 failed\n"
    );
    assert!(project.read("scenes/ball.wgsl").starts_with("// Generated from scenes/ball.ron\n"));
    let green = project.test(&[]);
    assert_eq!(
        said(&green),
        "ok       scenes/ball.ron\nok       scenes/textures/pond.wgsl\n2 passed, 0 failed\n"
    );
    assert_eq!(green.status.code(), Some(0));
    assert!(said(&project.test(&["--bless"])).ends_with("2 passed, 0 failed\n"));
    assert!(!said(&project.test(&["--bless"])).contains("wrote"), "what is right is not written again");
    // From another folder the first line of the text is another, and that is no difference.
    let inside = project.command(&["test"]).current_dir(project.path().join("scenes")).output().unwrap();
    assert_eq!(said(&inside), "ok       ball.ron\nok       textures/pond.wgsl\n2 passed, 0 failed\n");
}

#[test]
fn a_changed_scene_is_told_by_object_and_by_sight() {
    let Some(project) = Project::blessed() else { return };
    project.write("scenes/ball.ron", &BALL.replace("(0, 1, 0)", "(0.3, 1, 0)"));
    let told = said(&project.test(&["--filter", "ball"]));
    for line in [
        "FAILED   scenes/ball.ron",
        "    scenes/ball.wgsl differs: 3 lines removed, 3 added",
        "      the object \"ball\" moved or changed",
        "@@ -36,11 +36,11 @@ `ballCrossing`, object \"ball\"",
        "-/// objects[1] \"ball\": Sphere(center: (0, 1, 0))",
        "+/// objects[1] \"ball\": Sphere(center: (0.3, 1, 0))",
        "    scenes/ball.png looks different",
        " pixels (",
        "FLIP is ",
        " of 100 in the box x ",
        "; there is now \"",
        "      largest difference in the pixel (",
        "    if the new output is right: raytoy test scenes/ball.ron --bless",
        "0 passed, 1 failed",
    ] {
        assert!(told.contains(line), "{line}\n\nis not in\n\n{told}");
    }
    let gone = BALL.lines().filter(|line| !line.contains("Sphere")).collect::<Vec<_>>().join("\n");
    project.write("scenes/ball.ron", &gone);
    let told = said(&project.test(&["scenes/ball.ron"]));
    assert!(
        told.contains("      the object \"ball\" is gone\n") && !told.contains("moved or changed"),
        "{told}"
    );
    // Bless lists what it changes, and only what is asked for.
    assert_eq!(project.test(&["--bless", "nothing"]).status.code(), Some(2));
    let told = said(&project.test(&["--bless", "ball"]));
    assert_eq!(
        told,
        "ok       scenes/ball.ron\n    wrote scenes/ball.wgsl (changed)\n    wrote scenes/ball.png (changed)\n1 passed, 0 failed\n"
    );
}

#[test]
fn a_changed_texture_is_seen_in_the_picture_alone() {
    let Some(project) = Project::blessed() else { return };
    project.write(
        "scenes/textures/pond.wgsl",
        &POND.replace("fract(length(at.uv) * scale)", "fract(length(at.uv) * scale + 0.02)"),
    );
    let told = said(&project.test(&[]));
    assert!(told.contains("scenes/ball.png looks different") && !told.contains("ball.wgsl"), "{told}");
    assert!(told.contains("there is now \"ball\" 100 %"), "{told}");
    assert!(told.ends_with("1 passed, 1 failed\n"));
}

#[test]
fn textures_and_shapes_that_break_a_law_fail() {
    let Some(project) = Project::blessed() else { return };
    project.write("scenes/textures/pond.wgsl", &POND.replace("0.5 + 0.5 *", "0.5 + 0.7 *"));
    let broken = project.test(&["scenes/textures/pond.wgsl"]);
    let law = "    Pond breaks the law that values stay between 0 and 1, or where the doc line `/// gives LOW to HIGH` says: Pond() at position";
    assert!(said(&broken).contains(law), "{}", said(&broken));
    assert_eq!(broken.status.code(), Some(1));
    project.write("scenes/textures/pond.wgsl", &POND.replace("fract(", "fact("));
    let told = said(&project.test(&["scenes/textures"]));
    assert!(told.contains("scenes/textures/pond.wgsl:5:40") && told.contains("fact"), "{told}");
    let wall = "/// A wall.\n///\n/// encloses nothing\nfn wall(ray: Ray) -> f32 {\n    return onRay(ray, (0.0 - ray.origin.z) / ray.direction.z);\n}\n\n\
                fn wallSurface(p: vec3f) -> Surface {\n    return surface(p, vec3f(0.0, 0.0, 2.0), p.xy);\n}\n";
    project.write("scenes/shapes/wall.wgsl", wall);
    let told = said(&project.test(&["scenes/shapes/wall.wgsl"]));
    assert!(told.contains("Wall breaks the law that normals have length 1: Wall(), the ray from "), "{told}");
    assert!(!told.contains("bless"), "no golden helps here: {told}");
}

#[test]
fn settings_are_read_with_care() {
    let Some(project) = Project::blessed() else { return };
    let settings = |text: &str| {
        project.write("scenes/ball.test.ron", text);
        said(&project.test(&["scenes/ball.ron"]))
    };
    assert_eq!(
        settings("(tolerence: 9)"),
        "FAILED   scenes/ball.ron
    error: a test has no setting `tolerence`
      ┌─ scenes/ball.test.ron:1:2
      │
    1 │ (tolerence: 9)
      │  ^^^^^^^^^
      │
      = help: did you mean `tolerance`?
0 passed, 1 failed
"
    );
    assert_eq!(
        settings("(\n    samples: 4,\n    flip: 0.05,\n)"),
        "FAILED   scenes/ball.ron
    error: `flip` is looser than 0.001 and needs a reason
      ┌─ scenes/ball.test.ron:3:11
      │
    3 │     flip: 0.05,
      │           ^^^^
      │
      = help: add a reason: `reason: \"the shadow is noisy\"`
0 passed, 1 failed
"
    );
    for (text, message) in [
        (
            "(size: (160, 0))",
            "`size` takes width and height from 8 to 4096, such as `(160, 120)`, found a vector of 2",
        ),
        ("(samples: 1.5)", "`samples` takes a whole number from 1 to 65536, found the number 1.5"),
        ("(outliers: 2, reason: \"noise\")", "`outliers` takes a number from 0 to 1, found the number 2"),
        ("(text: 1)", "`text` takes true or false, found the number 1"),
        ("(samples: 2, samples: 3)", "`samples` is given twice"),
        ("[1]", "write settings as fields in parentheses"),
        ("(samples: 2", "is not closed"),
    ] {
        let told = settings(text);
        assert!(told.contains(message) && told.ends_with("0 passed, 1 failed\n"), "{text}: {told}");
    }
    assert!(settings("(flip: 0.05, reason: \"why not\")").ends_with("1 passed, 0 failed\n"));
    assert!(settings("(flip: 0.0001)").ends_with("1 passed, 0 failed\n"), "stricter needs no reason");
    let told = settings("(size: (64, 48))");
    assert!(told.contains("scenes/ball.png is 160x120, but the picture is 64x48"), "{told}");
    let told = settings("(skip: \"not finished\")");
    assert_eq!(told, "skipped  scenes/ball.ron: not finished\n0 passed, 0 failed\n");
    project.write("scenes/textures/pond.wgsl", &POND.replace("* scale)", "* scale + frame.time)"));
    assert!(settings("()").ends_with("1 passed, 0 failed\n"));
    assert!(settings("(time: 0.3)").ends_with("0 passed, 1 failed\n"), "a texture that moves");
    // A folder's settings hold below it, and a scene's own go over them.
    project.write("folder.test.ron", "(size: (64, 48), picture: false)");
    assert!(settings("(samples: 1)").ends_with("1 passed, 0 failed\n"));
    assert!(settings("(picture: true)").contains("is 160x120, but the picture is 64x48"));
}

#[test]
fn limits_are_loosened_only_as_far_as_they_say() {
    let Some(project) = Project::blessed() else { return };
    project.write(
        "scenes/ball.test.ron",
        "(text: false, outliers: 1, structure: -1, window: -1, flip: 1, reason: \"all\")",
    );
    project.write("scenes/ball.ron", &BALL.replace("(4, 6, 5)", "(-4, 6, 5)"));
    assert!(said(&project.test(&["scenes/ball.ron"])).ends_with("1 passed, 0 failed\n"));
    project.write("scenes/ball.test.ron", "(text: false, outliers: 1, structure: -1, window: -1)");
    assert_eq!(said(&project.test(&["scenes/ball.ron"])).matches("and needs a reason").count(), 3);
}

#[test]
fn mistakes_fail_unless_they_are_what_is_tested() {
    let Some(project) = Project::blessed() else { return };
    project.write("scenes/wrong.ron", "(objects: [Spere()])");
    let told = said(&project.test(&["scenes/wrong.ron"]));
    assert!(told.contains("did you mean `Sphere`?") && told.ends_with("0 passed, 1 failed\n"), "{told}");
    project.write("scenes/wrong.test.ron", "(mistakes: true)");
    assert!(said(&project.test(&["scenes/wrong.ron"])).contains("the golden `scenes/wrong.txt` is missing"));
    assert!(said(&project.test(&["scenes/wrong.ron", "--bless"])).contains("wrote scenes/wrong.txt (new)"));
    assert!(said(&project.test(&["scenes/wrong.ron"])).ends_with("1 passed, 0 failed\n"));
    project.write("scenes/wrong.ron", "(objects: [Sphere()])");
    assert!(said(&project.test(&["scenes/wrong.ron"])).contains("scenes/wrong.txt differs"));
}

#[test]
fn goldens_may_lie_elsewhere_and_for_another_adapter() {
    let Some(project) = Project::new() else { return };
    project.test(&["scenes/ball.ron", "--goldens", "kept", "--bless"]);
    assert!(project.has("kept/scenes/ball.wgsl") && project.has("kept/scenes/ball.png"));
    assert!(!project.has("scenes/ball.wgsl"));
    project.write("scenes/textures/demo.ron", BALL);
    assert_eq!(
        said(&project.test(&["scenes/textures/demo.ron", "--bless"])),
        "FAILED   scenes/textures/demo.ron\n    a golden in this folder would be read as a texture or shape\n      \
         move the scene to another folder, or choose a folder for the goldens: `--goldens FOLDER`\n0 passed, 1 failed\n"
    );
    std::fs::remove_file(project.path().join("scenes/textures/demo.ron")).unwrap();
    assert!(said(&project.test(&["--goldens", "kept"])).ends_with("2 passed, 0 failed\n"));
    // One that is asked for by name takes its own pictures, where there are such.
    let named = ["scenes/ball.ron", "--goldens", "kept", "--adapter", "llvmpipe"];
    let Some(0) = project.test(&named).status.code() else { return };
    std::fs::write(project.path().join("kept/scenes/ball.llvmpipe.png"), b"no picture").unwrap();
    let told = said(&project.test(&named));
    assert!(told.contains("cannot read `kept/scenes/ball.llvmpipe.png`"), "{told}");
    assert!(said(&project.test(&["--goldens", "kept"])).ends_with("2 passed, 0 failed\n"));
}

#[test]
fn lists_filters_and_wrong_calls() {
    let Some(project) = Project::new() else { return };
    for (path, text) in [(".hidden/a.ron", BALL), ("target/a.ron", BALL), ("scenes/ball.test.ron", "()")] {
        project.write(path, text);
    }
    assert_eq!(said(&project.test(&["--list"])), "scenes/ball.ron\nscenes/textures/pond.wgsl\n");
    assert_eq!(said(&project.test(&["--list", "--filter", "pond"])), "scenes/textures/pond.wgsl\n");
    assert_eq!(
        said(&project.test(&["--filter", "pond", "--jobs", "1"])),
        "ok       scenes/textures/pond.wgsl\n1 passed, 0 failed\n"
    );
    let refused = |arguments: &[&str]| {
        let done = project.test(arguments);
        assert_eq!((done.status.code(), said(&done)), (Some(2), String::new()), "{arguments:?}");
        String::from_utf8_lossy(&done.stderr).into_owned()
    };
    assert_eq!(refused(&["nowhere"]), "raytoy: there is no file or folder `nowhere`\n");
    assert_eq!(
        refused(&["scenes/ball.test.ron"]),
        "raytoy: `scenes/ball.test.ron` is not a test: it contains the settings of a test; name the scene\n"
    );
    project.write("pond.wgsl", POND);
    assert_eq!(
        refused(&["pond.wgsl"]),
        "raytoy: `pond.wgsl` is not a test: textures belong in a folder `textures`, shapes in a folder `shapes`\n"
    );
    assert_eq!(
        refused(&["--filter", "x y"]),
        "raytoy: no test has `x y` in its name; `raytoy test --list` prints the names\n"
    );
    project.write("other/bal.test.ron", "()");
    assert_eq!(
        refused(&["."]),
        "raytoy: `other/bal.test.ron` contains the settings of a test, but there is no scene `other/bal.ron`\n"
    );
    std::fs::remove_dir_all(project.path().join("other")).unwrap();
    std::fs::create_dir(project.path().join("empty")).unwrap();
    assert_eq!(
        refused(&["empty"]),
        "raytoy: there is nothing to test: no scenes, textures or shapes were found\n"
    );
    refused(&["--format", "yaml"]);
    refused(&["--jobs", "0"]);
    assert!(refused(&["--adapter", "no such adapter"]).contains("no GPU has `no such adapter` in its name"));
}

#[test]
fn goldens_that_cannot_be_read_are_said_and_blessed_anew() {
    let Some(project) = Project::blessed() else { return };
    let pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n";
    project.write("scenes/ball.png", pointer);
    project.write("scenes/ball.wgsl", pointer);
    let hint = "it is a pointer of Git LFS, not the golden: `git lfs pull` fetches it";
    let told = said(&project.test(&["scenes/ball.ron"]));
    for golden in ["png", "wgsl"] {
        assert!(told.contains(&format!("cannot read `scenes/ball.{golden}`: {hint}\n")), "{told}");
    }
    std::fs::write(project.path().join("scenes/ball.wgsl"), [0xff, 0xfe, 0x00]).unwrap();
    let told = said(&project.test(&["scenes/ball.ron"]));
    assert!(told.contains("cannot read `scenes/ball.wgsl`: ") && told.matches(hint).count() == 1, "{told}");
    assert!(project.test(&["scenes/ball.ron", "--bless"]).status.success());
    assert!(project.test(&["scenes/ball.ron"]).status.success());
}

#[test]
fn goldens_of_scenes_that_are_gone_fail_until_they_are_blessed_away() {
    let Some(project) = Project::blessed() else { return };
    let path = |name: &str| project.path().join(name);
    std::fs::rename(path("scenes/ball.ron"), path("scenes/orb.ron")).unwrap();
    std::fs::copy(path("scenes/ball.png"), path("scenes/ball.nvidia.png")).unwrap();
    assert!(project.test(&["scenes/orb.ron", "--bless"]).status.success());
    let gone = "FAILED   scenes/ball.ron\n    this scene does not exist, but it has goldens: \
                `scenes/ball.wgsl`, `scenes/ball.nvidia.png`, `scenes/ball.png`\n    \
                to remove them: raytoy test scenes --bless scenes/ball.ron\n";
    let rest = "ok       scenes/orb.ron\nok       scenes/textures/pond.wgsl\n2 passed, 1 failed\n";
    for call in [&[][..], &["scenes"], &["./scenes"]] {
        let found = project.test(call);
        assert_eq!((said(&found), found.status.code()), (format!("{gone}{rest}"), Some(1)), "{call:?}");
    }
    // Who asks for other tests, or for one scene, hears nothing of it.
    assert!(project.test(&["scenes/orb.ron"]).status.success());
    assert!(project.test(&["--filter", "orb"]).status.success());
    assert_eq!(said(&project.test(&["--list"])), "scenes/orb.ron\nscenes/textures/pond.wgsl\n");
    let json: serde_json::Value = serde_json::from_str(&said(&project.test(&["--format", "json"]))).unwrap();
    assert_eq!(json["tests"][0]["failures"][0]["kind"], "gone");
    assert_eq!(json["tests"][0]["bless"], "raytoy test scenes --bless scenes/ball.ron");
    let removed = project.test(&["scenes", "--bless", "scenes/ball.ron"]);
    assert_eq!(
        said(&removed),
        "ok       scenes/ball.ron\n    removed scenes/ball.wgsl\n    removed scenes/ball.nvidia.png\n    \
         removed scenes/ball.png\n1 passed, 0 failed\n"
    );
    assert!(project.test(&[]).status.success());
    assert!(project.has("scenes/orb.wgsl") && project.has("scenes/orb.png"), "those of others stay");
}

#[test]
fn files_that_may_be_an_authors_own_are_no_goldens() {
    let Some(project) = Project::blessed() else { return };
    // An export, a text of another scene, a shader, a report, pictures without a text and of another size.
    let text = project.read("scenes/ball.wgsl");
    project.write("export.wgsl", &said(&project.run(&["generate", "scenes/ball.ron", "--standalone"])));
    project.write("ball.wgsl", &text);
    project.write("scenes/renamed.wgsl", &text);
    project.write("scenes/plain.wgsl", "fn plain() {}\n");
    project.write("scenes/wrong.txt", "error: no\n  ┌─ scenes/wrong.ron:1:1\n");
    let picture = project.path().join("scenes/ball.png");
    std::fs::copy(&picture, project.path().join("scenes/photo.png")).unwrap();
    assert!(project.test(&[]).status.success(), "{}", said(&project.test(&[])));
    image::RgbImage::new(32, 24).save(project.path().join("scenes/ball.small.png")).unwrap();
    // Who draws a scene over its golden has made a picture of it.
    let call = ["render", "scenes/ball.ron", "--adapter", "software", "--size", "160x120"];
    assert!(project.run(&[&call[..], &["-o", "scenes/ball.png"]].concat()).status.success());
    std::fs::remove_file(project.path().join("scenes/ball.ron")).unwrap();
    std::fs::remove_file(project.path().join("ball.wgsl")).unwrap();
    assert_eq!(project.test(&["--bless"]).status.code(), Some(1));
    assert!(project.has("scenes/ball.wgsl"), "only a name removes");
    assert_eq!(
        said(&project.test(&["--bless", "ball"])),
        "ok       scenes/ball.ron\n    removed scenes/ball.wgsl\n1 passed, 0 failed\n"
    );
    for own in ["export.wgsl", "scenes/renamed.wgsl", "scenes/ball.png", "scenes/ball.small.png"] {
        assert!(project.has(own), "{own}");
    }
}

#[test]
fn a_named_root_widens_what_a_tested_scene_may_name() {
    let Some(project) = Project::new() else { return };
    project.write("models/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    project.write("inner/scenes/a.ron", "(objects: [Mesh(file: \"../../models/a.obj\")])");
    let test = |arguments: &[&str]| {
        let mut command = project.command(&[&["test", "scenes/a.ron"], arguments].concat());
        command.current_dir(project.path().join("inner")).output().expect("raytoy runs")
    };
    let narrow = said(&test(&["--bless"]));
    assert!(narrow.contains("this file is outside of the scene's root folder"), "{narrow}");
    assert!(test(&["--bless", "--root", ".."]).status.success());
    assert_eq!(said(&test(&["--root", ".."])), "ok       scenes/a.ron\n1 passed, 0 failed\n");
    assert_eq!(test(&["--root", "nowhere"]).status.code(), Some(2));
    assert_eq!(test(&["--root", "../models"]).status.code(), Some(2));
}

/// A texture of a hundred returns, of which Mesa's software driver loses count.
fn deep() -> String {
    let returns = |i| format!("    if k == {i} {{ return vec3f(fract(x * {i}.0), 0.3, 0.01 * {i}.0); }}\n");
    let body: String = (0..100).map(returns).collect();
    format!(
        "/// A test.\nfn deep(at: Surface) -> vec3f {{\n    let x = 0.5 + 0.25 * at.position.x;\n    \
         let k = i32(100.0 * x);\n{body}    return vec3f(1.0);\n}}\n"
    )
}

#[test]
fn each_command_that_draws_reports_a_driver_that_draws_wrong() {
    let Some(project) = Project::new() else { return };
    if !device::gpu().is_some_and(|gpu| gpu.is_software()) {
        return;
    }
    project.write("scenes/textures/deep.wgsl", &deep());
    let scene = "(camera: (eye: (0, 0, 4), target: (0, 0, 0)), objects: [Quad(corner: (-2, -2, 0), \
                 u: (4, 0, 0), v: (0, 4, 0), material: (color: 0, emission: Deep()))])";
    project.write("scenes/deep.ron", scene);
    let words = "warning: the driver draws `scenes/deep.ron` wrong: ";
    let small = ["--size", "32x32", "--samples", "1"];
    let still = [&["render", "scenes/deep.ron", "-o", "deep.png"][..], &small].concat();
    let frames = [&["render", "scenes/deep.ron", "--frames", "0..1", "-o", "####.png"][..], &small].concat();
    for call in [still, frames] {
        let done = project.command(&call).output().unwrap();
        let errors = String::from_utf8_lossy(&done.stderr);
        assert!(errors.contains(words) && done.status.success(), "{call:?}: {errors}");
    }
    let blessed = project.test(&["scenes/deep.ron", "--bless"]);
    assert!(said(&blessed).contains(&format!("    {words}")), "{}", said(&blessed));
    assert_eq!(blessed.status.code(), Some(0));
    let json = said(&project.test(&["scenes/deep.ron", "--format", "json"]));
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert!(json["tests"][0]["warnings"][0].as_str().is_some_and(|text| text.starts_with(words)), "{json}");
    let xml = said(&project.test(&["scenes/deep.ron", "--format", "junit"]));
    assert!(xml.contains("<system-out>warning: the driver draws"), "{xml}");
    project.test(&["scenes/deep.ron", "--report", "out.html"]);
    assert!(project.read("out.html").contains(words));
    assert!(!said(&project.test(&["scenes/ball.ron"])).contains("warning"), "it says nothing of a good one");
}

#[test]
fn programs_and_browsers_get_their_own_formats() {
    let Some(project) = Project::blessed() else { return };
    project.write("scenes/ball.ron", &BALL.replace("0.4)", "0.5)").replace("\"floor\"", "\"<b> & co\""));
    project.write("scenes/later.ron", BALL);
    project.write("scenes/later.test.ron", "(skip: \"not yet\")");
    let json: serde_json::Value = serde_json::from_str(&said(&project.test(&["--format", "json"]))).unwrap();
    assert_eq!((&json["passed"], &json["failed"], &json["skipped"]), (&1.into(), &1.into(), &1.into()));
    let test = &json["tests"][0];
    assert_eq!((&test["name"], &test["outcome"]), (&"scenes/ball.ron".into(), &"failed".into()));
    assert_eq!(test["failures"][0]["kind"], "text");
    assert_eq!(test["failures"][1]["kind"], "picture");
    assert_eq!(test["failures"][1]["area"].as_array().map(Vec::len), Some(4));
    assert!(test["picture"]["flip"].as_f64().is_some_and(|flip| flip > 0.001));
    assert_eq!(test["bless"], "raytoy test scenes/ball.ron --bless");
    assert!(json["adapter"].as_str().is_some_and(|name| !name.is_empty()));
    let xml = said(&project.test(&["--format", "junit"]));
    assert!(
        xml.contains("<testsuite name=\"raytoy\" tests=\"3\" failures=\"1\" errors=\"0\" skipped=\"1\" "),
        "{xml}"
    );
    assert!(
        xml.contains("<testcase classname=\"scenes\" name=\"ball.ron\"")
            && xml.contains("<skipped message=\"not yet\"/>")
    );
    assert!(xml.contains("&quot;&lt;b&gt; &amp; co&quot;") && !xml.contains("<b>"), "{xml}");
    let done = project.test(&["--report", "out.html"]);
    assert!(String::from_utf8_lossy(&done.stderr).contains("The report is out.html."));
    let page = project.read("out.html");
    // Expected and actual twice, once for the slider, and what differs.
    assert_eq!(page.matches("src=\"data:image/png;base64,").count(), 5);
    for part in [
        "<h1>1 passed, 1 failed</h1>",
        "prefers-color-scheme: dark",
        "type=\"range\"",
        "1 skipped",
        "<del>-",
        "<ins>+",
    ] {
        assert!(page.contains(part), "{part}");
    }
    assert!(
        !page.contains("http:") && !page.contains("https:") && !page.contains("<script src"),
        "it needs no network"
    );
    assert!(page.contains("&lt;b&gt;") && !page.contains("<b>"));
}

impl Project {
    /// None where there is no software driver.
    fn new() -> Option<Self> {
        device::gpu()?;
        let project = Self(Folder::new());
        project.write("scenes/ball.ron", BALL);
        project.write("scenes/textures/pond.wgsl", POND);
        Some(project)
    }

    fn blessed() -> Option<Self> {
        let project = Self::new()?;
        let done = project.test(&["scenes/ball.ron", "--bless"]);
        assert!(done.status.success(), "{}", said(&done));
        Some(project)
    }

    fn has(&self, name: &str) -> bool {
        self.path().join(name).exists()
    }

    fn test(&self, arguments: &[&str]) -> Output {
        self.run(&[&["test"], arguments].concat())
    }
}

impl Deref for Project {
    type Target = Folder;

    fn deref(&self) -> &Folder {
        &self.0
    }
}
