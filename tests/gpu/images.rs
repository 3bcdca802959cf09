//! The cases as `raytoy test` sees them: pictures beside their goldens; and both number modes beside each other.

use crate::common::{expect_compiled, expect_none, files, is_blessing, outcome, read, root};
use crate::device;
use crate::draw::picture;
use raytoy::difference::rgb;
use raytoy::frame::View;
use raytoy::judge::{Limits, Verdict, judge};
use raytoy::sources::{Disk, Sources};
use raytoy::suite::{Bench, Goldens, Run, find, html, human, run};
use raytoy::wgsl::Mode;

/// What of the pixels must agree between live and baked numbers to one step of a channel.
const LEAST_AGREEMENT: f64 = 0.999;

#[test]
fn the_cases_pass_as_anyones_scenes_would() {
    let Some(gpu) = device::gpu() else { return };
    let cases = find(&Sources::on_disk(&root()), &["tests/cases".into()]).expect("the folder is there");
    let bench = Bench {
        disk: Disk { here: root(), named_root: None },
        goldens: Goldens::default(),
        bless: is_blessing(),
    };
    let outcomes = run(&bench, std::slice::from_ref(gpu), &cases, &mut |_| ());
    let run = Run { outcomes, adapter: gpu.describe(), call: String::new() };
    if run.failed() > 0 {
        let page = format!("{}/report.html", env!("CARGO_TARGET_TMPDIR"));
        std::fs::write(&page, html(&run)).expect("cargo's folder is writable");
        let told = human(&run).replace("ok       tests/", "").replace("raytoy test", "cargo run -- test");
        panic!("{told}\nsee {page}");
    }
    assert!(run.passed() > 70, "only {} cases were found", run.passed());
}

#[test]
fn each_golden_picture_has_a_case() {
    let orphans = files("tests/cases", "png").into_iter().filter(|file| {
        let settings = file.replace(".png", ".test.ron");
        !root().join(&settings).exists() || !read(&settings).contains("picture: true")
    });
    expect_none(orphans.map(|file| format!("{file} belongs to no case: remove it")));
}

#[test]
fn live_and_baked_numbers_give_the_same_picture() {
    let Some(gpu) = device::gpu() else { return };
    expect_none(files("scenes", "ron").iter().filter_map(|scene| {
        let [live, baked] = [Mode::Live, Mode::Baked].map(|mode| {
            let compiled = expect_compiled(outcome(scene, mode));
            picture(gpu, &compiled, [240, 135], View::Color)
        });
        let (a, b) = (live.rgba.chunks_exact(4), baked.rgba.chunks_exact(4));
        let close = a.zip(b).filter(|(a, b)| a.iter().zip(*b).all(|(x, y)| x.abs_diff(*y) <= 1)).count();
        let share = close as f64 / live.depth.len() as f64;
        let verdict = judge(&rgb(&baked), &rgb(&live), Limits::default()).expect("both are of one size");
        let Verdict { structure, flip, .. } = &verdict;
        eprintln!(
            "{scene}: {:.3} % agree, structure {:.5}, window {:.4}, FLIP {flip:.6}",
            share * 100.0,
            structure.mean,
            structure.least
        );
        let is_same = share >= LEAST_AGREEMENT && verdict.passes();
        (!is_same).then(|| format!("{scene}: {share:.5} of the pixels agree, {:?}", verdict.broken()))
    }));
}

#[test]
fn a_picture_drawn_twice_is_the_same() {
    let Some(gpu) = device::gpu() else { return };
    let compiled = expect_compiled(outcome("tests/cases/lights/soft.ron", Mode::Live));
    let draw = || picture(gpu, &compiled, [80, 60], View::Color).radiance;
    assert_eq!(draw(), draw());
}
