//! The generated shader, as `raytoy generate` shows it: colored, with the lines of what is chosen marked, and
//! what an edit has changed in it.

mod exports;
mod listing;

use egui::text::{LayoutJob, TextFormat};
use egui::{Color32, FontId, Rect, RichText, ScrollArea, Shape, Ui};

pub use self::listing::Listing;
use self::listing::{Page, Row};
use super::Panel;

/// Points.
const FONT: f32 = 11.5;

/// The tab, and what it shows of all that it could.
#[derive(Default)]
pub struct Tab {
    pub listing: Listing,
    exports: exports::Exports,
    /// What has changed, and not all.
    changes: bool,
    /// What the listing has scrolled to, as the shader calls it.
    reached: Option<String>,
}

impl Panel {
    pub(super) fn shader(&mut self, ui: &mut Ui) {
        let marked = self.selected_object();
        let told = match self.shader.changes {
            true => self.shader.listing.changes().told.clone(),
            false => format!("{} lines", self.shader.listing.page().rows.len()),
        };
        ui.horizontal(|ui| {
            let help = "the changes since the last edit of more than numbers";
            ui.toggle_value(&mut self.shader.changes, "What changed").on_hover_text(help);
            self.export_menu(ui);
        });
        ui.label(RichText::new(told).weak());
        self.shader.exports.follow(ui);
        let Tab { listing, changes, reached, .. } = &mut self.shader;
        if *changes {
            show(ui, "changes", &listing.changes().page, None, None);
            return;
        }
        let page = listing.page();
        let jump = marked.as_deref().filter(|_| *reached != marked).and_then(|name| {
            // The constant by which it is called says nothing of it.
            let is_its = |row: &Row| names(&row.text, name) && !row.text.starts_with("const ");
            page.rows.iter().position(is_its)
        });
        show(ui, "listing", page, marked.as_deref(), jump);
        *reached = marked;
    }

    /// The name by which the shader calls the chosen object.
    fn selected_object(&mut self) -> Option<String> {
        let index = self.chosen()?.object?;
        let end = format!("u32 = {index}u;");
        let is_its = |row: &&Row| row.text.starts_with("const OBJECT_") && row.text.ends_with(&end);
        let line = self.shader.listing.page().rows.iter().find(is_its)?;
        line.text.split([' ', ':']).nth(1).map(str::to_owned)
    }
}

/// Shows the rows of `page`, of which only those on the screen are laid out: with those marked that have the
/// name `marked`, and around the one at `jump`.
fn show(ui: &mut Ui, id: &str, page: &Page, marked: Option<&str>, jump: Option<usize>) {
    let font = FontId::monospace(FONT);
    let (height, letter) = ui.fonts_mut(|fonts| (fonts.row_height(&font), fonts.glyph_width(&font, 'm')));
    ui.spacing_mut().item_spacing.y = 0.0;
    let mut area = ScrollArea::both().id_salt(id).auto_shrink([false, false]);
    if let Some(row) = jump {
        let above = 0.25 * ui.available_height();
        area = area.vertical_scroll_offset((row as f32 * height - above).max(0.0));
    }
    let ink = Ink::of(ui.visuals().dark_mode);
    let has_signs = page.rows.first().is_some_and(|row| row.sign == '@');
    area.show_rows(ui, height, page.rows.len(), |ui, range| {
        ui.set_min_width(letter * (page.width + 2) as f32);
        for row in &page.rows[range] {
            let is_marked = marked.is_some_and(|name| names(&row.text, name));
            let behind = ui.painter().add(Shape::Noop);
            let job = ink.row(row, has_signs, &font);
            let label = egui::Label::new(job).wrap_mode(egui::TextWrapMode::Extend).selectable(true);
            let place = ui.add(label).rect;
            let fill = if is_marked { ink.mark } else { ink.fill(row.sign) };
            let whole = Rect::from_x_y_ranges(ui.max_rect().x_range(), place.y_range());
            ui.painter().set(behind, Shape::rect_filled(whole, 0.0, fill));
        }
    });
}

/// Whether one of the words of `text` is `name`.
fn names(text: &str, name: &str) -> bool {
    text.contains(name) && words(text).any(|word| word == name)
}

/// The colors of WGSL.
struct Ink {
    plain: Color32,
    comment: Color32,
    keyword: Color32,
    number: Color32,
    kind: Color32,
    /// Behind what is chosen, what is gone and what is new.
    mark: Color32,
    gone: Color32,
    new: Color32,
    /// Behind the words for the place of a change.
    head: Color32,
}

impl Ink {
    fn of(is_dark: bool) -> Self {
        let ink = |dark: [u8; 3], light: [u8; 3]| {
            let [r, g, b] = if is_dark { dark } else { light };
            Color32::from_rgb(r, g, b)
        };
        Self {
            plain: ink([212, 212, 212], [40, 40, 40]),
            comment: ink([110, 140, 110], [80, 120, 80]),
            keyword: ink([130, 170, 255], [20, 60, 180]),
            number: ink([230, 170, 110], [160, 80, 0]),
            kind: ink([100, 200, 200], [0, 110, 120]),
            mark: ink([58, 62, 82], [222, 228, 255]),
            gone: ink([74, 30, 32], [255, 222, 220]),
            new: ink([24, 62, 34], [212, 245, 216]),
            head: ink([44, 44, 48], [228, 228, 232]),
        }
    }

    /// Behind a line with this sign.
    fn fill(&self, sign: char) -> Color32 {
        match sign {
            '-' => self.gone,
            '+' => self.new,
            '@' => self.head,
            _ => Color32::TRANSPARENT,
        }
    }

    fn row(&self, row: &Row, has_signs: bool, font: &FontId) -> LayoutJob {
        let mut job = LayoutJob::default();
        let mut put = |word: &str, color: Color32| {
            job.append(word, 0.0, TextFormat { font_id: font.clone(), color, ..Default::default() });
        };
        if row.sign == '@' {
            put(&row.text, self.plain);
            return job;
        }
        if has_signs {
            put(&format!("{} ", row.sign), self.comment);
        }
        let (code, remark) = row.text.find("//").map_or((row.text.as_str(), ""), |at| row.text.split_at(at));
        words(code).for_each(|word| put(word, self.of_word(word)));
        put(remark, self.comment);
        job
    }

    fn of_word(&self, word: &str) -> Color32 {
        match word {
            "fn" | "let" | "var" | "const" | "return" | "if" | "else" | "for" | "switch" | "case"
            | "default" | "break" | "struct" | "true" | "false" => self.keyword,
            _ if word.starts_with(|c: char| c.is_ascii_digit()) => self.number,
            "f32" | "u32" | "i32" | "bool" | "vec2f" | "vec3f" | "vec4f" => self.kind,
            _ if word.starts_with(|c: char| c.is_ascii_uppercase()) => self.kind,
            _ => self.plain,
        }
    }
}

/// Stretches of letters and digits, and what lies between them.
fn words(code: &str) -> impl Iterator<Item = &str> {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '.';
    let mut rest = code;
    std::iter::from_fn(move || {
        let first = rest.chars().next()?;
        let end = rest.find(|c| is_word(c) != is_word(first)).unwrap_or(rest.len());
        let (word, after) = rest.split_at(end);
        rest = after;
        Some(word)
    })
}
