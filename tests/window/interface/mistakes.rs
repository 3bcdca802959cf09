//! Mistakes and warnings over the picture, and the editor that opens at their lines.

use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};
use std::{env, fs, thread};

use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{AccessKitNode, NodeT, Queryable};
use tempfile::TempDir;

use super::SCENE;
use super::harness::Studio;

const WRONG: &str = "(
    objects: [
        Spere(radius: 1),
        Box(scale: (1, 2)),
    ],
)
";

/// Where the editor of the process writes what it is asked for; not set where there is no such editor.
const TOLD: &str = "RAYTOY_TEST_EDITOR";
/// So long a process may take until the editor was there.
const PATIENCE: Duration = Duration::from_secs(60);

/// What the file at `path` says, once it says something.
fn told(path: &Path) -> String {
    let until = Instant::now() + PATIENCE;
    loop {
        match fs::read_to_string(path) {
            Ok(text) if text.ends_with('\n') => return text,
            _ => assert!(Instant::now() < until, "the editor was not opened"),
        }
        thread::yield_now();
    }
}

/// Runs the test `name` again in a process whose editor is a script that tells what it was asked for, or that has
/// no editor.
fn again(name: &str, has_editor: bool) {
    let home = TempDir::new().expect("there is room for a folder");
    let [script, told] = ["editor.sh", "told"].map(|name| home.path().join(name));
    fs::write(&script, format!("echo \"$@\" > '{0}.new'\nmv '{0}.new' '{0}'\n", told.display()))
        .expect("it is writable");
    let editor = if has_editor { format!("sh {}", script.display()) } else { String::new() };
    let mut process = Command::new(env::current_exe().expect("it runs"));
    if !has_editor {
        process.env("PATH", home.path());
    }
    process.args([name, "--exact"]).env(TOLD, &told).env("VISUAL", editor).env_remove("EDITOR");
    let output = process.output().expect("it can run again");
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success() && said.contains("1 passed"), "{said}");
}

#[test]
fn mistakes_are_told_over_the_last_good_picture_until_they_are_mended() {
    let mut studio = Studio::open(SCENE);
    assert!(!studio.has(Role::Alert, "mistakes"));
    studio.save(WRONG);
    assert!(studio.has(Role::Alert, "mistakes"));
    for words in [
        "The scene has mistakes. The picture is from its last correct version.",
        "there is no shape `Spere`",
        "did you mean `Sphere`?",
        "3 │         Spere(radius: 1),",
    ] {
        assert!(studio.says(words), "{words}");
    }
    // Its values can be seen all the same, and the picture is the one before.
    assert!(studio.has(Role::TreeItem, "Box 1"));
    assert_eq!(studio.shown_radius(), 1.0);
    studio.save(&SCENE.replace("radius: 1 /*", "radius: 2 /*"));
    assert!(!studio.has(Role::Alert, "mistakes"));
    assert_eq!(studio.shown_radius(), 2.0);
}

#[test]
fn warnings_are_told_and_the_picture_is_the_new_one() {
    let own = "/// Mine.\nfn checker(at: Surface) -> f32 {\n    return fract(at.position.x);\n}\n";
    let scene = "(objects: [Sphere(radius: 2 , material: (color: Checker()))])\n";
    let files = [("scene.ron", scene), ("textures/checker.wgsl", own)];
    let studio = Studio::open_among(&files, Default::default());
    assert!(studio.has(Role::Alert, "mistakes"));
    assert!(studio.says("The scene has warnings.") && !studio.says("The scene has mistakes."));
    assert_eq!(studio.shown_radius(), 2.0);
}

#[test]
fn an_edit_that_breaks_the_scene_can_be_undone() {
    let mut studio = Studio::open(SCENE);
    studio.choose("both");
    studio.fill(Role::TextInput, "name", "ball");
    assert!(studio.has(Role::Alert, "mistakes") && studio.says("ball"));
    studio.key(Modifiers::COMMAND, Key::Z);
    assert!(!studio.has(Role::Alert, "mistakes"));
    assert_eq!(studio.text(), SCENE);
}

#[test]
#[cfg(unix)]
fn a_click_on_a_mistake_opens_its_line() {
    let Some(file) = env::var_os(TOLD) else {
        return again("interface::mistakes::a_click_on_a_mistake_opens_its_line", true);
    };
    let mut studio = Studio::open(SCENE);
    studio.save(WRONG);
    let links = studio.harness.get_all_by_role(Role::Link).filter_map(|link| link.accesskit_node().label());
    let lines: Vec<String> = links.filter_map(|name| Some(name.rsplit_once(':')?.1.to_owned())).collect();
    assert_eq!(lines, ["3", "4"], "one for each mistake");
    let link = studio.harness.get_by(|own| own.label().is_some_and(|name| name.ends_with("scene.ron:4")));
    link.click();
    studio.leave();
    assert_eq!(told(file.as_ref()).trim(), format!("+4 {}", studio.scene.display()));
}

#[test]
fn without_an_editor_it_is_told_how_to_name_one() {
    if env::var_os(TOLD).is_none() {
        return again("interface::mistakes::without_an_editor_it_is_told_how_to_name_one", false);
    }
    let mut studio = Studio::open(WRONG);
    studio.harness.get_by(|own| own.label().is_some_and(|name| name.ends_with("scene.ron:3"))).click();
    studio.leave();
    assert!(studio.says("set VISUAL or EDITOR to your editor, such as `code` or `vim`"));
    let alert = studio.find(Role::Alert, "mistakes");
    assert!(studio.lines(&alert).iter().any(|line| line.contains("set VISUAL")), "it stands beside the link");
}

#[test]
#[cfg(unix)]
fn a_new_texture_is_written_and_opened() {
    let Some(file) = env::var_os(TOLD) else {
        return again("interface::mistakes::a_new_texture_is_written_and_opened", true);
    };
    let mut studio = Studio::open(SCENE);
    studio.key(Modifiers::COMMAND | Modifiers::SHIFT, Key::N);
    let texture = studio.home.path().join("textures/my_texture.wgsl");
    assert!(texture.is_file() && studio.says("use it in scenes as MyTexture()"));
    assert_eq!(told(file.as_ref()).trim(), format!("+1 {}", texture.display()));
}

#[test]
fn each_mistake_is_a_card_with_its_help_in_sight_in_a_small_window_too() {
    let mut studio = Studio::open(SCENE);
    studio.harness.set_size(egui::vec2(800.0, 600.0));
    studio.save("(objects: [Spere(radius: 1), Box(scale: (1, 2)), Sphere(radios: 2)])");
    let said = |words: &'static str| {
        let says_it =
            move |own: &AccessKitNode<'_>| own.role() == Role::Label && own.value().as_deref() == Some(words);
        studio.harness.get_by(says_it).rect()
    };
    let heading = said("The scene has mistakes. The picture is from its last correct version.");
    let (first, last) = (said("help: did you mean `Sphere`?"), said("help: did you mean `radius`?"));
    assert!(heading.top() > 150.0 && first.top() > heading.bottom() && first.bottom() < 600.0, "{heading:?}");
    assert!(last.bottom() - heading.top() > 200.0 && last.right() < 480.0, "{last:?} is wrapped");
}
