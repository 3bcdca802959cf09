//! Damaged files: each is told in one line, and nothing panics.

use serde_json::{Value, json};

use super::decoded;
use super::glb_writer::{U8, U16, Writer, file};
use super::random::Random;
use super::tree::check;
use crate::common::root;

/// Of each kind.
const MUTATIONS: usize = 3000;

/// What goes in where a number of a document stood, or some bytes of a text.
const NUMBERS: [&str; 14] = [
    "0",
    "1",
    "-1",
    "2",
    "3.5",
    "255",
    "65536",
    "4294967295",
    "4294967296",
    "9223372036854775807",
    "-9223372036854775808",
    "18446744073709551615",
    "1e39",
    "1e18",
];
const WORDS: [&str; 14] =
    [" ", "\n", "\\\n", "\r", "/", "//", "#", "nan", "inf", "v", "f", "f 1 2 3 4 5 6", "é", "-"];

#[test]
fn damaged_texts_are_told_and_never_panic() {
    let text = "v 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\nv -1 0.5 0\nvn 0 0 1\nvt 0.5 0.5\nvt 1 0\n\
        g a\nf 1/1/1 2/2/1 3//1 4/1\nusemtl b\nf -1 -2 -3\nf 1 2 3 4 5\nf 5/-1/-1 1/-2/-1 2/1/1\n";
    let mut random = Random(11);
    let damaged = (0..MUTATIONS).map(|_| {
        let mut bytes = text.as_bytes().to_vec();
        for _ in 0..=random.below(4) {
            mutate(&mut bytes, &mut random);
        }
        bytes
    });
    tell_all(damaged.collect());
}

#[test]
fn damaged_binary_files_are_told_and_never_panic() {
    let mut random = Random(12);
    let gem = std::fs::read(root().join("scenes/models/gem.glb")).unwrap();
    let (document, bytes) = rich();
    let whole = file(&document.to_string(), &bytes);
    assert!(decoded(&whole).is_ok() && decoded(&gem).is_ok());
    let damaged = (0..MUTATIONS).map(|i| {
        let mut bytes = [&whole, &gem][i % 2].clone();
        for _ in 0..=random.below(4) {
            let at = random.below(bytes.len());
            match random.below(4) {
                0 => bytes[at] = random.next() as u8,
                1 => bytes[at] ^= 1 << random.below(8),
                2 => bytes.truncate(at),
                _ => drop(bytes.splice(at..at, [0, 255])),
            }
            if bytes.is_empty() {
                break;
            }
        }
        bytes
    });
    tell_all(damaged.collect());
}

#[test]
fn documents_with_other_numbers_are_told_and_never_panic() {
    let mut random = Random(13);
    let (document, bytes) = rich();
    let text = document.to_string();
    let is_digit = |c: char| c.is_ascii_digit() || c == '.' || c == '-';
    let damaged = (0..MUTATIONS).map(|_| {
        let mut text = text.clone();
        for _ in 0..=random.below(3) {
            // A number and where it ends.
            let starts: Vec<usize> = text
                .char_indices()
                .filter(|(i, c)| is_digit(*c) && matches!(text.as_bytes()[i - 1], b':' | b',' | b'['))
                .map(|(i, _)| i)
                .collect();
            let start = *random.pick(&starts);
            let end = start + text[start..].find(|c| !is_digit(c)).unwrap_or(0);
            text.replace_range(start..end, random.pick::<&str>(&NUMBERS));
        }
        file(&text, &bytes)
    });
    tell_all(damaged.collect());
}

#[test]
fn what_would_fill_the_memory_is_refused() {
    let (mut document, bytes) = rich();
    // Zeros that are not even there.
    document["accessors"][0]["count"] = json!(4_000_000_000_u32);
    document["accessors"][0].as_object_mut().unwrap().remove("bufferView");
    assert!(decoded(&file(&document.to_string(), &bytes)).is_err());
    // The same mesh, again and again, in a file of a few megabytes.
    let mut writer = Writer::default();
    let positions = writer.vectors(&vec![[0.0, 1.0, 2.0]; 30_000]);
    writer.mesh(json!([{ "attributes": { "POSITION": positions } }]));
    let nodes: Vec<Value> = (0..50_000).map(|_| json!({ "mesh": 0 })).collect();
    let roots: Vec<usize> = (0..nodes.len()).collect();
    let told = decoded(&writer.finish(nodes.into(), &roots)).unwrap_err();
    assert_eq!(told, "has more than 1000000 triangles");
}

#[test]
fn a_node_below_itself_is_told() {
    let mut writer = Writer::default();
    let positions = writer.vectors(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    writer.mesh(json!([{ "attributes": { "POSITION": positions } }]));
    let told = decoded(&writer.finish(json!([{ "mesh": 0, "children": [0, 0] }]), &[0])).unwrap_err();
    assert_eq!(told, "is damaged: a node has two parents");
}

/// A file with most of what one can have.
fn rich() -> (Value, Vec<u8>) {
    let mut writer = Writer::default();
    let positions = writer.vectors(&[[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 1.0]]);
    let normals = writer.vectors(&[[0.0, 0.0, 1.0]; 4]);
    let uvs = writer.vectors(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    let wide = writer.indices(&[0, 1, 2, 0, 2, 3], U16);
    let narrow = writer.indices(&[0, 1, 2, 3], U8);
    let all = json!({ "POSITION": positions, "NORMAL": normals, "TEXCOORD_0": uvs });
    writer.mesh(json!([{ "attributes": all, "indices": wide }]));
    writer.mesh(json!([
        { "attributes": { "POSITION": positions }, "indices": narrow, "mode": 5 },
        { "attributes": all, "mode": 6 },
    ]));
    let nodes = json!([
        { "mesh": 0, "children": [1], "scale": [1, 2, 1] },
        { "mesh": 1, "rotation": [0, 0, 0, 1], "translation": [3, 0, 0] },
    ]);
    writer.parts(nodes, &[0])
}

/// Breaks one thing of a text.
fn mutate(bytes: &mut Vec<u8>, random: &mut Random) {
    let at = random.below(bytes.len().max(1)).min(bytes.len());
    let end = (at + random.below(6)).min(bytes.len());
    match random.below(6) {
        0 => drop(bytes.splice(at..end, [])),
        1 => drop(bytes.splice(at..end, random.pick::<&str>(&WORDS).bytes())),
        2 => bytes.truncate(at.max(1)),
        3 => drop(bytes.splice(at..at, [random.next() as u8])),
        _ => drop(bytes.splice(at..end, random.pick::<&str>(&NUMBERS).bytes())),
    }
}

/// Reads all: what can be read must be whole, and what cannot must be told.
fn tell_all(all: Vec<Vec<u8>>) {
    let (count, mut refused) = (all.len(), 0);
    for bytes in all {
        let story = || format!("a file of {} bytes: {}", bytes.len(), String::from_utf8_lossy(&bytes));
        match decoded(&bytes) {
            Ok(model) => check(&model).unwrap_or_else(|why| panic!("{why}: {}", story())),
            Err(why) => {
                let is_line = !why.contains('\n') && !why.contains('\r') && why.chars().count() < 400;
                assert!(is_line && why.len() > 5, "it says {why:?} of {}", story());
                refused += 1;
            }
        }
    }
    eprintln!("{refused} of {count} refused");
    assert!(refused > count / 5 && refused < count, "only {refused} of {count} mutations do any harm");
}
