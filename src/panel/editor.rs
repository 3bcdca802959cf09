//! The author's own editor, opened at a line: the one that is named, else one that is there.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The form in which an editor takes a line.
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
pub const DESKTOP: &[&str] = if cfg!(windows) {
    &["explorer"]
} else if cfg!(target_os = "macos") {
    &["open", "-t"]
} else {
    &["xdg-open"]
};

/// Opens `file` at `line`, counted from 1, in the editor that `VISUAL` or `EDITOR` names, or in another one.
///
/// # Errors
/// The message for the author.
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
pub fn command(editor: &str, terminal: &str, file: &Path, line: usize) -> Vec<String> {
    let mut words: Vec<String> = editor.split_whitespace().map(str::to_owned).collect();
    let program = Path::new(&words[0]).file_stem().unwrap_or_default().to_string_lossy().into_owned();
    words.extend(told(&program, file, line));
    if IN_TERMINAL.contains(&program.as_str()) {
        words.splice(0..0, [terminal.to_owned(), "-e".into()]);
    }
    words
}

/// The arguments by which an editor opens a file at a line.
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

/// The program and its arguments, for the first editor in the folders of `path`, or for what the desktop
/// opens files with.
pub fn found(path: &OsStr, file: &Path, line: usize) -> Option<Vec<String>> {
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
