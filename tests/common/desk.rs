//! A real X server with a real window in it: raytoy, run as a person would run it.

#[path = "hand.rs"]
pub mod hand;

use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::{Duration, Instant};

use serde_json::Value;
use x11rb::connection::Connection;
use x11rb::protocol::xproto::{self, ConnectionExt as _, ImageFormat};
use x11rb::protocol::xtest::ConnectionExt as _;
use x11rb::rust_connection::RustConnection;

/// Long enough for a slow machine that does something else too.
pub const PATIENCE: Duration = Duration::from_secs(60);

/// Where this is set, a test that cannot run is a failure.
const REQUIRE_GPU: &str = "RAYTOY_REQUIRE_GPU";

/// A window of raytoy on an X server of its own; both end with it.
pub struct Desk {
    server: Child,
    raytoy: Child,
    events: Receiver<Value>,
    errors: Receiver<String>,
    screen: RustConnection,
    root: xproto::Window,
    /// Everything that raytoy said so far.
    pub seen: Vec<Value>,
}

impl Desk {
    /// Opens `scene` from the folder `home` in a window of `size`; None, with a word, where there is no Xvfb.
    pub fn open(home: &Path, scene: &str, size: [u16; 2]) -> Option<Self> {
        let [width, height] = size;
        Self::open_with(home, scene, size, None, &["--size", &format!("{width}x{height}")])
    }

    /// The same on a screen of `size`, with more arguments, and with a folder for what raytoy remembers.
    pub fn open_with(
        home: &Path,
        scene: &str,
        size: [u16; 2],
        memory: Option<&Path>,
        arguments: &[&str],
    ) -> Option<Self> {
        let [width, height] = size;
        let server = Command::new("Xvfb")
            .args(["-displayfd", "1", "-screen", "0", &format!("{width}x{height}x24"), "-nolisten", "tcp"])
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn();
        let mut server = match server {
            Ok(server) => server,
            Err(error) => {
                assert!(std::env::var_os(REQUIRE_GPU).is_none(), "there is no Xvfb: {error}");
                eprintln!("skipped: no Xvfb");
                return None;
            }
        };
        let mut number = String::new();
        let output = server.stdout.take().expect("it is piped");
        BufReader::new(output).read_line(&mut number).expect("Xvfb tells its number");
        let display = format!(":{}", number.trim());
        let (screen, at) = x11rb::connect(Some(&display)).expect("the server is up");
        let root = screen.setup().roots[at].root;
        let mut raytoy = Command::new(env!("CARGO_BIN_EXE_raytoy"))
            .args(["view", scene, "--events", "--adapter", "software"])
            .args(arguments)
            .env_remove("RAYTOY_CONFIG")
            .envs(memory.map(|folder| ("RAYTOY_CONFIG", folder)))
            .current_dir(home)
            .env("DISPLAY", &display)
            .env_remove("WAYLAND_DISPLAY")
            .env_remove("WAYLAND_SOCKET")
            // Without it drivers complain.
            .env("XDG_RUNTIME_DIR", std::env::temp_dir())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("raytoy starts");
        let (sender, errors) = channel();
        let lines = BufReader::new(raytoy.stderr.take().expect("it is piped")).lines();
        std::thread::spawn(move || {
            let told = lines.map_while(Result::ok).inspect(|line| eprintln!("{line}"));
            let _ = sender.send(told.map(|line| line + "\n").collect());
        });
        let (sender, events) = channel();
        let lines = BufReader::new(raytoy.stdout.take().expect("it is piped")).lines();
        std::thread::spawn(move || {
            for line in lines.map_while(Result::ok) {
                let event = serde_json::from_str(&line).expect("each line is JSON");
                if sender.send(event).is_err() {
                    return;
                }
            }
        });
        Some(Self { server, raytoy, events, errors, screen, root, seen: vec![] })
    }

    /// The next event that is `wanted`.
    pub fn wait_for(&mut self, what: &str, wanted: impl Fn(&Value) -> bool) -> Value {
        let until = Instant::now() + PATIENCE;
        loop {
            match self.events.recv_timeout(until.saturating_duration_since(Instant::now())) {
                Ok(event) => {
                    self.seen.push(event.clone());
                    if wanted(&event) {
                        return event;
                    }
                }
                Err(RecvTimeoutError::Timeout) => panic!("waited in vain for {what}; seen: {:#?}", self.seen),
                Err(RecvTimeoutError::Disconnected) => panic!("raytoy ended before {what}"),
            }
        }
    }

    /// The next event, if it has come.
    pub fn next_event(&mut self) -> Option<Value> {
        let event = self.events.try_recv().ok()?;
        self.seen.push(event.clone());
        Some(event)
    }

    /// Says a word that only a driving program can.
    pub fn say(&mut self, word: &str) {
        let input = self.raytoy.stdin.as_mut().expect("it is piped");
        writeln!(input, "{word}").expect("raytoy listens");
    }

    /// The next event called `name`.
    pub fn wait_for_event(&mut self, name: &str) -> Value {
        self.wait_for(name, |event| event["event"] == name)
    }

    /// The pipelines that raytoy has made so far, by its last word on it.
    pub fn pipelines(&mut self) -> Option<u64> {
        self.seen.extend(self.events.try_iter());
        self.seen.iter().filter_map(|event| event["pipelines"].as_u64()).max()
    }

    /// The color on the screen at a point, pixels from the top left.
    pub fn color_at(&self, x: i16, y: i16) -> [u8; 3] {
        let image = self.screen.get_image(ImageFormat::Z_PIXMAP, self.root, x, y, 1, 1, !0);
        let data = image.expect("the server is up").reply().expect("the point is on the screen").data;
        [data[2], data[1], data[0]]
    }

    /// Waits until the screen shows `color` at a point, to 2/255.
    pub fn wait_for_color(&self, x: i16, y: i16, color: [u8; 3]) {
        let until = Instant::now() + PATIENCE;
        loop {
            let found = self.color_at(x, y);
            if found.iter().zip(color).all(|(a, b)| a.abs_diff(b) <= 2) {
                return;
            }
            assert!(Instant::now() < until, "waited in vain for {color:?}; the screen shows {found:?}");
            std::thread::sleep(Duration::from_millis(10));
        }
    }

    /// Waits until the screen shows something else than `before` at a point.
    pub fn wait_for_change(&self, x: i16, y: i16, before: [u8; 3]) {
        let until = Instant::now() + PATIENCE;
        while self.color_at(x, y) == before {
            assert!(Instant::now() < until, "waited in vain for a change of {before:?}");
            std::thread::sleep(Duration::from_millis(10));
        }
    }

    /// Presses the first button at `from` and lets it go at `to`, at the speed of a hand.
    pub fn drag(&self, from: [i16; 2], to: [i16; 2]) {
        self.hand(xproto::MOTION_NOTIFY_EVENT, 0, from);
        self.hand(xproto::BUTTON_PRESS_EVENT, 1, from);
        for step in 1..=4 {
            let between = |i: usize| from[i] + (to[i] - from[i]) * step / 4;
            self.hand(xproto::MOTION_NOTIFY_EVENT, 0, [between(0), between(1)]);
        }
        self.hand(xproto::BUTTON_RELEASE_EVENT, 1, to);
    }

    /// Presses the first button and holds it down.
    pub fn hold(&self, at: [i16; 2]) {
        self.hand(xproto::MOTION_NOTIFY_EVENT, 0, at);
        self.hand(xproto::BUTTON_PRESS_EVENT, 1, at);
    }

    /// Lets the first button go.
    pub fn let_go(&self, at: [i16; 2]) {
        self.hand(xproto::BUTTON_RELEASE_EVENT, 1, at);
    }

    /// Presses the key with the X keysym `key` and holds it down, or lets it go.
    pub fn hold_key(&self, key: u32, is_down: bool) {
        let kind = if is_down { xproto::KEY_PRESS_EVENT } else { xproto::KEY_RELEASE_EVENT };
        self.hand(kind, self.keycode(key), [0, 0]);
    }

    /// Moves the pointer.
    pub fn point(&self, at: [i16; 2]) {
        self.hand(xproto::MOTION_NOTIFY_EVENT, 0, at);
    }

    /// Presses the first button and lets it go.
    pub fn click(&self, at: [i16; 2]) {
        self.hand(xproto::MOTION_NOTIFY_EVENT, 0, at);
        self.hand(xproto::BUTTON_PRESS_EVENT, 1, at);
        self.hand(xproto::BUTTON_RELEASE_EVENT, 1, at);
    }

    /// Asks the window to close, as a window manager does where its cross is pressed.
    pub fn ask_to_close(&self) {
        let (window, _) = self.window();
        let data = [self.atom("WM_DELETE_WINDOW"), x11rb::CURRENT_TIME, 0, 0, 0];
        let event = xproto::ClientMessageEvent::new(32, window, self.atom("WM_PROTOCOLS"), data);
        let sent = self.screen.send_event(false, window, xproto::EventMask::NO_EVENT, event);
        sent.expect("the server is up");
        self.screen.flush().expect("the server is up");
    }

    /// Whether any program has something to paste.
    pub fn has_clipboard(&self) -> bool {
        let asked = self.screen.get_selection_owner(self.atom("CLIPBOARD")).expect("the server is up");
        asked.reply().expect("the server is up").owner != x11rb::NONE
    }

    fn atom(&self, name: &str) -> xproto::Atom {
        let asked = self.screen.intern_atom(false, name.as_bytes()).expect("the server is up");
        asked.reply().expect("there is room for a name").atom
    }

    /// Turns the wheel so many steps away from the hand.
    pub fn roll(&self, at: [i16; 2], steps: u32) {
        self.point(at);
        for _ in 0..steps {
            self.hand(xproto::BUTTON_PRESS_EVENT, 4, at);
            self.hand(xproto::BUTTON_RELEASE_EVENT, 4, at);
        }
    }

    /// Gives the window the keyboard, which without a window manager nobody does. Returns the window's size.
    pub fn focus(&self) -> [u16; 2] {
        let (window, size) = self.window();
        let parent = xproto::InputFocus::PARENT;
        self.screen.set_input_focus(parent, window, x11rb::CURRENT_TIME).expect("the server is up");
        self.screen.flush().expect("the server is up");
        size
    }

    /// raytoy's window, and its size.
    fn window(&self) -> (xproto::Window, [u16; 2]) {
        let tree =
            self.screen.query_tree(self.root).expect("the server is up").reply().expect("there is a root");
        let sized = tree.children.into_iter().filter_map(|window| {
            let looks = self.screen.get_window_attributes(window).ok()?.reply().ok()?;
            let size = self.screen.get_geometry(window).ok()?.reply().ok()?;
            (looks.map_state == xproto::MapState::VIEWABLE).then_some((window, [size.width, size.height]))
        });
        sized.max_by_key(|(_, size)| size[0]).expect("the window is open")
    }

    /// Presses the key with the X keysym `key` while those of `held` are down, and lets all go.
    pub fn press(&self, held: &[u32], key: u32) {
        let keys: Vec<u8> = held.iter().chain([&key]).map(|key| self.keycode(*key)).collect();
        keys.iter().for_each(|code| self.hand(xproto::KEY_PRESS_EVENT, *code, [0, 0]));
        keys.iter().rev().for_each(|code| self.hand(xproto::KEY_RELEASE_EVENT, *code, [0, 0]));
    }

    /// Types small letters and blanks, whose keysyms are their ASCII codes.
    pub fn type_text(&self, text: &str) {
        text.bytes().for_each(|letter| self.press(&[], letter.into()));
    }

    fn keycode(&self, keysym: u32) -> u8 {
        let setup = self.screen.setup();
        let (first, last) = (setup.min_keycode, setup.max_keycode);
        let mapping = self.screen.get_keyboard_mapping(first, last - first + 1).expect("the server is up");
        let mapping = mapping.reply().expect("there is a keyboard");
        let mut keys = mapping.keysyms.chunks(mapping.keysyms_per_keycode.into());
        first + keys.position(|symbols| symbols[0] == keysym).expect("the keyboard has the key") as u8
    }

    /// Waits until raytoy ends by itself.
    pub fn wait_for_end(&mut self) {
        let until = Instant::now() + PATIENCE;
        while self.raytoy.try_wait().expect("it is our child").is_none() {
            assert!(Instant::now() < until, "raytoy does not end");
            std::thread::sleep(Duration::from_millis(10));
        }
    }

    fn hand(&self, kind: u8, detail: u8, at: [i16; 2]) {
        self.screen.xtest_fake_input(kind, detail, 0, self.root, at[0], at[1], 0).expect("the server is up");
        self.screen.flush().expect("the server is up");
        std::thread::sleep(Duration::from_millis(150));
    }

    /// Ends raytoy; all that it has written to standard error.
    pub fn end(mut self) -> String {
        self.raytoy.kill().expect("it is our child");
        self.errors.recv_timeout(PATIENCE).expect("nothing else writes there")
    }

    /// The processor time that raytoy uses in `time`, once it rests.
    pub fn used_at_rest(&self, time: Duration) -> Duration {
        let until = Instant::now() + PATIENCE;
        let used_in = |time| {
            let before = self.processor_time();
            std::thread::sleep(time);
            self.processor_time() - before
        };
        while used_in(Duration::from_secs(1)) > Duration::from_millis(10) {
            assert!(Instant::now() < until, "raytoy does not rest");
        }
        used_in(time)
    }

    /// Processor time that raytoy has used so far.
    pub fn processor_time(&self) -> Duration {
        let stat = std::fs::read_to_string(format!("/proc/{}/stat", self.raytoy.id())).expect("raytoy runs");
        let fields: Vec<&str> = stat.rsplit(") ").next().unwrap_or("").split(' ').collect();
        // utime and stime, in the kernel's hundredths of a second.
        let ticks: u64 = fields[11..13].iter().filter_map(|f| f.parse::<u64>().ok()).sum();
        Duration::from_millis(ticks * 10)
    }
}

impl Drop for Desk {
    fn drop(&mut self) {
        for child in [&mut self.raytoy, &mut self.server] {
            let _ = child.kill();
            let _ = child.wait();
        }
    }
}
