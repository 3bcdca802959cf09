//! Scenes with something broken in them: each still compiles, or gets errors with places, and nothing panics.

mod common;

use common::{files, outcome_of, read};
use raytoy::diagnostic::Severity;
use raytoy::wgsl::Mode;

/// How many broken scenes are tried, spread over the gallery.
const MUTATIONS: usize = 600;

/// What goes in where something goes in.
const WORDS: [&str; 24] = [
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ",",
    ":",
    "\"",
    "//",
    "/*",
    "-",
    "NaN",
    "1e999",
    "None",
    "Some(",
    "true",
    "é",
    "\u{0}",
    "\\",
    "Noise()",
    "Sphere()",
    "\"tomato\"",
    "0",
];

#[test]
fn broken_scenes_are_told_and_never_panic() {
    let scenes: Vec<(String, String)> =
        files("scenes", "ron").into_iter().map(|name| (name.clone(), read(&name))).collect();
    let mut random = Random(7);
    let (mut refused, mut warned) = (0, 0);
    for number in 0..MUTATIONS {
        let (name, text) = &scenes[number % scenes.len()];
        let mut broken = text.clone();
        for _ in 0..=random.below(2) {
            broken = mutation(&mut random, &broken);
        }
        let outcome = outcome_of(name, &broken, Mode::Baked);
        let report = outcome.report.to_string();
        let story = || format!("mutation {number} of {name}:\n{report}\n{broken}");
        assert_ne!(outcome.compiled.is_some(), outcome.report.has_errors(), "{}", story());
        for problem in &outcome.report.diagnostics {
            assert!(!problem.message.is_empty(), "{}", story());
            let (place, _) = problem.labels.first().unwrap_or_else(|| panic!("no place: {}", story()));
            let file = outcome.report.texts.get(&place.file);
            assert!(file.is_some_and(|t| t.get(place.span.clone()).is_some()), "a wrong place: {}", story());
        }
        assert!(!report.contains("generated from"), "the author's mistake shows in our text: {}", story());
        refused += usize::from(outcome.report.has_errors());
        warned += usize::from(outcome.report.count(Severity::Warning) > 0);
    }
    eprintln!("{refused} of {MUTATIONS} refused, {warned} with warnings");
    assert!(refused > MUTATIONS / 2, "only {refused} of {MUTATIONS} mutations do any harm");
}

#[test]
fn each_beginning_of_a_scene_is_told() {
    let text = read("scenes/textures.ron");
    for end in (0..text.trim_end().len() - 1).step_by(37) {
        let beginning = &text[..text.floor_char_boundary(end)];
        let outcome = outcome_of("scenes/textures.ron", beginning, Mode::Baked);
        assert!(outcome.report.has_errors(), "half a scene compiles:\n{beginning}");
        let places = outcome.report.diagnostics.iter().map(|problem| problem.labels.len());
        assert!(places.min() > Some(0), "no place:\n{}", outcome.report);
    }
}

/// `text` with one thing broken.
fn mutation(random: &mut Random, text: &str) -> String {
    let at = text.floor_char_boundary(random.below(text.len()));
    let end = text.floor_char_boundary((at + 1 + random.below(12)).min(text.len()));
    let (before, piece, after) = (&text[..at], &text[at..end], &text[end..]);
    match random.below(7) {
        0 => format!("{before}{after}"),
        1 => format!("{before}{piece}{piece}{after}"),
        2 => format!("{before}{}{piece}{after}", WORDS[random.below(WORDS.len())]),
        3 => format!("{before}{}{after}", WORDS[random.below(WORDS.len())]),
        4 if random.below(4) == 0 => before.to_owned(),
        _ => swapped(random, text),
    }
}

/// `text` with two of its words exchanged: names, numbers and strings come where they do not belong.
fn swapped(random: &mut Random, text: &str) -> String {
    let is_word = |c: char| c.is_alphanumeric() || "_.\"#-".contains(c);
    let mut words: Vec<&str> = text.split_inclusive(|c| !is_word(c)).collect();
    let (a, b) = (random.below(words.len()), random.below(words.len()));
    words.swap(a, b);
    words.concat()
}

/// A linear congruential generator (Knuth's MMIX).
struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 33) as usize % end.max(1)
    }
}
