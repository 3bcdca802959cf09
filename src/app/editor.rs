//! The author's own editor, opened at a line.

use std::path::Path;
use std::process::{Command, Stdio};

/// How an editor is told a line.
enum Way {
    /// `editor FILE:LINE`
    Joined,
    /// `editor -g FILE:LINE`
    Goto,
    /// `editor +LINE FILE`
    Plus,
}

/// Editors that run in a terminal, and so need one.
const IN_TERMINAL: [&str; 10] = ["vi", "vim", "nvim", "nano", "hx", "helix", "kak", "micro", "ne", "joe"];

/// Opens `file` at `line`, counted from 1, in the editor that `VISUAL` or `EDITOR` names.
///
/// # Errors
/// What to tell the author.
pub fn open(file: &Path, line: usize) -> Result<(), String> {
    let set = |name: &str| std::env::var(name).ok().filter(|value| !value.trim().is_empty());
    let editor = set("VISUAL").or_else(|| set("EDITOR"));
    let editor = editor.ok_or("set VISUAL or EDITOR to your editor, such as `code` or `vim`")?;
    let terminal = set("TERMINAL").unwrap_or_else(|| "x-terminal-emulator".into());
    let words = command(&editor, &terminal, file, line);
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
    let file = file.to_string_lossy();
    let way = match program.as_str() {
        "code" | "code-insiders" | "codium" | "cursor" => Way::Goto,
        "subl" | "zed" | "zeditor" | "hx" | "helix" | "lapce" => Way::Joined,
        _ => Way::Plus,
    };
    match way {
        Way::Joined => words.push(format!("{file}:{line}")),
        Way::Goto => words.extend(["-g".into(), format!("{file}:{line}")]),
        Way::Plus => words.extend([format!("+{line}"), file.into_owned()]),
    }
    if IN_TERMINAL.contains(&program.as_str()) {
        words.splice(0..0, [terminal.to_owned(), "-e".into()]);
    }
    words
}

#[cfg(test)]
mod tests {
    use super::command;

    #[test]
    fn each_editor_is_told_the_line_in_its_own_way() {
        let told = |editor: &str| command(editor, "xterm", "a b.ron".as_ref(), 7).join(" | ");
        assert_eq!(told("code --wait"), "code | --wait | -g | a b.ron:7");
        assert_eq!(told("/usr/bin/vim"), "xterm | -e | /usr/bin/vim | +7 | a b.ron");
        assert_eq!(told("subl"), "subl | a b.ron:7");
        assert_eq!(told("gedit"), "gedit | +7 | a b.ron");
    }
}
