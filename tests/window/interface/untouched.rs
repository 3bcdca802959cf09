//! A hand that only looks: whatever it chooses, opens and focuses, the file stays byte for byte.

use std::collections::HashSet;

use egui::accessibility::is_input;
use egui::accesskit::Role;
use egui::{Key, Modifiers, Rect, Vec2};
use egui_kittest::kittest::{NodeT, Queryable};

use super::harness::{Studio, is};
use crate::common::{read, scenes};

/// Values that a widget would like to mend: beyond their range, with more digits than it shows, in colors that no
/// picker makes.
const ODD: &str = r##"(
    camera: (eye: (0.123456789, 0, 5.00001), target: (0, 0, 0), fov_deg: 500),
    background: (0.12345, -0.2, 0.3),
    ambient: 0.123456789,
    lights: [Point(position: (0, 5, 0), radius: -3, color: (4.00001, 2, 1)), Directional(color: "Tomato")],
    textures: { "t": Marble(), "u": Noise(scale: -7), "w": "#ABCDEF80" },
    materials: { "m": (color: "tomato", specular: 3.0000001, shininess: 1e9), "n": (color: 0.333333333, ior: 0.2) },
    render: (max_bounces: 99999, exposure: 1234.56789),
    objects: [
        Sphere(center: (1e-9, 123456.789, 0), radius: 0.333333333, material: "m"),
        Box(material: (color: (0.3333333, 1, 0), emission: (0.1, 0.2, 0.3), reflectivity: -1)),
        Sphere(material: (color: Ramp(by: Fbm(octaves: 99), stops: [(-0.2, "#FFF"), (7, "red")]))),
    ],
)
"##;

/// A widget of the fields that are shown.
struct Widget {
    role: Role,
    name: String,
    said: String,
    place: Rect,
}

fn widgets(studio: &Studio, thing: &str) -> Vec<Widget> {
    let group = studio.harness.query_all_by(is(Role::Group, thing)).next();
    let all = group.iter().flat_map(|group| group.children_recursive());
    let all = all.filter(|node| is_input(node.accesskit_node().role()));
    let widget = |node: egui_kittest::Node<'_>| {
        let own = node.accesskit_node();
        let said = own.value().or_else(|| own.numeric_value().map(|x| x.to_string()));
        let (name, said) = (own.label().unwrap_or_default(), said.unwrap_or_default());
        Widget { role: own.role(), name, said, place: node.rect() }
    };
    all.map(widget).collect()
}

/// Opens all parts of the fields that are shut.
fn open_all(studio: &mut Studio, thing: &str) {
    let is_shut = |studio: &Studio, name: &str| {
        let all = studio.harness.query_all_by(is(Role::Group, thing)).next();
        all.is_some_and(|all| all.query_all_by(is(Role::Group, name)).next().is_none())
    };
    let shut = |studio: &Studio| {
        let mut all = widgets(studio, thing).into_iter();
        all.find(|own| own.role == Role::DisclosureTriangle && is_shut(studio, &own.name))
    };
    while let Some(shut) = shut(studio) {
        click(studio, shut.place);
        studio.settle();
    }
}

fn click(studio: &mut Studio, at: Rect) {
    studio.harness.hover_at(at.center());
    studio.harness.drag_at(at.center());
    studio.harness.drop_at(at.center());
    studio.harness.step();
    studio.harness.step();
}

fn press(studio: &mut Studio, key: Key) {
    studio.harness.key_press_modifiers(Modifiers::NONE, key);
    studio.harness.step();
}

/// Chooses each line of the tree, and opens and focuses all that it has, but for what `known` says was before.
fn look_at_all(text: &str, known: &mut HashSet<String>) -> usize {
    let mut studio = Studio::open(text);
    studio.harness.set_size(Vec2::new(1200.0, 6000.0));
    studio.settle();
    let lines = studio.harness.query_all_by_role(Role::TreeItem).map(|line| line.accesskit_node());
    let lines: Vec<String> = lines.filter_map(|line| line.label()).collect();
    let mut looked = 0;
    for line in lines {
        let place =
            studio.harness.query_all_by(is(Role::TreeItem, &line)).next().expect("it is there").rect();
        click(&mut studio, place);
        open_all(&mut studio, &line);
        for Widget { role, name, said, place: at } in widgets(&studio, &line) {
            if !known.insert(format!("{role:?} {name} {said}")) {
                continue;
            }
            looked += 1;
            match role {
                Role::SpinButton | Role::TextInput => {
                    click(&mut studio, at);
                    press(&mut studio, if looked % 2 == 0 { Key::Tab } else { Key::Escape });
                }
                Role::ColorWell => {
                    click(&mut studio, at);
                    for channel in ["R", "G", "B"] {
                        let channel = studio.find(Role::SpinButton, channel).rect();
                        click(&mut studio, channel);
                        press(&mut studio, Key::Tab);
                    }
                    press(&mut studio, Key::Escape);
                    press(&mut studio, Key::Escape);
                }
                Role::ComboBox => {
                    click(&mut studio, at);
                    press(&mut studio, Key::Escape);
                }
                Role::Button if name.starts_with("more for") => {
                    click(&mut studio, at);
                    press(&mut studio, Key::Escape);
                }
                _ => {}
            }
            assert_eq!(studio.text(), text, "{line}: {role:?} {name} {said}");
            if !studio.harness.query_all_by(is(Role::Group, &line)).any(|_| true) {
                click(&mut studio, place);
            }
        }
        studio.settle();
        assert_eq!(studio.text(), text, "{line}");
        assert!(!studio.can("Undo"), "{line}");
    }
    looked
}

#[test]
fn odd_values_stay_as_they_are() {
    let looked = look_at_all(ODD, &mut HashSet::new());
    assert!(looked > 100, "{looked}");
}

#[test]
fn each_scene_stays_as_it_is() {
    let mut known = HashSet::new();
    let mut looked = 0;
    // Lists of a hundred objects show no widget that a short one does not.
    let cases = ["background", "lights", "materials", "render"].map(|part| format!("tests/cases/{part}"));
    let all = cases.iter().flat_map(|folder| scenes(folder)).chain(scenes("scenes"));
    for file in all.chain(["tests/cases/names/long_names_break_lines.ron".to_owned()]) {
        looked += look_at_all(&read(&file), &mut known);
    }
    assert!(looked > 800, "{looked}");
}
