//! The table of the window's commands, and the files that two of them write.

use std::fs;
use std::path::Path;

use raytoy::compile;
use raytoy::panel::{COMMANDS, new_scene, new_texture};

use raytoy::sources::{Disk, Sources};
use raytoy::wgsl::Mode;
use tempfile::TempDir;

/// What occurs more than once.
fn doubled<T: PartialEq + Copy>(items: &[T]) -> Vec<T> {
    let is_doubled = |(i, item): &(usize, &T)| items[..*i].contains(item);
    items.iter().enumerate().filter(is_doubled).map(|(_, item)| *item).collect()
}

#[test]
fn each_command_is_there_once_under_a_name_of_its_own() {
    assert_eq!(doubled(&COMMANDS.map(|entry| entry.command)), []);
    assert_eq!(doubled(&COMMANDS.map(|entry| entry.name)), Vec::<&str>::new());
    for entry in &COMMANDS {
        assert!(!entry.name.is_empty() && !entry.does.is_empty() && !entry.keys.is_empty(), "{entry:?}");
        // Tooltips and palette show it in one line.
        assert!(entry.does.len() <= 66 && !entry.does.ends_with('.'), "{entry:?}");
    }
}

#[test]
fn no_key_means_two_commands() {
    let keys: Vec<_> = COMMANDS.iter().flat_map(|entry| entry.keys).copied().collect();
    assert_eq!(doubled(&keys), []);
}

#[test]
fn commands_of_a_group_stand_together() {
    let mut groups = COMMANDS.map(|entry| entry.group).to_vec();
    groups.dedup();
    assert_eq!(doubled(&groups), Vec::<&str>::new());
}

/// What is wrong with the scene at `path`, warnings too.
fn mistakes(home: &Path, path: &Path) -> String {
    compile(&Sources::on_disk(home), path, Mode::Baked, None).report.to_string()
}

#[test]
fn a_new_scene_is_right_and_takes_nothings_place() {
    let home = TempDir::new().expect("there is room for a folder");
    let open = home.path().join("open.ron");
    let first = new_scene(&open).expect("the folder is writable");
    assert_eq!(first, home.path().join("untitled.ron"));
    assert_eq!(mistakes(home.path(), &first), "");
    fs::write(&first, "mine").expect("the folder is writable");
    let second = new_scene(&open).expect("the folder is writable");
    assert_eq!(second, home.path().join("untitled2.ron"));
    assert_eq!(mistakes(home.path(), &second), "");
    assert_eq!(fs::read_to_string(&first).expect("it is there"), "mine");
}

/// The disk of a raytoy that runs in `home`.
fn disk(home: &TempDir) -> Disk {
    Disk { here: home.path().to_owned(), named_root: None }
}

#[test]
fn a_new_texture_works_under_the_name_that_is_told() {
    let home = TempDir::new().expect("there is room for a folder");
    let open = home.path().join("open.ron");
    for name in ["MyTexture", "MyTexture2", "MyTexture3"] {
        let texture = new_texture(&disk(&home), &open).expect("the folder is writable");
        assert_eq!(texture.name, name);
        assert_eq!(texture.path.parent(), Some(home.path().join("textures").as_path()));
    }
    // All of them in one scene: no function of one is in the way of another's.
    let scene =
        "(objects: [Plane(material: (color: MyTexture(light: MyTexture2(bend: 2), dark: MyTexture3())))])";
    fs::write(&open, scene).expect("the folder is writable");
    assert_eq!(mistakes(home.path(), &open), "");
}

#[test]
fn a_new_texture_goes_where_the_project_has_its_textures() {
    let home = TempDir::new().expect("there is room for a folder");
    let [ours, scenes] = ["textures", "scenes"].map(|folder| home.path().join(folder));
    for folder in [&ours, &scenes] {
        fs::create_dir(folder).expect("the folder is writable");
    }
    let open = scenes.join("open.ron");
    let texture = new_texture(&disk(&home), &open).expect("the folder is writable");
    assert_eq!((texture.path.parent(), texture.name.as_str()), (Some(ours.as_path()), "MyTexture"));
    // Nearer ones come first, and no two are called the same.
    let nearer = scenes.join("textures");
    fs::create_dir(&nearer).expect("the folder is writable");
    let texture = new_texture(&disk(&home), &open).expect("the folder is writable");
    assert_eq!((texture.path.parent(), texture.name.as_str()), (Some(nearer.as_path()), "MyTexture2"));
}

#[test]
fn where_nothing_can_be_written_the_reason_is_told() {
    let home = TempDir::new().expect("there is room for a folder");
    let open = home.path().join("missing/open.ron");
    assert!(new_scene(&open).is_err());
    fs::write(home.path().join("textures"), "a file").expect("the folder is writable");
    assert!(new_texture(&disk(&home), &home.path().join("open.ron")).is_err());
}
