//! The author's own editor, opened at a line: the one that is named, else one that is there.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// How an editor is told a line.
enum Way {
    /// `editor FILE:LINE`
    Joined,
    /// `editor -g FILE:LINE`
    Goto,
    /// `editor +LINE FILE`
    Plus,
    /// `editor --line LINE FILE`
    Line,
}

/// Editors that run in a terminal, and so need one.
const IN_TERMINAL: [&str; 10] = ["vi", "vim", "nvim", "nano", "hx", "helix", "kak", "micro", "ne", "joe"];

/// Editors with a window, of which the first that is there opens the file where none is named.
const WITH_WINDOW: [&str; 10] =
    ["code", "code-insiders", "codium", "cursor", "zed", "zeditor", "subl", "kate", "gedit", "xed"];

/// What opens a file as a double click does; it knows no lines.
const DESKTOP: &[&str] = if cfg!(windows) {
    &["explorer"]
} else if cfg!(target_os = "macos") {
    &["open", "-t"]
} else {
    &["xdg-open"]
};

/// Opens `file` at `line`, counted from 1, in the editor that `VISUAL` or `EDITOR` names, or in another one.
///
/// # Errors
/// What to tell the author.
pub fn open(file: &Path, line: usize) -> Result<(), String> {
    let set = |name: &str| std::env::var(name).ok().filter(|value| !value.trim().is_empty());
    let named = set("VISUAL").or_else(|| set("EDITOR"));
    let terminal = set("TERMINAL").unwrap_or_else(|| "x-terminal-emulator".into());
    let path = std::env::var_os("PATH").unwrap_or_default();
    let words = match named {
        Some(editor) => command(&editor, &terminal, file, line),
        None => found(&path, file, line)
            .ok_or("no editor was found: set VISUAL or EDITOR to your editor, such as `code` or `vim`")?,
    };
    let spawned = Command::new(&words[0])
        .args(&words[1..])
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn();
    let mut child = spawned.map_err(|error| format!("cannot start `{}`: {error}", words[0]))?;
    // Somebody has to wait for it, or it stays behind as a zombie.
    std::thread::spawn(move || child.wait());
    Ok(())
}

/// The program and its arguments.
fn command(editor: &str, terminal: &str, file: &Path, line: usize) -> Vec<String> {
    let mut words: Vec<String> = editor.split_whitespace().map(str::to_owned).collect();
    let program = Path::new(&words[0]).file_stem().unwrap_or_default().to_string_lossy().into_owned();
    words.extend(told(&program, file, line));
    if IN_TERMINAL.contains(&program.as_str()) {
        words.splice(0..0, [terminal.to_owned(), "-e".into()]);
    }
    words
}

/// The arguments by which an editor is told a file and a line.
fn told(program: &str, file: &Path, line: usize) -> Vec<String> {
    let file = file.to_string_lossy();
    let way = match program {
        "code" | "code-insiders" | "codium" | "cursor" => Way::Goto,
        "subl" | "zed" | "zeditor" | "hx" | "helix" | "lapce" => Way::Joined,
        "kate" => Way::Line,
        _ => Way::Plus,
    };
    match way {
        Way::Joined => vec![format!("{file}:{line}")],
        Way::Goto => vec!["-g".into(), format!("{file}:{line}")],
        Way::Plus => vec![format!("+{line}"), file.into_owned()],
        Way::Line => vec!["--line".into(), line.to_string(), file.into_owned()],
    }
}

/// The same for the first editor in the folders of `path`, or for what the desktop opens files with.
fn found(path: &OsStr, file: &Path, line: usize) -> Option<Vec<String>> {
    let place = |program: &str| Some(program_in(path, program)?.to_string_lossy().into_owned());
    let with_window = WITH_WINDOW
        .iter()
        .find_map(|program| Some([vec![place(program)?], told(program, file, line)].concat()));
    with_window.or_else(|| {
        let (program, arguments) = DESKTOP.split_first()?;
        let arguments = arguments.iter().map(|word| (*word).to_owned());
        let file = file.to_string_lossy().into_owned();
        Some([place(program)?].into_iter().chain(arguments).chain([file]).collect())
    })
}

/// Where a program lies.
fn program_in(path: &OsStr, program: &str) -> Option<PathBuf> {
    let endings: &[&str] = if cfg!(windows) { &[".exe", ".cmd", ".bat"] } else { &[""] };
    let folders = std::env::split_paths(path).filter(|folder| !folder.as_os_str().is_empty());
    let mut all =
        folders.flat_map(|folder| endings.iter().map(move |e| folder.join(format!("{program}{e}"))));
    all.find(|file| file.is_file())
}

#[cfg(test)]
mod tests {
    use super::*;

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
}
