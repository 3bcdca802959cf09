//! The program as a shell sees it: exit codes, what goes to which stream, and the files that it writes.

use std::process::Output;

use crate::common::folder::Folder;
use crate::common::program::{command, raytoy, stderr, with_input};
use crate::common::{check_text, expect_none, files};

#[test]
fn a_right_scene_is_0_a_wrong_one_1_a_wrong_call_2() {
    let code = |arguments: &[&str]| raytoy(arguments).status.code();
    assert_eq!(code(&["check", "scenes/table.ron"]), Some(0));
    assert_eq!(code(&["check", "tests/cases/errors/scale_zero.ron"]), Some(1));
    assert_eq!(code(&["generate", "tests/cases/errors/scale_zero.ron"]), Some(1));
    for call in [
        &["check", "nothing.ron"][..],
        &["generate", "nothing.ron"],
        &["view", "nothing.ron"],
        &["paint"],
        &["render", "scenes/table.ron"],
        &["render", "scenes/table.ron", "-o", "a.jpg"],
        &["render", "scenes/table.ron", "-o", "a.png", "--size", "0x9"],
        &["render", "scenes/table.ron", "-o", "a.png", "--view", "heat"],
        &["render", "scenes/table.ron", "-o", "a.png", "--samples", "0"],
        &["render", "scenes/table.ron", "scenes/glass.ron", "-o", "a.png"],
    ] {
        assert_eq!(code(call), Some(2), "{call:?}");
    }
}

#[cfg(unix)]
#[test]
fn folders_are_walked_by_links_too_and_each_of_them_once() {
    let folder = Folder::new();
    let scene = "(objects: [Sphere()])";
    for name in ["project/scenes/a.ron", "project/target/b.ron", "project/.hidden/c.ron", "shared/d.ron"] {
        folder.write(name, scene);
    }
    folder.write("shared/textures/e.wgsl", "fn e(at: Surface) -> f32 { return 1.0; }");
    // Out and in, around in a circle, a second way to what is there, and nowhere.
    for (to, at) in [
        ("../../shared", "scenes/linked"),
        ("..", "scenes/up"),
        ("scenes", "also"),
        ("../project/scenes", "../shared/back"),
        ("nowhere", "dangling"),
        ("circle", "circle"),
    ] {
        std::os::unix::fs::symlink(to, folder.path().join("project").join(at)).expect("it is writable");
    }
    let run = |arguments: &[&str]| {
        let mut command = folder.command(arguments);
        command.current_dir(folder.path().join("project")).output().expect("raytoy runs")
    };
    let names = "scenes/a.ron\nscenes/linked/d.ron\nscenes/linked/textures/e.wgsl\n";
    for paths in [&[][..], &["."], &["scenes"], &["scenes", "scenes/up"]] {
        assert_eq!(stdout(&run(&[&["test", "--list"], paths].concat())), names, "{paths:?}");
    }
    assert_eq!(stdout(&run(&["test", "--list", "also"])), names.replace("scenes/", "also/"));
    assert_eq!(stderr(&run(&["check", "."])), "3 files checked, no mistakes\n");
    folder.write("shared/d.ron", "(objects: [Spere()])");
    assert!(stderr(&run(&["check", "."])).contains("┌─ scenes/linked/d.ron:1:12"));
}

#[test]
fn results_go_to_stdout_and_talk_to_stderr() {
    let generated = raytoy(&["generate", "scenes/table.ron"]);
    assert!(stdout(&generated).starts_with("// Generated from scenes/table.ron\n"));
    assert!(!stderr(&generated).contains("fn "));
    let wrong = raytoy(&["generate", "tests/cases/errors/scale_zero.ron"]);
    assert_eq!(stdout(&wrong), "");
    assert!(stderr(&wrong).contains("`scale` must not be 0") && stderr(&wrong).ends_with("2 errors\n"));
    assert!(!stderr(&wrong).contains('\u{1b}'), "no escape codes where there is no terminal");
    let checked = raytoy(&["check", "scenes/table.ron"]);
    assert_eq!(
        (stdout(&checked), stderr(&checked)),
        (String::new(), "scenes/table.ron: no mistakes\n".into())
    );
    let missing = raytoy(&["generate", "nothing.ron"]);
    assert_eq!(stderr(&missing), "raytoy: there is no file `nothing.ron`\n");
}

#[test]
fn generate_reads_stdin_and_writes_a_file() {
    let piped = with_input(&["generate", "-", "--live"], "(objects: [Sphere(radius: 2)])");
    assert!(stdout(&piped).contains("fn live(i: u32)"), "{}", stderr(&piped));
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("table.wgsl");
    let written = raytoy(&["generate", "scenes/table.ron", "-o", &file.to_string_lossy()]);
    assert_eq!(stdout(&written), "");
    let baked = std::fs::read_to_string(&file).expect("the file is there");
    assert_eq!(baked, stdout(&raytoy(&["generate", "scenes/table.ron"])));
}

#[test]
fn check_takes_folders_and_snippets() {
    let all = raytoy(&["check", "scenes", "textures", "shaders/shapes"]);
    let count = files("scenes", "ron").len()
        + files("textures", "wgsl").len()
        + files("shaders/shapes", "wgsl").len();
    assert_eq!(stderr(&all), format!("{count} files checked, no mistakes\n"));
    let snippets = raytoy(&["check", "tests/cases/errors/snippets"]);
    assert_eq!(snippets.status.code(), Some(1));
    let said = stderr(&snippets);
    assert!(
        said.contains("textures/syntax_error.wgsl:6:5") && said.contains("files have mistakes"),
        "{said}"
    );
}

#[test]
fn files_with_odd_names_are_told_not_fatal() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    std::fs::create_dir(folder.path().join("textures")).expect("it is writable");
    for stem in ["ärger", "a__b", "_", "my-texture", "2d"] {
        let file = folder.path().join("textures").join(format!("{stem}.wgsl"));
        std::fs::write(file, "fn f() {}\n").expect("it is writable");
    }
    for arguments in [&["textures"][..], &["check", "."], &["textures", "Ärger"], &["textures", ""]] {
        let done = command(arguments).current_dir(folder.path()).output().expect("raytoy runs");
        assert!(matches!(done.status.code(), Some(0..=2)), "{arguments:?}: {}", stderr(&done));
    }
}

#[test]
fn lists_tell_all_names_and_all_about_one() {
    for (command, folder) in [("textures", "textures"), ("shapes", "shaders/shapes")] {
        let list = stdout(&raytoy(&[command]));
        let (of_files, own) = list.split_once("\n\n").expect("raytoy's own come last");
        assert_eq!(of_files.lines().count(), files(folder, "wgsl").len(), "{list}");
        assert_eq!(own.lines().count(), 4, "{own}");
        let bare = of_files.lines().filter(|line| line.split_whitespace().count() < 3);
        expect_none(bare.map(|line| format!("{command}: a line without a caption: {line}")));
    }
    let brick = stdout(&raytoy(&["textures", "Brick"]));
    assert!(brick.starts_with("Brick: ") && brick.contains("textures/brick.wgsl"), "{brick}");
    for parameter in ["scale", "mortar", "clay", "joint", "at"] {
        assert!(brick.contains(&format!("\n  {parameter}")), "{parameter}: {brick}");
    }
    let torus = stdout(&raytoy(&["shapes", "Torus"]));
    assert!(torus.contains("major_radius = 1") && !torus.contains("mapping"), "{torus}");
}

#[test]
fn an_unknown_name_gets_the_nearest() {
    let unknown = raytoy(&["textures", "Brik"]);
    assert_eq!(unknown.status.code(), Some(2));
    assert_eq!(stderr(&unknown), "raytoy: there is no texture `Brik`; did you mean `Brick`?\n");
    assert!(stderr(&raytoy(&["shapes", "Zzzzzzzzzz"])).contains("`raytoy shapes` lists them"));
}

#[test]
fn help_is_as_its_goldens_say() {
    let commands = [
        "",
        "view",
        "render",
        "scene",
        "check",
        "test",
        "diff",
        "generate",
        "textures",
        "shapes",
        "completions",
    ];
    expect_none(commands.into_iter().filter_map(|command| {
        let (arguments, golden) = match command {
            "" => (vec!["--help"], "tests/cases/help/raytoy.txt".to_owned()),
            command => (vec![command, "--help"], format!("tests/cases/help/{command}.txt")),
        };
        check_text(&golden, &stdout(&raytoy(&arguments))).err()
    }));
}

#[test]
fn wrong_views_are_told() {
    let mut told = String::new();
    for call in [
        "--split heat",
        "--split-at 0.3",
        "--split normal --split-at 1.5",
        "--value pattern",
        "--view value --reach 0",
    ] {
        let head = ["render", "scenes/table.ron", "-o", "a.png"];
        let done = raytoy(&[&head, &call.split(' ').collect::<Vec<_>>()[..]].concat());
        assert_eq!((done.status.code(), done.stdout.len()), (Some(2), 0), "{call}");
        told += &format!("$ raytoy render scenes/table.ron -o a.png {call}\n{}\n", stderr(&done));
    }
    check_text("tests/cases/help/wrong_views.txt", &told).unwrap_or_else(|difference| panic!("{difference}"));
}

#[test]
fn numbers_that_no_picture_can_have_are_refused_with_their_limits() {
    for (option, limit) in [
        (&["--time", "NaN"][..], "from -1000000 to 1000000"),
        (&["--time", "inf"], "from -1000000 to 1000000"),
        (&["--time=-1e30"], "from -1000000 to 1000000"),
        (&["--frames", "0..2", "--fps", "NaN"], "from 0.01 to 1000"),
        (&["--frames", "0..2", "--fps", "0"], "from 0.01 to 1000"),
        (&["--frames", "5..3"], "such as 0..120"),
        (&["--frames", "0..4000000000", "--fps", "1"], "the latest time is 1000000"),
        (&["--reach", "NaN"], "from 0.000001 to 1000000"),
        (&["--split", "normal", "--split-at", "NaN"], "from 0, the left edge, to 1"),
        (&["--samples", "0"], "1..=65536"),
        (&["--samples", "-1"], "'-1'"),
    ] {
        let refused = raytoy(&[&["render", "scenes/table.ron", "-o", "a###.png"], option].concat());
        assert_eq!(refused.status.code(), Some(2), "{option:?}");
        assert!(stderr(&refused).contains(limit), "{option:?}: {}", stderr(&refused));
    }
}

#[test]
fn completions_are_for_the_shell_that_is_asked_for() {
    let bash = stdout(&raytoy(&["completions", "bash"]));
    assert!(bash.contains("_raytoy()") && bash.contains("generate"));
    assert_eq!(raytoy(&["completions", "tcl"]).status.code(), Some(2));
}

/// The text at standard output.
fn stdout(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).replace("raytoy.exe", "raytoy")
}
