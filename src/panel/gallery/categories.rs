//! What of a catalog is shown, and in which order.

use crate::engine::thumbnails::{Item, Subject};
use crate::library::Family;
use crate::panel::palette::fuzzy_score;

/// What stands together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Category {
    Scenes,
    Textures,
    Shapes,
}

/// All of them, with what people call them.
pub const CATEGORIES: [(Category, &str); 3] = [
    (Category::Scenes, "Scenes"),
    (Category::Textures, "Textures and mappings"),
    (Category::Shapes, "Shapes"),
];

/// The title of each category, and those of its items that have all words of `wanted` in their name or
/// caption, those with it in their name first. Empty categories are left out; None stands for all.
pub fn by_category<'i>(
    items: &'i [Item],
    wanted_category: Option<Category>,
    wanted: &str,
) -> Vec<(&'static str, Vec<&'i Item>)> {
    let categories =
        CATEGORIES.into_iter().filter(|(category, _)| wanted_category.is_none_or(|only| only == *category));
    let filled = categories.map(|(category, title)| {
        let of_category = items.iter().filter(|item| category_of(item) == category);
        let mut fitting: Vec<_> =
            of_category.filter_map(|item| Some((match_rank(item, wanted)?, item))).collect();
        fitting.sort_by_key(|(match_rank, _)| *match_rank);
        (title, fitting.into_iter().map(|(_, item)| item).collect::<Vec<_>>())
    });
    filled.filter(|(_, items)| !items.is_empty()).collect()
}

/// The subject so many tiles across and down from the one that is marked, or the first one of all.
pub fn stepped(rows: &[&[&Item]], marked: Option<&Subject>, [across, down]: [isize; 2]) -> Option<Subject> {
    let is_marked = |item: &&Item| Some(&item.subject) == marked;
    let row = rows.iter().position(|row| row.iter().any(is_marked));
    let all: Vec<&Item> = rows.iter().copied().flatten().copied().collect();
    let found = match row {
        None => all.first(),
        Some(_) if down == 0 => {
            let at = all.iter().position(is_marked)?;
            all.get(at.saturating_add_signed(across).min(all.len() - 1))
        }
        Some(y) => {
            let x = rows[y].iter().position(is_marked)?;
            let row = rows[y.saturating_add_signed(down).min(rows.len() - 1)];
            row.get(x.min(row.len() - 1))
        }
    };
    found.map(|item| item.subject.clone())
}

fn category_of(item: &Item) -> Category {
    match item.subject {
        Subject::Scene(_) => Category::Scenes,
        Subject::Function(Family::Texture, _) => Category::Textures,
        Subject::Function(Family::Shape, _) => Category::Shapes,
    }
}

/// Names before captions, and among names those with words that begin so; None where words are missing.
fn match_rank(item: &Item, wanted: &str) -> Option<(bool, usize)> {
    let in_name = fuzzy_score(&item.name, wanted).map(|fuzzy_score| (false, fuzzy_score));
    let anywhere = || fuzzy_score(&format!("{} {}", item.name, item.caption), wanted).map(|_| (true, 0));
    in_name.or_else(anywhere)
}

#[cfg(test)]
mod tests {
    use super::*;

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
}
