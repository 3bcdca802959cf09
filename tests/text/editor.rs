//! The command that opens an editor at a line.

use std::path::Path;

use raytoy::panel::editor::{DESKTOP, command, found};

#[test]
fn each_editor_is_told_the_line_in_its_own_way() {
    let told = |editor: &str| command(editor, "xterm", "a b.ron".as_ref(), 7).join(" | ");
    assert_eq!(told("code --wait"), "code | --wait | -g | a b.ron:7");
    assert_eq!(told("/usr/bin/vim"), "xterm | -e | /usr/bin/vim | +7 | a b.ron");
    assert_eq!(told("subl"), "subl | a b.ron:7");
    assert_eq!(told("kate"), "kate | --line | 7 | a b.ron");
    assert_eq!(told("gedit"), "gedit | +7 | a b.ron");
}

#[test]
fn where_none_is_named_one_that_is_there_is_taken_and_then_the_desktop_s() {
    let home = tempfile::TempDir::new().expect("there is room for a folder");
    let [first, second] = ["first", "second"].map(|name| home.path().join(name));
    let ending = if cfg!(windows) { ".exe" } else { "" };
    let put = |folder: &Path, program: &str| {
        std::fs::create_dir_all(folder).expect("the folder is writable");
        std::fs::write(folder.join(format!("{program}{ending}")), "").expect("the folder is writable");
    };
    let path = std::env::join_paths([&first, &second]).expect("their names are plain");
    let opens = || {
        let words = found(&path, "a.ron".as_ref(), 7)?;
        let name = Path::new(&words[0]).file_stem()?.to_string_lossy().into_owned();
        Some(format!("{name} {}", words[1..].join(" ")))
    };
    assert_eq!(opens(), None);
    put(&second, DESKTOP[0]);
    let desktop = [DESKTOP, &["a.ron"]].concat().join(" ");
    assert_eq!(opens(), Some(desktop));
    put(&first, "gedit");
    assert_eq!(opens().as_deref(), Some("gedit +7 a.ron"));
    put(&second, "code");
    assert_eq!(opens().as_deref(), Some("code -g a.ron:7"));
    assert_eq!(found("".as_ref(), "a.ron".as_ref(), 7), None);
}
