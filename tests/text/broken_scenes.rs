//! Scenes with something broken in them: each still compiles, or gets errors with places, and nothing panics.

use crate::common::{files, outcome_of, read};
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

/// A texture that is made of the next one twice, over `depth` levels; `moved` moves one of the two.
fn doubled(depth: usize, moved: bool) -> String {
    let level = |i: usize| {
        let (a, b) = (format!("\"t{}\"", i + 1), format!("Grey(of: \"t{}\", at: Translate())", i + 1));
        format!("\"t{i}\": Blend(a: {a}, b: {}),", if moved { &b } else { &a })
    };
    let levels: String = (0..depth).map(level).collect();
    format!("(textures: {{ {levels} \"t{depth}\": Noise() }}, objects: [Sphere(material: (color: \"t0\"))])")
}

#[test]
fn a_texture_is_evaluated_once_at_a_point() {
    let outcome = outcome_of("scenes/dag.ron", &doubled(25, false), Mode::Baked);
    let compiled = outcome.compiled.unwrap_or_else(|| panic!("{}", outcome.report));
    for i in 0..25 {
        let calls = compiled.source.generated().matches(&format!("t{}Texture(at)", i + 1)).count();
        assert_eq!(calls, 1, "texture {i}");
    }
}

#[test]
fn too_much_is_refused_by_counting() {
    let nested = |depth: usize| {
        let solid = (0..depth).fold("Sphere()".to_owned(), |s, _| format!("Union(parts: [{s}, Box()])"));
        format!("(objects: [{solid}])")
    };
    let objects = |items: String| format!("(objects: [{items}])");
    let triplanar = "Triplanar(of: ".repeat(20) + "Noise()" + &")".repeat(20);
    for (text, message) in [
        (doubled(25, true), "evaluates 134,217,725 textures at a point: at most 512 are allowed"),
        (doubled(100, true), "evaluates at least 18,446,744,073,709,551,615 textures"),
        (objects(format!("Sphere(material: (color: {triplanar}))")), "textures at a point"),
        (nested(17), "solids are nested more than 16 deep"),
        (nested(3000), "brackets are nested more than 120 deep"),
        (objects("[".repeat(10_000)), "brackets are nested more than 120 deep"),
        (objects("Sphere(),".repeat(4097)), "4,097 objects and parts: at most 4,096 are allowed"),
        (objects("Sphere(),".repeat(10_001)), "10001 items in one list: at most 10000 are allowed"),
        (objects("Sphere(center: (1, 2, 3)),".repeat(200_000)), "more than 200000 brackets"),
        (
            format!("(lights: [{}], objects: [])", "Point(),".repeat(1025)),
            "1,025 lights: at most 1,024 are allowed",
        ),
    ] {
        let report = outcome_of("scenes/much.ron", &text, Mode::Baked).report;
        let problem = report.diagnostics.first().expect("it is refused");
        assert!(problem.message.contains(message), "{message}\n{}", problem.message);
        assert_eq!(report.diagnostics.len(), 1, "{message}");
        assert!(!problem.labels.is_empty(), "{message}: no place");
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
