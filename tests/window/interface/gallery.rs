//! The gallery: what is listed, found, marked, opened, copied and added.

use std::sync::Arc;

use egui::accesskit::Role;
use egui::{Key, Modifiers, OutputCommand};
use egui_kittest::kittest::{NodeT, Queryable};
use raytoy::engine::thumbnails::{Subject, Thumbnail, ThumbnailEvent};

use super::SCENE;
use super::harness::Studio;

/// The first of three scenes, under an open gallery.
fn opened() -> Studio {
    let meadow = "// A field of grass.\n(objects: [Plane(name: \"grass\")])\n";
    let files = [("scene.ron", SCENE), ("meadow.ron", meadow), ("broken.ron", "(objects: [Spere()])")];
    let mut studio = Studio::open_among(&files, Default::default());
    studio.key(Modifiers::COMMAND, Key::O);
    studio
}

/// The names of the tiles.
fn tiles(studio: &Studio) -> Vec<String> {
    let all = studio.harness.query_all_by_role(Role::ListBoxOption);
    all.filter_map(|tile| tile.accesskit_node().label()).collect()
}

/// Those that are marked.
fn marked(studio: &Studio) -> Vec<String> {
    let all = studio.harness.query_all_by_role(Role::ListBoxOption).map(|tile| tile.accesskit_node());
    let all = all.filter(|tile| tile.toggled() == Some(egui::accesskit::Toggled::True));
    all.filter_map(|tile| tile.label()).collect()
}

#[test]
fn it_has_scenes_textures_and_shapes_shelf_by_shelf() {
    let mut studio = opened();
    assert!(studio.has(Role::Dialog, "gallery"));
    let all = tiles(&studio);
    assert_eq!(all[..3], ["broken", "meadow", "scene"]);
    for name in ["Brick", "Marble", "Sphere", "Torus"] {
        assert!(all.iter().any(|tile| tile == name), "{name}");
    }
    studio.press("Shapes");
    let shapes = tiles(&studio);
    assert!(shapes.len() > 20 && shapes.len() < all.len() && !shapes.iter().any(|tile| tile == "Brick"));
    studio.press("Scenes");
    assert_eq!(tiles(&studio), ["broken", "meadow", "scene"]);
    studio.key(Modifiers::NONE, Key::Escape);
    assert!(!studio.has(Role::Dialog, "gallery"));
    studio.press("Gallery");
    studio.press("close the gallery");
    assert!(!studio.has(Role::Dialog, "gallery"));
}

#[test]
fn words_find_names_and_captions_and_enter_opens_the_first() {
    let mut studio = opened();
    studio.type_text("field grass");
    assert_eq!(tiles(&studio), ["meadow"]);
    studio.type_text(" nothing");
    assert!(tiles(&studio).is_empty() && studio.says("No name and no caption matches."));
    studio.key(Modifiers::COMMAND, Key::A);
    studio.type_text("mead");
    studio.key(Modifiers::NONE, Key::Enter);
    assert!(!studio.has(Role::Dialog, "gallery") && studio.has(Role::TreeItem, "grass"));
    assert_eq!(studio.find(Role::ComboBox, "scene").value().as_deref(), Some("meadow"));
}

#[test]
fn a_click_on_a_scene_opens_it() {
    let mut studio = opened();
    studio.click(Role::ListBoxOption, "meadow");
    assert!(!studio.has(Role::Dialog, "gallery") && studio.has(Role::TreeItem, "grass"));
}

#[test]
fn arrows_go_from_tile_to_tile() {
    let mut studio = opened();
    assert!(marked(&studio).is_empty());
    studio.key(Modifiers::NONE, Key::ArrowDown);
    assert_eq!(marked(&studio), ["broken"]);
    studio.key(Modifiers::NONE, Key::ArrowRight);
    assert_eq!(marked(&studio), ["meadow"]);
    assert!(studio.says("A field of grass."));
    studio.key(Modifiers::NONE, Key::Enter);
    assert!(studio.has(Role::TreeItem, "grass"));
}

#[test]
fn a_shape_tells_what_it_takes_is_copied_and_added() {
    let mut studio = opened();
    studio.type_text("torus");
    studio.click(Role::ListBoxOption, "Torus");
    assert!(studio.says("a shape, from") && studio.says("major_radius") && studio.says("0.00001 to 100000"));
    studio.find(Role::Button, "Copy").click();
    let mut copied = None;
    for _ in 0..4 {
        studio.harness.step();
        for command in &studio.harness.output().platform_output.commands {
            if let OutputCommand::CopyText(text) = command {
                copied = Some(text.clone());
            }
        }
    }
    assert_eq!(copied.as_deref(), Some("Torus()"));
    assert!(studio.says("copied"));
    studio.press("Add");
    assert!(!studio.has(Role::Dialog, "gallery"));
    assert!(studio.text().contains("        Torus(),\n"), "{}", studio.text());
    assert!(studio.has(Role::Group, "Torus 4"), "it is chosen");
}

#[test]
fn a_texture_is_for_copying_only() {
    let mut studio = opened();
    studio.press("Textures");
    studio.type_text("brick");
    studio.click(Role::ListBoxOption, "Brick");
    assert!(studio.has(Role::Button, "Copy all") && !studio.has(Role::Button, "Add"));
}

#[test]
fn what_is_seen_is_drawn_first_and_nothing_once_it_is_closed() {
    let mut studio = opened();
    let (subjects, seen) = studio.stage().drawn.last().cloned().expect("pictures are asked for");
    assert_eq!(subjects.len(), studio.stage().catalog);
    assert!(seen > 3 && seen < subjects.len(), "{seen}");
    studio.type_text("torus");
    let (subjects, seen) = studio.stage().drawn.last().cloned().expect("pictures are asked for");
    assert!(matches!(&subjects[0], Subject::Function(_, name) if name == "Torus"));
    assert!(seen < 5 && subjects.len() == studio.stage().catalog, "{seen}");
    studio.key(Modifiers::NONE, Key::Escape);
    let (subjects, _) = studio.stage().drawn.last().cloned().expect("they are no longer");
    assert!(subjects.is_empty());
}

#[test]
fn a_scene_with_mistakes_says_so_and_others_have_pictures() {
    let mut studio = opened();
    let subject = |studio: &Studio, name: &str| Subject::Scene(studio.home.path().join(name));
    let [broken, meadow] = ["broken.ron", "meadow.ron"].map(|name| subject(&studio, name));
    let picture = Arc::new(Thumbnail { size: [4, 3], rgba: [0, 255, 0, 255].repeat(12) });
    let panel = &mut studio.harness.state_mut().panel;
    panel.receive_thumbnails(ThumbnailEvent::Picture(broken, Err("there is no shape `Spere`".into())));
    panel.receive_thumbnails(ThumbnailEvent::Picture(meadow, Ok(picture)));
    studio.settle();
    let description = |studio: &Studio, name: &str| {
        let tile = studio.find(Role::ListBoxOption, name);
        tile.accesskit_node().data().description().unwrap_or_default().to_owned()
    };
    assert_eq!(description(&studio, "broken"), "has mistakes");
    assert_eq!(description(&studio, "meadow"), "A field of grass.");
    studio.key(Modifiers::NONE, Key::ArrowDown);
    assert_eq!(marked(&studio), ["broken"]);
    assert!(studio.says("there is no shape `Spere`"));
}

#[test]
fn a_model_is_added_where_one_is_there() {
    let add = |studio: &mut Studio| {
        studio.key(Modifiers::COMMAND, Key::O);
        studio.type_text("mesh");
        studio.click(Role::ListBoxOption, "Mesh");
        studio.press("Add");
    };
    let mut studio = Studio::open(SCENE);
    add(&mut studio);
    assert_eq!(studio.text(), SCENE);
    assert!(studio.says("Mesh shows a model: put a file (.obj, .glb, .gltf) into the scene's folder first"));
    let files = [("scene.ron", SCENE), ("models/one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")];
    let mut studio = Studio::open_among(&files, Default::default());
    add(&mut studio);
    assert!(studio.text().contains("        Mesh(file: \"models/one.obj\"),\n"), "{}", studio.text());
    assert!(!studio.has(Role::Alert, "mistakes"));
}
