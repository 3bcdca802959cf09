//! Random scenes and random edits of them, for the laws in `edit` and `history`.
// Each binary uses a part of it.

use glam::Vec3;
use raytoy::edit::{Edit, NewValue};
use raytoy::scene::{Field, Kind, Path, Record, Value, parse};

/// A linear congruential generator (Knuth's MMIX).
pub struct Random(pub u64);

impl Random {
    pub fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 33) as usize % end.max(1)
    }

    pub fn one<'a, T: ?Sized>(&mut self, of: &[&'a T]) -> &'a T {
        of[self.below(of.len())]
    }
}

/// The value of a scene that must be one.
pub fn tree(text: &str) -> Value {
    parse("scene.ron", text).unwrap_or_else(|problems| panic!("{problems:?}\n{text}"))
}

/// What may stand between two words.
const FILLINGS: [&str; 14] = [
    " ",
    "  ",
    "\n",
    "\r\n",
    "\t",
    "\n        ",
    "\r\n\t",
    " // a comment, with (brackets\n",
    " // one more: \"\r\n    ",
    "/* é */",
    " /* outer /* inner */ of\n two lines */ ",
    "\n    // alone in its line\n    ",
    "\u{2028}",
    "/**/",
];

/// `text` written another way: other blanks, comments and commas, some values in `Some(…)`, with a
/// byte-order mark or without.
pub fn reformatted(random: &mut Random, text: &str) -> String {
    let mut text = text.to_owned();
    for _ in 0..random.below(3) {
        let root = tree(&text);
        let paths = paths(&root);
        let value = root.at(&paths[random.below(paths.len())]).expect("it was found there");
        if !matches!(value.kind, Kind::None) && value.span != root.span {
            let (before, after) = (&text[..value.whole.start], &text[value.whole.end..]);
            text = format!("{before}Some({}){after}", &text[value.whole.clone()]);
        }
    }
    let often = [0, 0, 2, 10, 40][random.below(5)];
    let commas = random.below(3) * 10;
    let mut written = String::new();
    let mut before = "";
    for word in words(&text) {
        let closes = matches!(word, ")" | "]" | "}") && !matches!(before, "(" | "[" | "{" | ",");
        // `Some(x,)` is no RON.
        if closes && random.below(100) < commas && !text.contains("Some(") {
            written.push(',');
        }
        if random.below(100) < often && !before.is_empty() {
            written.push_str(random.one(&FILLINGS));
        }
        written.push_str(word);
        if !word.trim().is_empty() && !word.starts_with("//") && !word.starts_with("/*") {
            before = word;
        }
    }
    let mark = if random.below(4) == 0 { "\u{feff}" } else { "" };
    let written = format!("{mark}{}", written.trim_start_matches('\u{feff}'));
    if random.below(4) == 0 { written.replace("\r\n", "\n").replace('\n', "\r\n") } else { written }
}

/// The text cut where something may be put between.
fn words(text: &str) -> Vec<&str> {
    let mut words = vec![];
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let is_word = |c: char| c.is_alphanumeric() || "_.+-#!".contains(c);
        let string = rest.trim_start_matches('r').trim_start_matches('#');
        let length = if rest.starts_with("//") {
            rest.find('\n').map_or(rest.len(), |n| n + 1)
        } else if rest.starts_with("/*") {
            let ends = rest.match_indices("*/").map(|(at, _)| at + 2);
            let is_whole =
                |end: &usize| rest[..*end].matches("/*").count() == rest[..*end].matches("*/").count();
            ends.into_iter().find(is_whole).unwrap_or(rest.len())
        } else if rest.starts_with('r') && string.starts_with('"') {
            let hashes = &rest[1..rest.len() - string.len()];
            let close = format!("\"{hashes}");
            rest.len() - string.len() + 1 + string[1..].find(&close).expect("it closes") + close.len()
        } else if first == '"' {
            let mut escaped = false;
            let mut ends = rest.char_indices().skip(1).filter(|(_, c)| {
                let is_end = *c == '"' && !escaped;
                escaped = *c == '\\' && !escaped;
                is_end
            });
            ends.next().expect("it closes").0 + 1
        } else if is_word(first) {
            rest.find(|c| !is_word(c)).unwrap_or(rest.len())
        } else {
            first.len_utf8()
        };
        words.push(&rest[..length]);
        rest = &rest[length..];
    }
    words
}

/// The addresses of all values but the root.
pub fn paths(root: &Value) -> Vec<Path> {
    fn collect(value: &Value, at: &Path, found: &mut Vec<Path>) {
        let mut go = |inner: &Value, path: Path| {
            found.push(path.clone());
            collect(inner, &path, found);
        };
        match &value.kind {
            Kind::Record(Record { fields, items, .. }) => {
                fields.iter().for_each(|f| go(&f.value, at.field(&f.name.text)));
                items.iter().enumerate().for_each(|(i, item)| go(item, at.item(i)));
            }
            Kind::Map(entries) => entries.iter().for_each(|e| go(&e.value, at.key(&e.name.text))),
            Kind::Tuple(items) | Kind::List(items) => {
                items.iter().enumerate().for_each(|(i, item)| go(item, at.item(i)));
            }
            _ => {}
        }
    }
    let mut found = vec![];
    collect(root, &Path::default(), &mut found);
    found
}

/// A value for a place that says `old`, mostly of its kind.
pub fn new_value(random: &mut Random, old: Option<&Value>) -> NewValue {
    let kind = match old.map(|value| &value.kind) {
        Some(Kind::Number(_)) => random.below(2),
        Some(Kind::Tuple(items)) if items.len() == 3 => 2 + random.below(2),
        Some(Kind::Text(_)) => 3 + random.below(3),
        Some(Kind::Bool(_)) => 6,
        _ => random.below(9),
    };
    let kind = if random.below(6) == 0 { random.below(9) } else { kind };
    match kind {
        0 | 1 => NewValue::Number(number(random)),
        2 => NewValue::Vector((0..3).map(|i| component(random, old, i)).collect()),
        3 if random.below(2) == 0 => {
            NewValue::Color(Vec3::from_array([(); 3].map(|()| number(random).abs().min(1e6))))
        }
        3 => NewValue::Color(raytoy::library::parse_color(&hexadecimal(random)).expect("it is one")),
        4 => NewValue::Text(random.one(&["tiles", "a \"quoted\" one", "日本 \\ \n", "\"#", ""]).to_owned()),
        5 => NewValue::Word(random.one(&["Square", "None", "InverseSquare", "Gamma(2.0)"]).to_owned()),
        6 => NewValue::Flag(random.below(2) == 0),
        7 => NewValue::Code(" /* x */ Noise( scale: 3, ) // y".into()),
        _ => NewValue::Code("[(0.5, \"tomato\")]".into()),
    }
}

/// A number, or the component that was there.
fn component(random: &mut Random, old: Option<&Value>, index: usize) -> f32 {
    match old.and_then(|value| value.at(&Path::default().item(index))) {
        Some(Value { kind: Kind::Number(x), .. }) if random.below(2) == 0 => *x as f32,
        _ => number(random),
    }
}

fn number(random: &mut Random) -> f32 {
    match random.below(6) {
        0 => random.below(20) as f32,
        1 => -(random.below(200) as f32) / 10.0,
        2 => random.below(1000) as f32 / 1000.0,
        3 => 0.0,
        _ => loop {
            let x = f32::from_bits((random.below(1 << 31) as u32) << 1);
            if x.is_finite() {
                break x;
            }
        },
    }
}

fn hexadecimal(random: &mut Random) -> String {
    format!("#{:06x}", random.below(1 << 24))
}

/// Any edit of the scene `root`, with a path that is there or beside one that is.
pub fn edit(random: &mut Random, root: &Value) -> Edit {
    let paths = paths(root);
    let Some(path) = paths.get(random.below(paths.len())).cloned() else {
        return Edit::Set { path: Path::default().field("added"), value: new_value(random, None) };
    };
    let value = root.at(&path).expect("it was found there");
    let (group, _) = path.split().expect("only the root has none");
    match (random.below(10), &value.kind) {
        (0 | 1, Kind::Record(_)) => Edit::Set { path: path.field("added"), value: new_value(random, None) },
        (0, Kind::Map(_)) => Edit::Set { path: path.key("an \"added\" one"), value: new_value(random, None) },
        (0 | 1, Kind::List(items)) => {
            let item = "Sphere(name: \"new\", radius: 2)".to_owned();
            Edit::Insert { list: path, index: random.below(items.len() + 2), item }
        }
        (2, _) => Edit::Set { path: group.field("added").field("inner"), value: new_value(random, None) },
        (3, _) => Edit::Remove { path },
        (4, _) => Edit::Duplicate { path },
        _ => Edit::Set { value: new_value(random, Some(value)), path },
    }
}

/// `root` without what is at `path`.
pub fn without(root: &Value, path: &Path) -> Value {
    let mut root = root.clone();
    let (group, step) = path.split().expect("the root stays");
    if let Some(group) = at_mut(&mut root, &group) {
        use raytoy::scene::Step;
        match (step, &mut group.kind) {
            (Step::Field(name), Kind::Record(Record { fields, .. }))
            | (Step::Key(name), Kind::Map(fields)) => {
                let at = fields.iter().position(|f| f.name.text == *name).expect("it is there");
                fields.remove(at);
            }
            (Step::Item(i), Kind::List(items) | Kind::Tuple(items)) => drop(items.remove(*i)),
            (Step::Item(i), Kind::Record(record)) => drop(record.items.remove(*i)),
            _ => panic!("{path} is not there"),
        }
    }
    root
}

/// The value at `path`, to be changed.
pub fn at_mut<'v>(root: &'v mut Value, path: &Path) -> Option<&'v mut Value> {
    use raytoy::scene::Step;
    let named = |fields: &'v mut Vec<Field>, name: &str| {
        fields.iter_mut().find(|f| f.name.text == name).map(|f| &mut f.value)
    };
    path.0.iter().try_fold(root, |value, step| match (step, &mut value.kind) {
        (Step::Field(name), Kind::Record(record)) => named(&mut record.fields, name),
        (Step::Key(name), Kind::Map(entries)) => named(entries, name),
        (Step::Item(i), Kind::Tuple(items) | Kind::List(items)) => items.get_mut(*i),
        (Step::Item(i), Kind::Record(record)) => record.items.get_mut(*i),
        _ => None,
    })
}

/// Whether `value` says `new`.
pub fn says(value: &Value, new: &NewValue) -> bool {
    let numbers = |items: &[Value]| -> Option<Vec<f32>> {
        items.iter().map(|item| if let Kind::Number(x) = item.kind { Some(x as f32) } else { None }).collect()
    };
    match (new, &value.kind) {
        (NewValue::Number(x), Kind::Number(y)) => *x == *y as f32,
        (NewValue::Vector(new), Kind::Tuple(items)) => numbers(items).as_ref() == Some(new),
        (NewValue::Color(color), Kind::Tuple(items)) => numbers(items) == Some(color.to_array().to_vec()),
        (NewValue::Color(color), Kind::Number(x)) => *color == Vec3::splat(*x as f32),
        (NewValue::Color(color), Kind::Text(text)) => raytoy::library::parse_color(text) == Some(*color),
        (NewValue::Flag(a), Kind::Bool(b)) => a == b,
        (NewValue::Text(a), Kind::Text(b)) => a == b,
        (NewValue::Word(a), Kind::Text(b)) => a.eq_ignore_ascii_case(b),
        (NewValue::Word(code), Kind::Record(record)) => {
            record.name.as_ref().is_some_and(|name| code.starts_with(&name.text))
        }
        (NewValue::Word(code) | NewValue::Code(code), _) => tree(code).says_the_same_as(value),
        _ => false,
    }
}
