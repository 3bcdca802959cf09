//! All commands of the window: the table from which keys, tooltips and the rest are made.
//!
//! In: nothing. Out: [`COMMANDS`], and [`GESTURES`] for the hand on the mouse.

use egui::{Key, KeyboardShortcut, Modifiers};

/// A command of the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command {
    Gallery,
    NewScene,
    NewTexture,
    Undo,
    Redo,
    OnlyTry,
    Home,
    KeepView,
    Bookmark,
    ChooseNothing,
    OnlyThis,
    Gizmos,
    Handles,
    NextView,
    PreviousView,
    SplitView,
    Magnifier,
    SavePicture,
    Pause,
    StepBack,
    StepForward,
    Rewind,
    Palette,
    CheatSheet,
    Theme,
    Quit,
}

/// The description of a command, and how people give it.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    pub command: Command,
    /// What it is about.
    pub group: &'static str,
    pub name: &'static str,
    /// Tooltips show the first.
    pub keys: &'static [KeyboardShortcut],
    pub does: &'static str,
}

/// Every command once, group by group.
pub const COMMANDS: [Entry; 26] = [
    entry(
        Command::Gallery,
        "Scene",
        "Gallery",
        &[command(Key::O)],
        "show pictures of all scenes, textures and shapes",
    ),
    entry(
        Command::NewScene,
        "Scene",
        "New scene",
        &[command(Key::N)],
        "create a small scene in this folder and open it",
    ),
    entry(
        Command::NewTexture,
        "Scene",
        "New texture",
        &[command_shift(Key::N)],
        "create a texture file and open it in your editor",
    ),
    entry(Command::Undo, "Scene", "Undo", &[command(Key::Z)], "revert the last change"),
    entry(
        Command::Redo,
        "Scene",
        "Redo",
        &[command_shift(Key::Z), command(Key::Y)],
        "repeat the reverted change",
    ),
    entry(
        Command::OnlyTry,
        "Scene",
        "Only try",
        &[plain(Key::T)],
        "show changes without saving; switch off to save them",
    ),
    entry(
        Command::Home,
        "Camera",
        "Home",
        &[plain(Key::Home), plain(Key::H)],
        "return to the scene's camera",
    ),
    entry(Command::KeepView, "Camera", "Keep view", &[plain(Key::K)], "write this camera into the scene"),
    entry(
        Command::Bookmark,
        "Camera",
        "Bookmark",
        &[plain(Key::B)],
        "save this camera as the next free bookmark",
    ),
    entry(Command::ChooseNothing, "Picture", "Choose nothing", &[plain(Key::Escape)], "end the choice"),
    entry(
        Command::OnlyThis,
        "Picture",
        "Only this",
        &[plain(Key::F)],
        "show only the chosen object or material",
    ),
    entry(
        Command::Gizmos,
        "Picture",
        "Gizmos",
        &[plain(Key::G)],
        "show lights, the camera's target and bounds",
    ),
    entry(
        Command::Handles,
        "Picture",
        "Handles",
        &[plain(Key::M)],
        "show arrows that move the chosen object",
    ),
    entry(
        Command::NextView,
        "Picture",
        "Next view",
        &[plain(Key::V)],
        "show the next view: normals, depth and others",
    ),
    entry(Command::PreviousView, "Picture", "Previous view", &[shift(Key::V)], "show the previous view"),
    entry(
        Command::SplitView,
        "Picture",
        "Split view",
        &[plain(Key::S)],
        "show a second view beside this one",
    ),
    entry(
        Command::Magnifier,
        "Picture",
        "Magnifier",
        &[plain(Key::Z)],
        "show the pixels near the pointer eight times larger",
    ),
    entry(
        Command::SavePicture,
        "Picture",
        "Save picture",
        &[command(Key::E)],
        "save a PNG or EXR of any size, or a movie",
    ),
    entry(Command::Pause, "Time", "Pause", &[plain(Key::Space)], "stop or continue the time"),
    entry(
        Command::StepBack,
        "Time",
        "Step back",
        &[plain(Key::Comma)],
        "one frame of a sixtieth of a second",
    ),
    entry(
        Command::StepForward,
        "Time",
        "Step forward",
        &[plain(Key::Period)],
        "one frame of a sixtieth of a second",
    ),
    entry(Command::Rewind, "Time", "Rewind", &[plain(Key::Num0)], "return to time 0"),
    entry(
        Command::Palette,
        "Window",
        "Find a command",
        &[command(Key::P)],
        "find commands, views and scenes by name",
    ),
    entry(
        Command::CheatSheet,
        "Window",
        "Cheat sheet",
        &[plain(Key::F1), plain(Key::Questionmark)],
        "show all keys",
    ),
    entry(Command::Theme, "Window", "Light or dark", &[plain(Key::L)], "change the colors of the window"),
    entry(Command::Quit, "Window", "Quit", &[command(Key::Q)], "close the window"),
];

/// The keys of the digits 1 to 9, which stand for the bookmarks of a camera.
pub const DIGITS: [Key; 9] =
    [Key::Num1, Key::Num2, Key::Num3, Key::Num4, Key::Num5, Key::Num6, Key::Num7, Key::Num8, Key::Num9];

/// What the mouse does, and how.
pub const GESTURES: [(&str, &str); 9] = [
    ("Turn the camera", "drag"),
    ("Move the camera", "right drag, Shift drag"),
    ("Move it closer", "wheel"),
    ("Choose an object", "click"),
    ("Move the chosen object", "drag its arrows"),
    ("In steps of 0.1", "Ctrl drag"),
    ("Cancel a drag", "Escape"),
    ("Duplicate, remove", "right click in the tree"),
    ("Open a scene", "drop its file"),
];

impl Command {
    /// Its description for people.
    pub fn entry(self) -> &'static Entry {
        COMMANDS.iter().find(|entry| entry.command == self).expect("all are there")
    }
}

const fn entry(
    command: Command,
    group: &'static str,
    name: &'static str,
    keys: &'static [KeyboardShortcut],
    does: &'static str,
) -> Entry {
    Entry { command, group, name, keys, does }
}

const fn plain(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::NONE, key)
}

const fn shift(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::SHIFT, key)
}

const fn command(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::COMMAND, key)
}

const fn command_shift(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::COMMAND.plus(Modifiers::SHIFT), key)
}
