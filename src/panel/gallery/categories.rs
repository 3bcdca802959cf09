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
