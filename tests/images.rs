//! Small pictures of a few cases as their goldens show them, and both number modes beside each other.

mod common;

use std::path::Path;

use common::{expect_compiled, expect_none, files, how_to_bless, is_blessing, outcome, picture, root};
use image::{GrayImage, RgbImage};
use image_compare::Algorithm;
use raytoy::gpu::{Gpu, View};
use raytoy::wgsl::Mode;

/// Pictures beside their scenes in `tests/cases/`.
const PICTURES: [&str; 17] = [
    "geometry/round",
    "geometry/flat",
    "geometry/edged",
    "geometry/inside_a_sphere",
    "geometry/inside_a_box",
    "objects/transforms",
    "patterns/nested",
    "patterns/image",
    "patterns/triplanar",
    "solids/parts_are_cut_from_parts",
    "solids/distances_are_marched_to",
    "solids/land_takes_a_texture",
    "materials/bump",
    "materials/mirror",
    "materials/glass",
    "lights/kinds",
    "lights/soft",
];

const SIZE: [u32; 2] = [160, 120];

/// A pixel is an outlier where a channel, 0 to 255, differs by more than this.
const TOLERANCE: u8 = 3;
/// Outliers that a picture may have, as a share of its pixels: edges that round the other way.
const MOST_OUTLIERS: f64 = 0.003;
/// The least structural similarity (mean SSIM of the greys).
const LEAST_SIMILARITY: f64 = 0.99;

/// What of the pixels must agree between live and baked numbers to one step of a channel.
const LEAST_AGREEMENT: f64 = 0.999;

#[test]
fn pictures_look_like_their_goldens() {
    let Some(gpu) = common::gpu() else { return };
    expect_none(PICTURES.iter().filter_map(|case| check_picture(gpu, case).err()));
}

#[test]
fn each_golden_picture_has_a_case() {
    let known = PICTURES.map(|case| format!("tests/cases/{case}.png"));
    let is_extra = |file: &String| file.ends_with(".new.png") || file.ends_with(".diff.png");
    let orphans =
        files("tests/cases", "png").into_iter().filter(|file| !is_extra(file) && !known.contains(file));
    expect_none(orphans.map(|file| format!("{file} belongs to no case: remove it")));
}

#[test]
fn live_and_baked_numbers_give_the_same_picture() {
    let Some(gpu) = common::gpu() else { return };
    expect_none(files("scenes", "ron").iter().filter_map(|scene| {
        let [live, baked] = [Mode::Live, Mode::Baked].map(|mode| {
            let compiled = expect_compiled(outcome(scene, mode));
            picture(gpu, &compiled, [240, 135], View::Color).rgba
        });
        let (a, b) = (live.chunks_exact(4), baked.chunks_exact(4));
        let close = a.zip(b).filter(|(a, b)| a.iter().zip(*b).all(|(x, y)| x.abs_diff(*y) <= 1)).count();
        let share = close as f64 / (live.len() / 4) as f64;
        eprintln!("{scene}: {:.3} % of pixels agree", share * 100.0);
        (share < LEAST_AGREEMENT)
            .then(|| format!("{scene}: live and baked agree in {share:.5} of the pixels"))
    }));
}

#[test]
fn a_picture_drawn_twice_is_the_same() {
    let Some(gpu) = common::gpu() else { return };
    let compiled = expect_compiled(outcome("tests/cases/lights/soft.ron", Mode::Live));
    let draw = || picture(gpu, &compiled, [80, 60], View::Color).radiance;
    assert_eq!(draw(), draw());
}

/// Compares a picture with its golden, or writes it there when blessing.
fn check_picture(gpu: &Gpu, case: &str) -> Result<(), String> {
    let golden = format!("tests/cases/{case}.png");
    let actual = draw(gpu, &format!("tests/cases/{case}.ron"));
    if is_blessing() {
        return save(&actual, &golden);
    }
    let problem = match image::open(root().join(&golden)) {
        Err(error) => error.to_string(),
        Ok(expected) => match compare(&expected.to_rgb8(), &actual) {
            Ok(()) => return Ok(()),
            Err(problem) => {
                save(&difference(&expected.to_rgb8(), &actual), &beside(&golden, "diff"))?;
                problem
            }
        },
    };
    save(&actual, &beside(&golden, "new"))?;
    let advice = format!("look at {}; {}", beside(&golden, "new"), how_to_bless(&golden));
    Err(format!("{golden}: {problem}\n  {advice}"))
}

fn draw(gpu: &Gpu, scene: &str) -> RgbImage {
    let compiled = expect_compiled(outcome(scene, Mode::Baked));
    let rgba = picture(gpu, &compiled, SIZE, View::Color).rgba;
    RgbImage::from_fn(SIZE[0], SIZE[1], |x, y| {
        let at = 4 * (y * SIZE[0] + x) as usize;
        image::Rgb([rgba[at], rgba[at + 1], rgba[at + 2]])
    })
}

fn compare(expected: &RgbImage, actual: &RgbImage) -> Result<(), String> {
    if expected.dimensions() != actual.dimensions() {
        return Err(format!("it is {:?}, not {:?}", actual.dimensions(), expected.dimensions()));
    }
    let apart = |(a, b): &(&image::Rgb<u8>, &image::Rgb<u8>)| {
        a.0.iter().zip(b.0).any(|(x, y)| x.abs_diff(y) > TOLERANCE)
    };
    let outliers = expected.pixels().zip(actual.pixels()).filter(apart).count();
    let share = outliers as f64 / expected.pixels().len() as f64;
    if share > MOST_OUTLIERS {
        return Err(format!("{outliers} pixels differ by more than {TOLERANCE}"));
    }
    let (a, b) = (grey(expected), grey(actual));
    let similarity = image_compare::gray_similarity_structure(&Algorithm::MSSIMSimple, &a, &b)
        .map_err(|error| error.to_string())?;
    if similarity.score < LEAST_SIMILARITY {
        return Err(format!("its structure is similar to {:.4} only", similarity.score));
    }
    Ok(())
}

fn grey(picture: &RgbImage) -> GrayImage {
    image::DynamicImage::from(picture.clone()).to_luma8()
}

/// What differs, eight times as strong.
fn difference(expected: &RgbImage, actual: &RgbImage) -> RgbImage {
    RgbImage::from_fn(actual.width(), actual.height(), |x, y| {
        let (a, b) = (expected.get_pixel_checked(x, y), actual.get_pixel(x, y));
        let channel = |i: usize| a.map_or(255, |a| a.0[i].abs_diff(b.0[i]).saturating_mul(8));
        image::Rgb([channel(0), channel(1), channel(2)])
    })
}

/// `round.new.png` for `round.png`.
fn beside(golden: &str, what: &str) -> String {
    Path::new(golden).with_extension(format!("{what}.png")).to_string_lossy().into_owned()
}

fn save(picture: &RgbImage, name: &str) -> Result<(), String> {
    picture.save(root().join(name)).map_err(|error| format!("{name}: {error}"))
}
