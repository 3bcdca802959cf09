//! Which files a scene may name: those below its root, and only what is a file. Nothing else is opened.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use raytoy::assets::Model;
use raytoy::compile;
use raytoy::library::Library;
use raytoy::sources::{Disk, Sources};
use raytoy::wgsl::Mode;
use tempfile::TempDir;

/// A file that is no model: whoever reads it shows this line.
const SECRET: &str = "secret words\n";
const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// A project with `scenes/`, `scenes/models/` and `textures/`, and a folder beside it.
struct World {
    home: TempDir,
}

impl World {
    fn new() -> Self {
        let world = Self { home: TempDir::new().expect("there is room for a folder") };
        for folder in ["project/scenes/models", "project/textures", "elsewhere"] {
            fs::create_dir_all(world.path(folder)).expect("the folder is writable");
        }
        world.write("project/scenes/models/a.obj", TRIANGLE);
        world.write("elsewhere/a.obj", TRIANGLE);
        world.write("elsewhere/secret.obj", SECRET);
        world
    }

    fn path(&self, name: &str) -> PathBuf {
        let home = self.home.path().canonicalize().expect("it is there");
        home.join(name)
    }

    fn write(&self, name: &str, text: &str) {
        fs::write(self.path(name), text).expect("the folder is writable");
    }

    /// What `project/scenes/a.ron` with a model in `file` is told, where raytoy runs in `project`.
    fn told(&self, file: &str, root: Option<&str>) -> String {
        let scene = self.path("project/scenes/a.ron");
        fs::write(&scene, format!("(objects: [\n    Mesh(file: {file:?}),\n])")).expect("it is writable");
        let disk =
            Disk { here: self.path("project"), named_root: root.map(|root| self.path("project").join(root)) };
        compile(&disk.sources(), Path::new("scenes/a.ron"), Mode::Baked, None).report.to_string()
    }
}

#[test]
fn a_file_lies_below_the_root_whatever_its_name_looks_like() {
    let world = World::new();
    let absolute = |name: &str| world.path(name).to_string_lossy().replace('\\', "/");
    world.write("project/scenes/b.obj", TRIANGLE);
    for right in ["models/a.obj", "b.obj", "../scenes/b.obj", "./models/../b.obj"] {
        assert_eq!(world.told(right, None), "", "{right}");
    }
    for outside in [
        "../../elsewhere/secret.obj",
        "../../../../../../../../../../etc/passwd",
        "models/../../../elsewhere/secret.obj",
        &absolute("elsewhere/secret.obj"),
        "/etc/passwd",
        "//server/share/a.obj",
        "C:/a.obj",
    ] {
        let told = world.told(outside, None);
        assert!(
            told.starts_with("error: this file is outside of the scene's root folder\n"),
            "{outside}: {told}"
        );
        assert!(told.contains("scenes/a.ron:2:16"), "{outside}: {told}");
        assert!(told.contains("the root folder is the current folder; `--root FOLDER`"), "{told}");
        assert!(!told.contains("secret words"), "{told}");
    }
    let told = world.told(r"models\a.obj", None);
    assert!(told.contains("write `/` on all systems: `models/a.obj`"), "{told}");
    assert!(world.told("models", None).contains("cannot read `scenes/models`: it is a folder"));
}

#[test]
fn a_named_root_widens_what_a_scene_may_name() {
    let world = World::new();
    assert_eq!(world.told("../../elsewhere/a.obj", Some("..")), "");
    assert!(world.told("../../elsewhere/a.obj", Some(".")).contains("outside of the scene's root"));
    // A narrower one narrows it, and what names are looked up in.
    world.write("project/textures/own.wgsl", "fn own(at: Surface) -> f32 { return 1.0; }");
    let scene = "(objects: [Sphere(material: (color: Own()))])";
    let told = |root: &str| {
        let disk = Disk { here: world.path("project"), named_root: Some(world.path("project").join(root)) };
        let sources = disk.sources().with("scenes/b.ron", scene);
        compile(&sources, Path::new("scenes/b.ron"), Mode::Baked, None).report.to_string()
    };
    assert_eq!(told(".."), "");
    assert!(told("scenes").contains("there is no texture `Own`"), "{}", told("scenes"));
}

#[test]
fn a_scene_that_lies_elsewhere_has_its_own_folder_as_root() {
    let world = World::new();
    world.write("elsewhere/own.ron", r#"(objects: [Mesh(file: "a.obj")])"#);
    world.write("elsewhere/other.ron", r#"(objects: [Mesh(file: "../project/scenes/models/a.obj")])"#);
    let sources = || Sources::on_disk(&world.path("project"));
    let told = |name| compile(&sources(), &world.path(name), Mode::Baked, None).report.to_string();
    assert_eq!(told("elsewhere/own.ron"), "");
    let folder = world.path("elsewhere").to_string_lossy().replace('\\', "/");
    assert!(told("elsewhere/other.ron").contains(&format!("the root folder is `{folder}`;")));
}

#[cfg(unix)]
#[test]
fn links_count_by_where_they_lead() {
    use std::os::unix::fs::symlink;
    let world = World::new();
    let link = |to: &str, at: &str| symlink(to, world.path(at)).expect("the folder is writable");
    link("models/a.obj", "project/scenes/inside.obj");
    link("../../elsewhere/secret.obj", "project/scenes/outside.obj");
    link("../../elsewhere", "project/scenes/folder");
    link("circle.obj", "project/scenes/circle.obj");
    link("nothing.obj", "project/scenes/dangling.obj");
    link("/dev/zero", "project/scenes/zero.obj");
    link("../../elsewhere/own.wgsl", "project/textures/own.wgsl");
    world.write("elsewhere/own.wgsl", SECRET);
    assert_eq!(world.told("inside.obj", None), "");
    for file in ["outside.obj", "folder/secret.obj", "zero.obj"] {
        let told = world.told(file, None);
        let why = format!("error: `scenes/{file}` is a link to a file outside of the scene's root folder\n");
        assert!(told.starts_with(&why) && !told.contains("secret words"), "{told}");
    }
    assert!(world.told("circle.obj", None).contains("cannot read `scenes/circle.obj`"));
    assert!(world.told("dangling.obj", None).contains("there is no file `scenes/dangling.obj`"));
    assert_eq!(world.told("folder/a.obj", Some("..")), "");
    let sources = Sources::on_disk(&world.path("project"))
        .with("scenes/b.ron", "(objects: [Sphere(material: (color: Own()))])");
    let told = compile(&sources, Path::new("scenes/b.ron"), Mode::Baked, None).report.to_string();
    assert!(told.contains("`textures/own.wgsl` is a link to a file outside"), "{told}");
    assert!(told.contains("scenes/b.ron:1:37") && !told.contains("secret words"), "{told}");
}

#[cfg(unix)]
#[test]
fn pipes_devices_and_huge_files_are_refused_at_once() {
    let world = World::new();
    let pipe = |name: &str| {
        let made = Command::new("mkfifo").arg(world.path(name)).status().expect("mkfifo is there");
        assert!(made.success());
    };
    let huge = |name: &str, bytes: u64| {
        let file = fs::File::create(world.path(name)).expect("the folder is writable");
        file.set_len(bytes).expect("a file with nothing in it takes no room");
    };
    pipe("project/scenes/pipe.obj");
    pipe("project/scenes/pipe.ron");
    pipe("project/textures/pipe.wgsl");
    huge("project/scenes/huge.obj", (1 << 30) + 1);
    huge("project/scenes/huge.ron", (16 << 20) + 1);
    let no_file = "it is a pipe or a device, not a file";
    assert!(world.told("pipe.obj", None).contains(no_file));
    assert!(world.told("huge.obj", None).contains("it is larger than 1024 MiB"));
    let sources = || Sources::on_disk(&world.path("project"));
    let told = |name: &str| compile(&sources(), Path::new(name), Mode::Baked, None).report.to_string();
    assert!(told("scenes/pipe.ron").contains(no_file));
    assert!(told("scenes/huge.ron").contains("it is larger than 16 MiB"));
    let sources = sources().with("scenes/b.ron", "(objects: [Sphere(material: (color: Pipe()))])");
    let told = compile(&sources, Path::new("scenes/b.ron"), Mode::Baked, None).report.to_string();
    assert!(told.contains("`textures/pipe.wgsl`") && told.contains(no_file), "{told}");
}

#[test]
fn each_command_that_takes_a_scene_takes_its_root() {
    let world = World::new();
    world.write("project/scenes/a.ron", r#"(objects: [Mesh(file: "../../elsewhere/a.obj")])"#);
    let raytoy = |arguments: &[&str]| -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_raytoy"));
        command.current_dir(world.path("project")).args(arguments);
        command.output().expect("raytoy starts")
    };
    for call in [
        &["check", "scenes/a.ron"][..],
        &["check", "scenes"],
        &["generate", "scenes/a.ron"],
        &["diff", "scenes/a.ron", "scenes/a.ron", "--no-picture"],
    ] {
        let code = |root: &[&str]| raytoy(&[call, root].concat()).status.code();
        assert_eq!([code(&[]), code(&["--root", ".."])], [Some(1), Some(0)], "{call:?}");
        assert_eq!(code(&["--root", "nowhere"]), Some(2), "{call:?}");
        assert_eq!(code(&["--root", "../elsewhere"]), Some(2), "{call:?}");
    }
    let refused = raytoy(&["check", "scenes/a.ron", "--root", "../elsewhere"]);
    let told = String::from_utf8_lossy(&refused.stderr);
    assert_eq!(told, "raytoy: `scenes/a.ron` is outside of the root folder `../elsewhere`\n");
}

#[test]
fn the_files_that_are_offered_are_those_that_a_scene_may_name() {
    let world = World::new();
    for folder in ["project/scenes/deep/er/est/still", "project/.git", "project/models"] {
        fs::create_dir_all(world.path(folder)).expect("the folder is writable");
    }
    for file in ["models/c.OBJ", "scenes/deep/er/est/d.obj", "scenes/deep/er/est/still/e.obj", ".git/f.obj"] {
        world.write(&format!("project/{file}"), TRIANGLE);
    }
    let offered = |root: Option<&str>, scene: &str| {
        let disk = Disk {
            here: world.path("project"),
            named_root: root.map(|root| world.path("project").join(root)),
        };
        Library::new(&disk.sources(), Path::new(scene)).files(Model::EXTENSIONS)
    };
    let near = ["models/a.obj", "../models/c.OBJ", "deep/er/est/d.obj"];
    assert_eq!(offered(None, "scenes"), near);
    for file in near {
        assert_eq!(world.told(file, None), "", "{file}");
    }
    let wide = offered(Some(".."), "scenes");
    assert!(wide.contains(&"../../elsewhere/a.obj".into()), "{wide:?}");
    assert_eq!(world.told("../../elsewhere/a.obj", Some("..")), "");
    assert_eq!(offered(None, ""), ["models/c.OBJ", "scenes/models/a.obj"]);
}
