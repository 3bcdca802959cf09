//! The measures by which pictures are judged: what they give for pairs that are known, and the laws that they keep.

use image::{Rgb, RgbImage};
use raytoy::judge::{
    Area, Broken, Limits, PIXELS_PER_DEGREE, PictureShift, change, flip, flip_map, judge, outliers, structure,
};

const SIZE: [u32; 2] = [48, 32];

/// What flip-evaluator 1.7, the package of FLIP's authors, gives for a pair: pixels per degree, the mean, the
/// most, and the pixel (23, 12).
const PUBLISHED: [(Pair, f64, f64, f64, f64); 6] = [
    (Pair::Patch, PIXELS_PER_DEGREE, 0.03404030576348305, 0.96367836, 0.9224767),
    (Pair::Patch, 30.0, 0.023010922595858574, 0.9789191, 0.8946658),
    (Pair::Shifted, PIXELS_PER_DEGREE, 0.4095951318740845, 0.9788948, 0.3213121),
    (Pair::Shifted, 30.0, 0.5462954044342041, 0.9904776, 0.5723921),
    (Pair::Noisy, PIXELS_PER_DEGREE, 0.02671572007238865, 0.080220945, 0.01148702),
    (Pair::Noisy, 30.0, 0.06503387540578842, 0.15990666, 0.0569769),
];

/// The same for pictures of one color each.
const UNIFORM: [([u8; 3], [u8; 3], f64); 5] = [
    ([0, 0, 0], [255, 255, 255], 0.9673991203308105),
    ([128, 128, 128], [138, 138, 138], 0.14901311695575714),
    ([200, 80, 40], [190, 90, 50], 0.17805863916873932),
    ([0, 255, 0], [0, 0, 255], 1.0),
    ([120, 130, 140], [120, 130, 141], 0.027374261990189552),
];

/// That code computes in 32-bit floats, and takes the root of what they leave of an edge that is not there.
const ROUNDING: f64 = 3e-5;

#[derive(Clone, Copy, Debug)]
enum Pair {
    /// A red patch where there was none.
    Patch,
    /// Moved by a pixel.
    Shifted,
    /// Up to five steps of noise.
    Noisy,
}

#[test]
fn flip_is_what_its_authors_code_gives() {
    for (pair, pixels_per_degree, mean, most, pixel) in PUBLISHED {
        let (a, b) = (pattern(), pair.changed());
        let map = flip_map(&a, &b, pixels_per_degree);
        let at = map[12 * SIZE[0] as usize + 23];
        let largest = map.iter().copied().fold(0.0, f64::max);
        for (what, actual, expected) in
            [("mean", flip(&a, &b, pixels_per_degree), mean), ("most", largest, most), ("pixel", at, pixel)]
        {
            assert!((actual - expected).abs() < ROUNDING, "{pair:?}, {what}: {actual}, not {expected}");
        }
    }
    for (a, b, mean) in UNIFORM {
        let found = flip(&plain(a), &plain(b), PIXELS_PER_DEGREE);
        assert!((found - mean).abs() < ROUNDING, "{a:?} and {b:?}: {found}, not {mean}");
    }
}

#[test]
fn flip_of_plain_greys_is_what_its_formulas_say() {
    // Written anew from the paper: no filter changes a plain picture, and grey has no color for HyAB and Hunt
    // to weigh, so only lightness, the exponent and the two pieces of the scale are left.
    let light = |byte: u8| ((f64::from(byte) / 255.0 + 0.055) / 1.055).powf(2.4);
    let lightness = |byte: u8| 116.0 * light(byte).powf(1.0 / 3.0) - 16.0;
    // Pure green and pure blue in L*a*b*, as tables have them, each color times L*/100.
    let (green, blue) = ([87.735, -86.183, 83.180], [32.297, 79.188, -107.860]);
    let along = |i: usize| 0.01 * (green[0] * green[i] - blue[0] * blue[i]);
    let largest = (f64::abs(green[0] - blue[0]) + f64::hypot(along(1), along(2))).powf(0.7);
    for (a, b) in [(90, 91), (100, 140), (60, 250)] {
        let distance = (lightness(a) - lightness(b)).abs().powf(0.7);
        let knee = 0.4 * largest;
        let expected = match distance < knee {
            true => 0.95 * distance / knee,
            false => 0.95 + 0.05 * (distance - knee) / (largest - knee),
        };
        let found = flip(&plain([a; 3]), &plain([b; 3]), PIXELS_PER_DEGREE);
        assert!((found - expected).abs() < 5e-4, "{a} and {b}: {found}, not {expected}");
    }
}

#[test]
fn a_picture_beside_itself_has_no_difference() {
    let verdict = judge(&pattern(), &pattern(), Limits::default()).unwrap();
    assert_eq!(verdict.flip, 0.0);
    assert!(flip_map(&pattern(), &pattern(), PIXELS_PER_DEGREE).iter().all(|x| *x == 0.0));
    assert!((verdict.structure.mean - 1.0).abs() < 1e-12 && (verdict.structure.least - 1.0).abs() < 1e-12);
    assert_eq!((verdict.outliers.count, verdict.outliers.bounds, verdict.outliers.worst), (0, None, None));
    assert!(verdict.passes() && change(&pattern(), &pattern(), 3).is_none());
}

#[test]
fn measures_are_the_same_both_ways() {
    for pair in [Pair::Patch, Pair::Shifted, Pair::Noisy] {
        let (a, b) = (pattern(), pair.changed());
        let close = |x: f64, y: f64| assert!((x - y).abs() < 1e-12, "{pair:?}: {x} and {y}");
        close(flip(&a, &b, 67.0), flip(&b, &a, 67.0));
        close(structure(&a, &b).mean, structure(&b, &a).mean);
        assert_eq!(outliers(&a, &b, 3).count, outliers(&b, &a, 3).count);
    }
}

#[test]
fn more_noise_is_a_larger_difference() {
    let noisy = |strength: i32| {
        changed(|x, y, c| c.map(|byte| shifted(byte, strength * ((x * 7 + y * 13) as i32 % 3 - 1))))
    };
    let all: Vec<_> = [0, 2, 8, 30].map(|s| judge(&pattern(), &noisy(s), Limits::default()).unwrap()).into();
    for pair in all.windows(2) {
        assert!(pair[0].flip < pair[1].flip, "FLIP");
        assert!(pair[0].structure.mean > pair[1].structure.mean, "structure");
        assert!(pair[0].structure.least > pair[1].structure.least, "the worst window");
    }
    let counts: Vec<usize> = all.iter().map(|verdict| verdict.outliers.count).collect();
    assert!(counts.is_sorted() && counts[1] == 0 && counts[2] > 900, "{counts:?}");
}

#[test]
fn structure_of_plain_pictures_is_the_papers_first_factor() {
    // Without variance, SSIM is (2 x y + C1) / (x² + y² + C1), C1 = (0.01 · 255)².
    for (a, b) in [(100.0, 100.0), (100.0, 120.0), (0.0, 255.0)] {
        let expected = (2.0 * a * b + 6.5025) / (a * a + b * b + 6.5025);
        let found = structure(&plain([a as u8; 3]), &plain([b as u8; 3]));
        assert!((found.mean - expected).abs() < 1e-9 && (found.least - expected).abs() < 1e-9, "{a}, {b}");
    }
    // One window: half of it black and half white, beside its negative. Means 127.5, variances 127.5²,
    // covariance -127.5².
    let halves = |flip: u32| {
        RgbImage::from_fn(8, 8, |x, _| Rgb([if (x / 4 + flip).is_multiple_of(2) { 0 } else { 255 }; 3]))
    };
    let square = 127.5 * 127.5;
    let expected = (58.5225 - 2.0 * square) / (58.5225 + 2.0 * square);
    assert!((structure(&halves(0), &halves(1)).mean - expected).abs() < 1e-9);
}

#[test]
fn the_worst_window_sees_what_the_mean_forgives() {
    let speck = changed(|x, y, c| if (x, y) == (40, 20) { [0, 255 - c[1], 0] } else { c });
    let found = structure(&pattern(), &speck);
    assert!(found.mean > 0.998 && found.least < 0.97, "{found:?}");
    let [x, y] = found.least_at;
    assert!((x..x + 8).contains(&40) && (y..y + 8).contains(&20), "{found:?}");
}

#[test]
fn pictures_smaller_than_a_window_are_judged_too() {
    let dot = |byte| RgbImage::from_pixel(1, 3, Rgb([byte; 3]));
    let verdict = judge(&dot(10), &dot(200), Limits::default()).unwrap();
    assert!(verdict.structure.mean < 0.2 && verdict.flip > 0.5, "{verdict:?}");
    assert_eq!(judge(&dot(10), &plain([10; 3]), Limits::default()), Err([(1, 3), (48, 32)]));
}

#[test]
fn outliers_have_a_place_and_a_worst() {
    let patched = Pair::Patch.changed();
    let found = outliers(&pattern(), &patched, 3);
    assert_eq!(found.bounds, Some(Area { x: [20, 25], y: [10, 13] }));
    let worst = found.worst.unwrap();
    assert_eq!(worst.actual, [250, 20, 30]);
    assert_eq!(worst.expected, pattern().get_pixel(worst.at[0], worst.at[1]).0);
    assert_eq!((found.count, found.of), (24, 48 * 32));
    assert_eq!(outliers(&plain([10; 3]), &plain([13; 3]), 3).count, 0);
    assert_eq!(outliers(&plain([10; 3]), &plain([14, 10, 10]), 3).count, 48 * 32);
}

#[test]
fn each_limit_can_be_broken_alone() {
    let loose = Limits { tolerance: 3, outliers: 1.0, structure: -1.0, window: -1.0, flip: 1.0 };
    let broken = |limits: Limits| judge(&pattern(), &Pair::Shifted.changed(), limits).unwrap().broken();
    assert_eq!(broken(loose), []);
    assert_eq!(broken(Limits { outliers: 0.1, ..loose }), [Broken::Outliers]);
    assert_eq!(broken(Limits { structure: 0.9, ..loose }), [Broken::Structure]);
    assert_eq!(broken(Limits { window: 0.5, ..loose }), [Broken::Window]);
    assert_eq!(broken(Limits { flip: 0.2, ..loose }), [Broken::Flip]);
}

#[test]
fn a_change_is_told_in_a_persons_words() {
    let told = |a: [u8; 3], b: [u8; 3]| match change(&plain(a), &plain(b), 3) {
        Some(PictureShift::Shift { word, by }) => format!("{word} by {by:.0}"),
        other => format!("{other:?}"),
    };
    assert_eq!(told([0; 3], [255; 3]), "brighter by 100");
    assert_eq!(told([119; 3], [100; 3]), "darker by 8");
    assert_eq!(told([120, 120, 120], [150, 110, 115]), "redder by 17");
    assert_eq!(told([120, 120, 120], [115, 118, 150]), "bluer by 18");
    let moved = change(&pattern(), &Pair::Shifted.changed(), 3);
    assert!(matches!(moved, Some(PictureShift::Elsewhere { by }) if by > 5.0), "{moved:?}");
}

fn plain(color: [u8; 3]) -> RgbImage {
    RgbImage::from_pixel(SIZE[0], SIZE[1], Rgb(color))
}

/// Ramps and a checker, in whole numbers, so that another program can make the same.
fn pattern() -> RgbImage {
    RgbImage::from_fn(SIZE[0], SIZE[1], |x, y| {
        Rgb([((5 * x + 3 * y) % 256) as u8, ((x / 4 + y / 4) % 2 * 180 + 40) as u8, (x * y % 256) as u8])
    })
}

fn changed(change: impl Fn(u32, u32, [u8; 3]) -> [u8; 3]) -> RgbImage {
    let mut picture = pattern();
    picture.enumerate_pixels_mut().for_each(|(x, y, pixel)| pixel.0 = change(x, y, pixel.0));
    picture
}

fn shifted(byte: u8, by: i32) -> u8 {
    (i32::from(byte) + by).clamp(0, 255) as u8
}

impl Pair {
    fn changed(self) -> RgbImage {
        match self {
            Pair::Patch => {
                changed(
                    |x, y, c| {
                        if (20..26).contains(&x) && (10..14).contains(&y) { [250, 20, 30] } else { c }
                    },
                )
            }
            Pair::Shifted => {
                let before = pattern();
                changed(|x, y, _| before.get_pixel((x + SIZE[0] - 1) % SIZE[0], y).0)
            }
            Pair::Noisy => changed(|x, y, c| {
                let noise = (x * 7 + y * 13) as i32 % 11 - 5;
                c.map(|byte| shifted(byte, noise))
            }),
        }
    }
}
