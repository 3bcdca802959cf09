//! What a search in the gallery and among commands finds, and where arrow keys lead in the gallery.

use raytoy::engine::thumbnails::{Item, Subject};
use raytoy::library::Family;
use raytoy::panel::palette::fuzzy_score;
use raytoy::panel::{Category, by_category, stepped};

fn items() -> Vec<Item> {
    let texture = |name: &str| Subject::Function(Family::Texture, name.into());
    let shape = |name: &str| Subject::Function(Family::Shape, name.into());
    let item = |subject, name: &str, caption: &str| {
        let (name, caption) = (name.to_owned(), caption.to_owned());
        Item { subject, name, caption, definition: None }
    };
    vec![
        item(Subject::Scene("glass.ron".into()), "glass", "A ball before a brick wall"),
        item(texture("Brick"), "Brick", "Bricks in mortar"),
        item(texture("Stone"), "Stone", "A wall of field stones"),
        item(texture("Wall"), "Wall", "Plaster"),
        item(shape("Box"), "Box", "A block"),
    ]
}

fn names(category: Option<Category>, wanted: &str) -> Vec<String> {
    let items = items();
    let found = by_category(&items, category, wanted);
    found.iter().flat_map(|(_, items)| items.iter().map(|item| item.name.clone())).collect()
}

#[test]
fn a_search_finds_names_and_captions_names_first() {
    assert_eq!(names(None, ""), ["glass", "Brick", "Stone", "Wall", "Box"]);
    assert_eq!(names(None, "wall"), ["glass", "Wall", "Stone"]);
    assert_eq!(names(None, "WALL field"), ["Stone"]);
    assert_eq!(names(Some(Category::Textures), "brick"), ["Brick"]);
    assert!(names(None, "brick nothing").is_empty());
}

#[test]
fn empty_shelves_have_no_title() {
    let items = items();
    let titles =
        |wanted| by_category(&items, None, wanted).iter().map(|(title, _)| *title).collect::<Vec<_>>();
    assert_eq!(titles("b"), ["Scenes", "Textures and mappings", "Shapes"]);
    assert_eq!(titles("block"), ["Shapes"]);
}

#[test]
fn arrows_go_from_tile_to_tile_and_never_over_the_edge() {
    let items = items();
    let all: Vec<&Item> = items.iter().collect();
    let rows = [&all[0..1], &all[1..3], &all[3..4], &all[4..5]];
    let go = |from: usize, by| {
        let to = stepped(&rows, Some(&items[from].subject), by).expect("there are tiles");
        items.iter().position(|item| item.subject == to).expect("it is one of them")
    };
    assert_eq!([go(0, [1, 0]), go(2, [1, 0]), go(4, [1, 0]), go(0, [-1, 0])], [1, 3, 4, 0]);
    assert_eq!([go(0, [0, 1]), go(2, [0, 1]), go(2, [0, -1]), go(4, [0, 1])], [1, 3, 0, 4]);
    assert_eq!(stepped(&rows, None, [0, 1]), Some(items[0].subject.clone()));
    assert_eq!(stepped(&[], None, [0, 1]), None);
}

#[test]
fn names_that_begin_with_what_was_typed_come_first() {
    assert_eq!(fuzzy_score("Open table", "ta OP"), Some(0));
    assert_eq!(fuzzy_score("Open fractals", "op ta"), Some(1));
    assert_eq!(fuzzy_score("Open mirror_room", "room"), Some(0));
    assert_eq!(fuzzy_score("Open table", "open room"), None);
    assert_eq!(fuzzy_score("Undo", ""), Some(0));
}
