//! Values: each kind has its widget, and what is done to it goes into the file at its own place.

use egui::accesskit::Role;
use egui::{Key, Modifiers, vec2};
use egui_kittest::Node;
use egui_kittest::kittest::{NodeT, Queryable};
use raytoy::engine::Change;

use super::SCENE;
use super::harness::{Studio, is};

/// The scene with `thing` chosen.
fn chosen(thing: &str) -> Studio {
    let mut studio = Studio::open(SCENE);
    studio.choose(thing);
    studio
}

/// What a screen reader says beside the name of a field.
fn help(studio: &Studio, field: &str) -> String {
    label(studio, field).accesskit_node().data().description().unwrap_or_default().to_owned()
}

/// What stands before the widgets of a field.
fn label<'s>(studio: &'s Studio, field: &str) -> Node<'s> {
    let field = field.to_owned();
    studio.harness.get_by(move |own| own.role() == Role::Label && own.value().as_deref() == Some(&*field))
}

#[test]
fn the_values_of_a_thing_are_these() {
    let studio = chosen("ball");
    assert_eq!(studio.lines(&studio.find(Role::Group, "ball")).join("\n"), BALL);
}

const BALL: &str = "Label = name
Button more for name
TextInput name = ball
Label = center
SpinButton center x = 0
SpinButton center y = 0
SpinButton center z = 0
Label = radius
Button more for radius
SpinButton radius = 1
DisclosureTriangle material
Group material
Label = color
Button more for color
ColorWell color = #ff0000ff
Label = #ff0000
Label = specular
Button more for specular
ComboBox specular = Wave
Label = ?
Group specular
Label = frequency
Button more for frequency
Slider frequency = 2
SpinButton frequency = 2
Label = along
Button more for along
SpinButton along x = 1
SpinButton along y = 0
SpinButton along z = 0
Label = of
Button more for of
SpinButton of = 0
Label = phase
Button more for phase
Slider phase = 0
SpinButton phase = 0
Label = shape
Button more for shape
ComboBox shape = Saw
Label = at
Button more for at
ComboBox at = none
Label = shininess
Button more for shininess
SpinButton shininess = 50
Label = reflectivity
Button more for reflectivity
Slider reflectivity = 0.25
SpinButton reflectivity = 0.25
Label = fresnel
SpinButton fresnel = 0
Label = transmission
Button more for transmission
Slider transmission = 0
SpinButton transmission = 0
Label = ior
Slider ior = 1.5
SpinButton ior = 1.5
Label = emission
Button more for emission
ColorWell emission = #000000ff
Label = 0.000
DisclosureTriangle bump
Label = translate
SpinButton translate x = 0
SpinButton translate y = 0
SpinButton translate z = 0
Label = rotate_deg
SpinButton rotate_deg x = 0
SpinButton rotate_deg y = 0
SpinButton rotate_deg z = 0
Label = scale
SpinButton scale = 1
DisclosureTriangle bounds
Label = visible
CheckBox visible (on)
Label = casts_shadow
CheckBox casts_shadow (on)";

#[test]
fn help_has_the_range_the_unit_and_whether_it_is_written() {
    let mut studio = chosen("camera");
    assert_eq!(
        help(&studio, "fov_deg"),
        "the vertical angle of view\n0.1 to 179, degrees\ndefault value, not written in the file"
    );
    assert_eq!(help(&studio, "eye"), "position of the camera");
    assert_eq!(studio.find(Role::SpinButton, "fov_deg").value().as_deref(), Some("40°"));
    studio.choose("ball");
    assert!(help(&studio, "reflectivity").ends_with("\n0 to 1"), "{}", help(&studio, "reflectivity"));
    // It comes up under the pointer, too.
    let tip = help(&studio, "reflectivity");
    assert!(!studio.says(&tip));
    studio.harness.hover_at(label(&studio, "reflectivity").rect().center());
    studio.harness.run_steps(6);
    assert!(studio.says(&tip), "{tip}");
}

#[test]
fn a_number_is_typed() {
    let mut studio = chosen("ball");
    studio.fill(Role::SpinButton, "radius", "2.5");
    assert_eq!(studio.text(), SCENE.replace("radius: 1 /*", "radius: 2.5 /*"));
    studio.fill(Role::SpinButton, "reflectivity", "7");
    assert!(studio.text().contains("reflectivity: 1.0)"), "it ends at 1: {}", studio.text());
}

#[test]
fn a_slider_goes_to_its_end_and_takes_what_a_screen_reader_sets() {
    let mut studio = chosen("ball");
    let slider = studio.shown(Role::Slider, "reflectivity");
    studio.drag(slider.center(), vec2(slider.width(), 0.0), |_| ());
    assert_eq!(studio.text(), SCENE.replace("reflectivity: 0.25", "reflectivity: 1.0"));
    studio.find(Role::Slider, "reflectivity").set_value_accesskit(0.5);
    studio.settle();
    assert_eq!(studio.text(), SCENE.replace("reflectivity: 0.25", "reflectivity: 0.5"));
}

#[test]
fn a_vector_has_a_number_for_each_axis() {
    let mut studio = chosen("block");
    studio.fill(Role::SpinButton, "min y", "-3");
    assert_eq!(studio.text(), SCENE.replace("min: (-2, 0, 0)", "min: (-2, -3, 0)"));
    // What was not written is written now, with the rest of its default.
    studio.fill(Role::SpinButton, "max z", "4");
    assert!(studio.text().contains("max: (1, 1, 4)"), "{}", studio.text());
}

#[test]
fn a_color_is_written_as_it_was_written_before() {
    let mut studio = chosen("ball");
    studio.click(Role::ColorWell, "color");
    studio.fill(Role::SpinButton, "G", "255");
    assert_eq!(studio.text(), SCENE.replace("#ff0000", "#ffff00"));
    studio.key(Modifiers::NONE, Key::Escape);
    studio.choose("clay");
    studio.click(Role::ColorWell, "color");
    studio.fill(Role::SpinButton, "R", "255");
    let text = studio.text();
    // The picker's steps are those of sRGB bytes.
    assert!(text.contains("\"clay\": (color: (1, 0.5029, 0.5029))"), "{text}");
}

#[test]
fn names_and_defaults_become_hexadecimal_colors() {
    let mut studio = chosen("tiles");
    for (channel, byte) in [("R", "128"), ("G", "0"), ("B", "7")] {
        studio.click(Role::ColorWell, "odd");
        studio.fill(Role::SpinButton, channel, byte);
        studio.key(Modifiers::NONE, Key::Escape);
    }
    assert_eq!(studio.text(), SCENE.replace("\"tomato\"", "\"#800007\""));
    assert!(studio.says("#800007"));
    // As its file has the default.
    assert!(studio.says("#ece6d8"));
    studio.click(Role::ColorWell, "even");
    studio.fill(Role::SpinButton, "R", "1");
    let text = studio.text();
    let even = text.split_once("even: \"#01").expect(&text).1;
    assert!(even.find('"') == Some(4), "{text}");
}

#[test]
fn escape_takes_back_what_is_typed() {
    let mut studio = chosen("ball");
    studio.click(Role::TextInput, "name");
    studio.type_text("orb");
    studio.key(Modifiers::NONE, Key::Escape);
    assert_eq!(studio.text(), SCENE);
    assert!(studio.has(Role::TreeItem, "ball"));
    // A typed number keeps its digits.
    studio.choose("ball");
    studio.fill(Role::SpinButton, "radius", "1.234567");
    assert_eq!(studio.text(), SCENE.replace("radius: 1 /*", "radius: 1.234567 /*"));
}

#[test]
fn a_color_brighter_than_the_screen_is_three_numbers() {
    let mut studio = chosen("Point 0");
    studio.fill(Role::SpinButton, "color green", "3");
    assert_eq!(studio.text(), SCENE.replace("color: (4, 2, 1)", "color: (4, 3, 1)"));
}

#[test]
fn a_choice_and_a_switch_and_a_name() {
    let mut studio = chosen("ball");
    studio.pick((Role::ComboBox, "shape"), "Square");
    assert_eq!(studio.text(), SCENE.replace("shape: Saw", "shape: Square"));
    studio.click(Role::CheckBox, "visible");
    assert!(studio.text().contains("visible: false"), "{}", studio.text());
    studio.fill(Role::TextInput, "name", "orb");
    assert!(studio.text().contains("name: \"orb\""), "{}", studio.text());
    assert!(studio.has(Role::TreeItem, "orb") && !studio.has(Role::TreeItem, "ball"));
}

#[test]
fn a_texture_is_chosen_by_its_name_and_brings_its_own_values() {
    let mut studio = chosen("ball");
    studio.pick((Role::ComboBox, "specular"), "Noise");
    assert_eq!(studio.text(), SCENE.replace("Wave(shape: Saw)", "Noise()"));
    assert!(!studio.has(Role::ComboBox, "shape"));
    assert!(studio.find(Role::Group, "specular").query_by(is(Role::SpinButton, "scale")).is_some());
    // A number or a color becomes a texture, and a texture that has a name.
    studio.pick((Role::Button, "more for reflectivity"), "Fbm");
    assert_eq!(studio.text(), SCENE.replace("Wave(shape: Saw)", "Noise()").replace("0.25", "Fbm()"));
    assert!(studio.text().contains("reflectivity: Fbm()"), "{}", studio.text());
    studio.pick((Role::Button, "more for color"), "\"tiles\"");
    assert!(studio.text().contains("color: \"tiles\""), "{}", studio.text());
    assert_eq!(studio.find(Role::ComboBox, "color").value().as_deref(), Some("tiles"));
    studio.choose("block");
    studio.pick((Role::ComboBox, "material"), "clay");
    assert!(studio.text().contains("material: \"clay\""), "{}", studio.text());
}

#[test]
fn another_texture_keeps_what_both_have() {
    let becomes = |old: &str, new: &str| {
        let scene = format!("(objects: [Sphere(name: \"ball\", material: (color: {old}))])\n");
        let mut studio = Studio::open(&scene);
        studio.choose("ball");
        studio.pick((Role::ComboBox, "color"), new);
        assert!(!studio.has(Role::Alert, "mistakes"), "{old} as {new}: {}", studio.text());
        let text = studio.text();
        let call =
            text.split_once("(color: ").expect("it has one").1.trim_end().trim_end_matches("))])").to_owned();
        studio.key(Modifiers::COMMAND, Key::Z);
        assert_eq!(studio.text(), scene, "it is one step");
        call
    };
    let brick = "Brick(scale: 3, clay: 0.5, at: Planar(), joint: \"red\")";
    assert_eq!(becomes(brick, "Leopard"), "Leopard(scale: 3, at: Planar())");
    assert_eq!(
        becomes("Checker(scale: 2, odd: \"tomato\")", "Stripes"),
        "Stripes(scale: 2, odd: \"tomato\")"
    );
    assert_eq!(
        becomes("Noise(at: Turbulence(scale: 2))", "Triplanar"),
        "Triplanar(of: Brick(), at: Turbulence(scale: 2))"
    );
    assert_eq!(becomes("Ramp(by: Noise(), stops: [(0, 0), (1, 1)])", "Noise"), "Noise()");
}

#[test]
fn what_is_added_stands_in_the_order_of_the_signature() {
    let mut studio = Studio::open("(objects: [Sphere(name: \"ball\", material: (reflectivity: 0.5))])\n");
    studio.choose("ball");
    studio.fill(Role::SpinButton, "radius", "2");
    studio.fill(Role::SpinButton, "specular", "1");
    studio.fill(Role::SpinButton, "translate x", "3");
    studio.fill(Role::SpinButton, "center y", "4");
    let object = "Sphere(name: \"ball\", center: (0, 4, 0), radius: 2, material: (specular: 1, reflectivity: 0.5), \
                  translate: (3, 0, 0))";
    assert_eq!(studio.text(), format!("(objects: [{object}])\n"));
    studio.choose("camera");
    studio.fill(Role::SpinButton, "fov_deg", "30");
    assert_eq!(studio.text(), format!("(camera: (fov_deg: 30), objects: [{object}])\n"));
}

#[test]
fn a_list_gets_one_more_and_loses_one() {
    let mut studio = chosen("floor");
    let stops = "[(0, \"red\"), (0.5, \"blue\"), (1, 0.5)]";
    studio.click(Role::Button, "remove stops 1");
    assert_eq!(studio.text(), SCENE.replace(stops, "[(0, \"red\"), (1, 0.5)]"));
    assert!(!studio.has(Role::Button, "remove stops 1"), "two must stay");
    studio.click(Role::Button, "add to stops");
    assert!(studio.has(Role::Group, "stops 2") && studio.has(Role::Button, "remove stops 1"));
    studio.fill_in("stops 0", Role::SpinButton, "place", "0.1");
    assert!(studio.text().contains("[(0.1, \"red\"), "), "{}", studio.text());
}

#[test]
fn a_value_goes_back_to_its_default_unless_it_must_be_there() {
    let mut studio = chosen("ball");
    studio.pick((Role::Button, "more for radius"), "Reset to the default");
    let text = studio.text();
    assert!(!text.contains("radius") && text.contains("Sphere(name: \"ball\", "), "{text}");
    assert_eq!(studio.find(Role::SpinButton, "radius").value().as_deref(), Some("1"));
    assert!(help(&studio, "radius").ends_with("default value, not written in the file"));
    assert!(!studio.has(Role::Button, "more for radius"), "nothing is left to do");
    studio.choose("Point 0");
    assert!(studio.has(Role::Button, "more for color") && !studio.has(Role::Button, "more for position"));
}

#[test]
fn a_drag_changes_numbers_only_and_the_file_once_the_hand_lets_go() {
    let mut studio = chosen("ball");
    let number = studio.shown(Role::SpinButton, "radius");
    let before = studio.stage().builder.changes.len();
    let (text, shown) = studio.drag(number.center(), vec2(80.0, 0.0), |studio| {
        let shown = studio.find(Role::SpinButton, "radius").value().expect("it shows a number");
        (studio.text(), shown)
    });
    assert_eq!(text, SCENE, "what is still in the hand is not worth a file");
    let radius: f32 = shown.parse().expect("a number");
    assert!(radius > 1.5, "{radius}");
    assert_eq!(studio.text(), SCENE.replace("radius: 1 /*", &format!("radius: {shown} /*")));
    let changes = &studio.stage().builder.changes[before..];
    let numbers = changes.iter().filter(|change| **change == Change::Numbers).count();
    assert!(numbers > 2 && !changes.contains(&Change::Structure), "{changes:?}");
    // One step, however many there were on the way.
    studio.press("Undo");
    assert_eq!(studio.text(), SCENE);
    assert_eq!(studio.find(Role::SpinButton, "radius").value().as_deref(), Some("1"));
}

#[test]
fn a_number_in_the_hand_does_not_lag_behind_it() {
    let mut studio = chosen("ball");
    let number = studio.shown(Role::SpinButton, "radius");
    studio.harness.hover_at(number.center());
    studio.harness.drag_at(number.center());
    studio.harness.hover_at(number.center() + vec2(30.0, 0.0));
    studio.harness.hover_at(number.center() + vec2(60.0, 0.0));
    // Nobody has compiled anything since.
    studio.harness.run();
    let shown = studio.find(Role::SpinButton, "radius").value().expect("it shows a number");
    assert!(shown.parse::<f32>().expect("a number") > 1.3, "{shown}");
    studio.harness.drop_at(number.center() + vec2(60.0, 0.0));
    studio.settle();
    assert_eq!(studio.text(), SCENE.replace("radius: 1 /*", &format!("radius: {shown} /*")));
}

#[test]
fn what_is_no_value_of_its_field_stands_there_as_it_was_written() {
    let mut studio = Studio::open(&SCENE.replace("reflectivity: 0.25", "reflectivity: Maybe(7)"));
    assert!(studio.has(Role::Alert, "mistakes"));
    studio.choose("ball");
    assert!(studio.says("Maybe(7)") && !studio.has(Role::Slider, "reflectivity"));
    // A default mends it.
    studio.pick((Role::Button, "more for reflectivity"), "Reset to the default");
    assert!(!studio.has(Role::Alert, "mistakes") && studio.has(Role::Slider, "reflectivity"));
}

#[test]
fn a_file_is_named_in_a_field() {
    let mut studio = Studio::open("(objects: [Mesh(name: \"thing\", file: \"cube.obj\")])\n");
    studio.choose("thing");
    studio.fill(Role::TextInput, "file", "other.obj");
    assert_eq!(studio.text(), "(objects: [Mesh(name: \"thing\", file: \"other.obj\")])\n");
}

#[test]
fn a_file_is_chosen_among_those_that_are_there() {
    let cube = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let pixel = "P3 1 1 1 0 0 0";
    let others = [
        ("a.obj", cube),
        ("models/B.OBJ", cube),
        ("models/c.gltf", "{}"),
        ("notes.txt", ""),
        ("p.png", pixel),
        ("maps/q.JPEG", pixel),
        (".hidden/d.obj", cube),
    ];
    for (scene, offered, chosen) in [
        ("Mesh(file: \"a.obj\")", "a.obj models/B.OBJ models/c.gltf", "models/B.OBJ"),
        ("Mesh(file: \"gone.obj\")", "a.obj models/B.OBJ models/c.gltf", "a.obj"),
        ("Sphere(material: (color: Image(file: \"p.png\")))", "p.png maps/q.JPEG", "maps/q.JPEG"),
    ] {
        let text = format!("(objects: [{scene}])\n");
        let files = [&[("scene.ron", text.as_str())][..], &others].concat();
        let mut studio = Studio::open_among(&files, Default::default());
        studio.choose(if scene.starts_with("Mesh") { "Mesh 0" } else { "Sphere 0" });
        let menu = (Role::ComboBox, "files for file");
        studio.click(menu.0, menu.1);
        let lines = studio.lines(&studio.find(menu.0, menu.1)).join(" ");
        let lines = lines.replace("ListBox ", "").replace("Button ", "").replace(" (on)", "");
        assert_eq!(lines, offered);
        studio.key(Modifiers::NONE, Key::Escape);
        assert_eq!(studio.text(), text, "who only looks changes nothing");
        studio.pick(menu, chosen);
        let file = scene.split('"').nth(1).expect("it names a file");
        assert_eq!(studio.text(), text.replace(file, chosen));
    }
}
