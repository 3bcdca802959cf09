//! A panel, a hand on it, and a scene's file.

use std::fs;
use std::path::PathBuf;

use egui::accesskit::{Role, Toggled};
use egui::{Event, Key, Modifiers, Pos2, Rect, Vec2};
use egui_kittest::kittest::{AccessKitNode, NodeT, Queryable};
use egui_kittest::{Harness, Node};
use raytoy::engine::thumbnails::{Subject, ThumbnailCommand, ThumbnailEvent, catalog};
use raytoy::engine::{BuilderCommand, ViewRequest};
use raytoy::panel::Settings;
use raytoy::panel::{CaptureAction, Panel, apply_style};
use raytoy::sources::Disk;
use tempfile::TempDir;

use super::builder::Builder;

const SIZE: [f32; 2] = [1200.0, 800.0];
/// Rounds in which the panel and the builder tell each other news, at most.
const ROUNDS: usize = 20;

/// What a test works with.
pub struct Studio {
    pub harness: Harness<'static, Stage>,
    pub scene: PathBuf,
    pub home: TempDir,
}

/// The panel, and what it has asked for.
pub struct Stage {
    pub panel: Panel,
    pub builder: Builder,
    orders: Vec<BuilderCommand>,
    wishes: Vec<ThumbnailCommand>,
    /// The pictures that the gallery has asked for, again and again, and how many of them are seen.
    pub drawn: Vec<(Vec<Subject>, usize)>,
    /// How much the gallery was told that there is.
    pub catalog: usize,
    pub captures: Vec<CaptureAction>,
    pub look: Option<ViewRequest>,
    pub quits: bool,
}

impl Studio {
    /// With this scene open, and nothing remembered.
    pub fn open(text: &str) -> Self {
        Self::open_among(&[("scene.ron", text)], Settings::default())
    }

    /// With the first of these files open, all in one folder.
    pub fn open_among(files: &[(&str, &str)], settings: Settings) -> Self {
        let home = TempDir::new().expect("there is room for a folder");
        for (name, text) in files {
            let file = home.path().join(name);
            fs::create_dir_all(file.parent().expect("it lies in a folder")).expect("the folder is writable");
            fs::write(file, text).expect("the folder is writable");
        }
        let scene = home.path().join(files[0].0);
        let theme = settings.theme;
        let stage = Stage {
            panel: Panel::new(&scene, "a GPU of paper".to_owned(), settings),
            builder: Builder::default(),
            orders: vec![BuilderCommand::Open(scene.clone())],
            wishes: vec![],
            drawn: vec![],
            catalog: 0,
            captures: vec![],
            look: None,
            quits: false,
        };
        let harness = Harness::builder()
            .with_size(Vec2::from(SIZE))
            .with_max_steps(12)
            .with_context_setup(move |context| apply_style(context, theme))
            .build_ui_state(|ui, stage: &mut Stage| stage.frame(ui), stage);
        let mut studio = Self { harness, scene, home };
        studio.settle();
        studio
    }

    /// Goes on until nobody has news.
    pub fn settle(&mut self) {
        for _ in 0..ROUNDS {
            self.harness.run();
            if !self.harness.state_mut().answer() {
                return;
            }
        }
        panic!("the panel and the builder never come to an end");
    }

    /// The only widget with this role and name.
    #[track_caller]
    pub fn find(&self, role: Role, name: &str) -> Node<'_> {
        self.harness.get_by(is(role, name))
    }

    /// The same, among those of the only group with the name `group`.
    #[track_caller]
    pub fn find_in(&self, group: &str, role: Role, name: &str) -> Node<'_> {
        self.find(Role::Group, group).get_by(is(role, name))
    }

    pub fn has(&self, role: Role, name: &str) -> bool {
        self.harness.query_by(is(role, name)).is_some()
    }

    /// Whether it is said somewhere in a text that nobody can change.
    pub fn says(&self, words: &str) -> bool {
        let words = words.to_owned();
        let has_them = move |node: &AccessKitNode<'_>| node.value().is_some_and(|said| said.contains(&words));
        self.harness.query_all_by(has_them).any(|node| node.accesskit_node().role() == Role::Label)
    }

    /// Whether a button can be pressed.
    pub fn can(&self, button: &str) -> bool {
        !self.find(Role::Button, button).accesskit_node().is_disabled()
    }

    /// Whether a switch is on.
    pub fn is_on(&self, switch: &str) -> bool {
        self.find(Role::Button, switch).accesskit_node().toggled() == Some(Toggled::True)
    }

    /// Presses a button with the mouse.
    #[track_caller]
    pub fn press(&mut self, button: &str) {
        self.click(Role::Button, button);
    }

    /// Chooses a line of the tree.
    #[track_caller]
    pub fn choose(&mut self, line: &str) {
        self.click(Role::TreeItem, line);
    }

    #[track_caller]
    pub fn click(&mut self, role: Role, name: &str) {
        self.shown(role, name);
        self.find(role, name).click();
        self.leave();
    }

    /// Opens a menu, and takes what is called `item` in it.
    #[track_caller]
    pub fn pick(&mut self, menu: (Role, &str), item: &str) {
        self.click(menu.0, menu.1);
        self.find(menu.0, menu.1).get_by(is(Role::Button, item)).scroll_to_me();
        self.settle();
        self.find(menu.0, menu.1).get_by(is(Role::Button, item)).click();
        self.leave();
    }

    /// Where the widget lies, once it is in sight.
    #[track_caller]
    pub fn shown(&mut self, role: Role, name: &str) -> Rect {
        self.find(role, name).scroll_to_me();
        self.settle();
        self.find(role, name).rect()
    }

    /// Types into a field in place of what is there.
    #[track_caller]
    pub fn fill(&mut self, role: Role, name: &str, text: &str) {
        let place = self.shown(role, name);
        self.fill_at(place, text);
    }

    /// The same, in the group with the name `group`.
    #[track_caller]
    pub fn fill_in(&mut self, group: &str, role: Role, name: &str, text: &str) {
        self.find_in(group, role, name).scroll_to_me();
        self.settle();
        let place = self.find_in(group, role, name).rect();
        self.fill_at(place, text);
    }

    fn fill_at(&mut self, place: Rect, text: &str) {
        self.harness.hover_at(place.center());
        self.harness.drag_at(place.center());
        self.harness.drop_at(place.center());
        self.settle();
        self.key(Modifiers::COMMAND, Key::A);
        self.type_text(text);
        self.key(Modifiers::NONE, Key::Enter);
    }

    /// Takes the pointer away, which would show what a widget is for.
    pub fn leave(&mut self) {
        self.harness.remove_cursor();
        self.settle();
    }

    pub fn key(&mut self, modifiers: Modifiers, key: Key) {
        self.harness.key_press_modifiers(modifiers, key);
        self.settle();
    }

    /// Types into what has the focus.
    pub fn type_text(&mut self, text: &str) {
        self.harness.event(Event::Text(text.to_owned()));
        self.settle();
    }

    /// Takes the hand from one point to another, in steps, and tells what `look` sees before it lets go.
    pub fn drag<T>(&mut self, from: Pos2, by: Vec2, look: impl FnOnce(&mut Self) -> T) -> T {
        self.harness.hover_at(from);
        self.harness.drag_at(from);
        for step in 1..=4 {
            self.harness.hover_at(from + by * (step as f32 / 4.0));
            self.settle();
        }
        let seen = look(self);
        self.harness.drop_at(from + by);
        self.settle();
        seen
    }

    /// What the scene's file says.
    pub fn text(&self) -> String {
        fs::read_to_string(&self.scene).expect("it is there")
    }

    /// An editor saves the scene's file.
    pub fn save(&mut self, text: &str) {
        fs::write(&self.scene, text).expect("the folder is writable");
        self.harness.state_mut().orders.push(BuilderCommand::Changed);
        self.settle();
    }

    /// That of the sphere of the version that is shown.
    pub fn shown_radius(&self) -> f32 {
        let compiled = self.stage().panel.compiled().expect("there is a picture");
        let text = &compiled.text;
        let (_, number) = text.split_once("radius: ").expect("the sphere has one");
        number.split(' ').next().and_then(|number| number.parse().ok()).expect("a number")
    }

    pub fn stage(&self) -> &Stage {
        self.harness.state()
    }

    pub fn look(&self) -> ViewRequest {
        self.stage().look.expect("a frame was laid out")
    }

    /// All that can be heard in the node, line by line.
    pub fn lines(&self, of: &Node<'_>) -> Vec<String> {
        of.children_recursive().filter_map(|node| line(&node)).collect()
    }
}

/// Those with this role and name.
pub fn is(role: Role, name: &str) -> impl Fn(&AccessKitNode<'_>) -> bool + 'static {
    let name = name.to_owned();
    move |node| node.role() == role && node.label().as_deref() == Some(name.as_str())
}

/// What a screen reader says of a node; None where it is only a place for others.
fn line(node: &Node<'_>) -> Option<String> {
    let own = node.accesskit_node();
    let role = own.role();
    if matches!(role, Role::GenericContainer | Role::TextRun | Role::Pane | Role::ScrollView | Role::Unknown)
    {
        return None;
    }
    let name = own.label().map_or(String::new(), |name| format!(" {name}"));
    let value = own.value().or_else(|| own.numeric_value().map(|x| x.to_string()));
    let value = value.map_or(String::new(), |value| format!(" = {value}"));
    let toggled = if own.toggled() == Some(Toggled::True) { " (on)" } else { "" };
    let disabled = if own.is_disabled() { " (off)" } else { "" };
    Some(format!("{role:?}{name}{value}{toggled}{disabled}"))
}

impl Stage {
    fn frame(&mut self, ui: &mut egui::Ui) {
        let reply = self.panel.show(ui, None);
        self.orders.extend(reply.orders);
        self.wishes.extend(reply.wishes);
        self.captures.extend(reply.capture);
        self.look = Some(reply.look);
        self.quits |= reply.quits;
    }

    /// Whether there was anything to answer.
    fn answer(&mut self) -> bool {
        let (orders, wishes) = (std::mem::take(&mut self.orders), std::mem::take(&mut self.wishes));
        let is_news = !orders.is_empty() || !wishes.is_empty();
        orders.into_iter().for_each(|order| self.builder.obey(order, &mut self.panel));
        for wish in wishes {
            match wish {
                ThumbnailCommand::List { folder, scenes } => {
                    let items = catalog(&Disk::new(None), &folder, &scenes);
                    self.catalog = items.len();
                    self.panel.receive_thumbnails(ThumbnailEvent::Catalog(items));
                }
                ThumbnailCommand::Draw { subjects, seen, .. } => self.drawn.push((subjects, seen)),
            }
        }
        is_news
    }
}
