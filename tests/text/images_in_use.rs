//! Of the images that a scene names only those are uploaded that its shader looks up.

use std::path::Path;

use image::{Rgb, RgbImage};
use raytoy::Compiled;
use raytoy::bindings::MODELS;
use raytoy::diagnostic::Report;
use raytoy::frame::texels;
use raytoy::ir::Measure;
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;
use tempfile::TempDir;

/// `scene` beside so many images, `0.png` and so on, whose heights tell them apart.
fn compiled(scene: &str, images: u32) -> (TempDir, Result<Compiled, Report>) {
    let folder = TempDir::new().expect("there is room for a folder");
    for n in 0..images {
        let image = RgbImage::from_pixel(1, n + 1, Rgb([128; 3]));
        image.save(folder.path().join(format!("{n}.png"))).expect("the folder is writable");
    }
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";
    std::fs::write(folder.path().join("a.obj"), square).expect("the folder is writable");
    std::fs::write(folder.path().join("a.ron"), scene).expect("the folder is writable");
    let outcome = raytoy::compile(&Sources::on_disk(folder.path()), Path::new("a.ron"), Mode::Baked, None);
    (folder, outcome.compiled.ok_or(outcome.report))
}

/// What is uploaded: the binding, the height of the image, and whether it is a number.
fn uploaded(compiled: &Compiled) -> Vec<(u32, u32, bool)> {
    texels(&compiled.scene)
        .filter(|texels| texels.binding != MODELS)
        // A number has the rest of its digits in green, and nothing in blue.
        .map(|texels| (texels.binding.number, texels.size[1], texels.levels[0][4..6] == [0, 0]))
        .collect()
}

const COLOR: bool = false;
const NUMBER: bool = true;

#[test]
fn only_what_the_shader_looks_up_is_uploaded() {
    let declared = r#"textures: {
            "a": Image(file: "0.png"), "b": Image(file: "1.png"), "ramp": Ramp(by: "a", stops: [(0, 0.5), (1, "b")]),
        },
        materials: { "unused": (color: "b"), "plain": (color: 0.5) },"#;
    for (objects, wanted) in [
        // Declared and not used; used by a material that nothing has.
        ("Sphere()", vec![]),
        (r#"Sphere(material: "plain")"#, vec![]),
        (r#"Sphere(material: "unused")"#, vec![(1, 2, COLOR)]),
        (r#"Sphere(material: (color: "a"))"#, vec![(1, 1, COLOR)]),
        // A number only, by a name or not.
        (r#"Sphere(material: (shininess: "a"))"#, vec![(1, 1, NUMBER)]),
        (r#"Sphere(material: (bump: (height: "a")))"#, vec![(1, 1, NUMBER)]),
        (r#"Sphere(material: (bump: (height: Image(file: "1.png"))))"#, vec![(1, 2, NUMBER)]),
        // Both.
        (r#"Sphere(material: (color: "a", bump: (height: "a")))"#, vec![(1, 1, COLOR), (2, 1, NUMBER)]),
        // Through other textures, as an argument of a shape, and twice the same.
        (r#"Sphere(material: (color: "ramp"))"#, vec![(1, 1, NUMBER), (2, 2, COLOR)]),
        (r#"Heightfield(height: "a")"#, vec![(1, 1, NUMBER)]),
        (r#"Sphere(material: (color: "a")), Box(material: (color: "a"))"#, vec![(1, 1, COLOR)]),
        (r#"Mesh(file: "a.obj", material: (color: "a"))"#, vec![(1, 1, COLOR)]),
    ] {
        let (_folder, compiled) = compiled(&format!("({declared} objects: [{objects}])"), 2);
        let compiled = compiled.unwrap_or_else(|report| panic!("{objects}: {report}"));
        let mut found = uploaded(&compiled);
        let bindings: Vec<u32> = found.iter().map(|(binding, ..)| *binding).collect();
        let bound = (1..).zip(&found).map(|(n, _)| n).collect::<Vec<u32>>();
        assert_eq!(bindings, bound, "{objects}: without gaps");
        for (binding, ..) in &found {
            let text = &compiled.source.sections[0].text;
            assert!(text.contains(&format!("@binding({binding}) var image{}", binding - 1)), "{objects}");
        }
        found.sort_by_key(|(_, height, is_number)| (*height, *is_number));
        let kinds = |all: &[(u32, u32, bool)]| all.iter().map(|(_, h, n)| (*h, *n)).collect::<Vec<_>>();
        assert_eq!(kinds(&found), kinds(&wanted), "{objects}");
    }
}

#[test]
fn the_limit_counts_what_is_looked_up() {
    let declared: Vec<_> = (0..14).map(|n| format!("\"t{n}\": Image(file: \"{n}.png\")")).collect();
    let scene = |used: u32, more: &str| {
        let bump = |n| format!("Sphere(material: (bump: (height: \"t{n}\")))");
        let objects: Vec<_> = (0..used).map(bump).collect();
        format!("(textures: {{{}}}, objects: [{}, {more}])", declared.join(", "), objects.join(", "))
    };
    let (_folder, full) = compiled(&scene(14, "Box()"), 15);
    let full = full.unwrap_or_else(|report| panic!("{report}"));
    assert_eq!(uploaded(&full).len(), 14);
    let (_folder, beyond) = compiled(&scene(14, "Box(material: (color: Image(file: \"14.png\")))"), 15);
    let told = beyond.expect_err("it is one too many").to_string();
    assert!(told.contains("more than 14 images in one scene") && told.contains("14.png"), "{told}");
    // To measure one that the scene uses as a number looks up its color, too.
    let measure = Measure::named(&full.scene, "t3").expect("it is declared");
    assert!(full.measuring(measure).is_err());
    let (_folder, half) = compiled(&scene(7, "Box()"), 14);
    let half = half.unwrap_or_else(|report| panic!("{report}"));
    let measure = Measure::named(&half.scene, "t9").expect("it is declared");
    let measured = half.measuring(measure).unwrap_or_else(|problem| panic!("{problem:?}"));
    let (before, after) = (uploaded(&half), uploaded(&measured));
    assert_eq!((before.len(), &after[..7], after[7]), (7, &before[..], (8, 10, COLOR)));
}
