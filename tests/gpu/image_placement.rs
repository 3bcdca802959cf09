//! Where an image lies on what it is given to, and what it is there: a color, a number, a hole.

use std::path::Path;

use image::{ImageBuffer, Luma, Rgba, RgbaImage};
use raytoy::frame::Moment;
use raytoy::gpu;
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;

use crate::device;

/// A picture of `scene` with a map of four quarters beside it, `map.png`: red, green above blue, white; the
/// right half is as clear as `alpha` says. `height.png` is 20,001 of 65,535 everywhere.
fn render(scene: &str, alpha: u8, size: [u32; 2]) -> Option<gpu::Picture> {
    let gpu = device::gpu()?;
    let folder = tempfile::tempdir().unwrap();
    let colors = [RED, GREEN, BLUE, WHITE];
    let map = RgbaImage::from_fn(64, 32, |x, y| {
        let [r, g, b] = colors[(x / 32 + 2 * (y / 16)) as usize];
        Rgba([r, g, b, if x < 32 { 255 } else { alpha }])
    });
    map.save(folder.path().join("map.png")).unwrap();
    let heights = ImageBuffer::<Luma<u16>, _>::from_pixel(2, 2, Luma([20_001]));
    heights.save(folder.path().join("height.png")).unwrap();
    for (name, n) in [("small", 0.01), ("square", 1.0), ("large", 100.0)] {
        let square = format!(
            "v -{n} -{n} 0\nv {n} -{n} 0\nv {n} {n} 0\nv -{n} {n} 0
vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n"
        );
        std::fs::write(folder.path().join(format!("{name}.obj")), square).unwrap();
    }
    std::fs::write(folder.path().join("a.ron"), scene).unwrap();
    let sources = Sources::on_disk(folder.path());
    let outcome = raytoy::compile(&sources, Path::new("a.ron"), Mode::Baked, None);
    let compiled = outcome.compiled.unwrap_or_else(|| panic!("{}", outcome.report));
    let moment = Moment::of(&compiled.scene);
    Some(gpu::render(gpu, &compiled, &moment, size, 1, &mut |_| ()).unwrap())
}

const RED: [u8; 3] = [255, 0, 0];
const GREEN: [u8; 3] = [0, 255, 0];
const BLUE: [u8; 3] = [0, 0, 255];
const WHITE: [u8; 3] = [255; 3];
/// Of a picture of 40 by 40 pixels a point of each quarter: above left and right, below left and right.
const QUARTERS: [[u32; 2]; 4] = [[14, 14], [26, 14], [14, 26], [26, 26]];

fn color(picture: &gpu::Picture, [x, y]: [u32; 2]) -> [u8; 3] {
    let at = 4 * (y * picture.size[0] + x) as usize;
    [picture.rgba[at], picture.rgba[at + 1], picture.rgba[at + 2]]
}

fn assert_quarters(scene: &str, alpha: u8, wanted: [[u8; 3]; 4]) {
    let Some(picture) = render(scene, alpha, [40, 40]) else { return };
    assert_eq!(QUARTERS.map(|at| color(&picture, at)), wanted, "{scene}");
}

#[test]
fn globes_and_panoramas_are_upright_and_readable() {
    let whole = [RED, GREEN, BLUE, WHITE];
    // The middle of a map is at +x: on a globe seen from there, in a sky seen in that direction.
    let globe = |image: &str| {
        format!(
            "(camera: (eye: (9, 0, 0), target: (0, 0, 0), fov_deg: 14), ambient: 1,
            objects: [Sphere(material: (color: {image}))])"
        )
    };
    let sky = |image: &str| {
        format!(
            "(camera: (eye: (0, 0, 0), target: (1, 0, 0), fov_deg: 60), background: {image},
            objects: [Sphere(center: (-9, 0, 0))])"
        )
    };
    for image in [
        r#"Image(file: "map.png")"#,
        r#"Image(file: "map.png", width: 6.2831853)"#,
        r#"Image(file: "map.png", at: Spherical())"#,
        r#"Image(file: "map.png", fit: Whole, width: 3)"#,
    ] {
        assert_quarters(&globe(image), 255, whole);
        assert_quarters(&sky(image), 255, whole);
    }
    // What was right before: the corner is at uv = (0, 0) where a mapping moves an image of a given width.
    let moved =
        r#"Image(file: "map.png", width: 6.2831853, at: Translate(offset: (-3.1415927, -1.5707963, 0)))"#;
    assert_quarters(&sky(moved), 255, whole);
}

#[test]
fn a_model_with_uv_shows_a_picture_once() {
    let scene = |image: &str| {
        format!(
            "(camera: (eye: (0, 0, 9), target: (0, 0, 0), fov_deg: 14), ambient: 1,
            objects: [Mesh(file: \"square.obj\", material: (color: {image}))])"
        )
    };
    assert_quarters(&scene(r#"Image(file: "map.png")"#), 255, [RED, GREEN, BLUE, WHITE]);
    // By its own shape it is half as high as wide, and so it comes twice.
    let units = scene(r#"Image(file: "map.png", fit: Units)"#);
    let Some(picture) = render(&units, 255, [40, 40]) else { return };
    assert_eq!([7, 15, 24, 33].map(|y| color(&picture, [14, y])), [RED, BLUE, RED, BLUE]);
}

#[test]
fn where_an_image_is_clear_another_texture_is_seen() {
    let scene = |image: &str| {
        format!(
            "(camera: (eye: (0, 0, 9), target: (0, 0, 0), fov_deg: 14), ambient: 1, objects: [
            Quad(corner: (-1, -0.5, 0), u: (2, 0, 0), v: (0, 1, 0), material: (color: {image}))])"
        )
    };
    let image = |fields: &str| scene(&format!(r#"Image(file: "map.png", width: 2{fields})"#));
    assert_quarters(&image(""), 255, [RED, GREEN, BLUE, WHITE]);
    assert_quarters(&image(""), 0, [RED, WHITE, BLUE, WHITE]);
    assert_quarters(&image(r#", under: "lime""#), 0, [RED, GREEN, BLUE, GREEN]);
    assert_quarters(&image(r##", under: Checker(even: "#f00", odd: "#f00")"##), 0, [RED, RED, BLUE, RED]);
    assert_quarters(&image(", channel: Alpha"), 0, [WHITE, [0; 3], WHITE, [0; 3]]);
    assert_quarters(&image(", channel: Green"), 255, [[0; 3], WHITE, [0; 3], WHITE]);
    // A decal: beyond its edges, too.
    let decal = r#"Image(file: "map.png", width: 1, repeat: false, under: "lime")"#;
    assert_quarters(&scene(decal), 255, [GREEN, GREEN, WHITE, GREEN]);
}

#[test]
fn a_height_map_is_numbers_of_sixteen_bits() {
    let scene = |height: &str, textures: &str| {
        format!(
            "(camera: (eye: (0, 3, 0), target: (0, 0, 0), up: (0, 0, 1)), {textures}
            objects: [Heightfield(height: {height}, size: (4, 2, 4))])"
        )
    };
    let named = r#"textures: { "map": Image(file: "height.png") },"#;
    for (height, textures) in [(r#"Image(file: "height.png")"#, ""), (r#""map""#, named)] {
        let Some(picture) = render(&scene(height, textures), 255, [1, 1]) else { return };
        let (found, wanted) = (3.0 - picture.depth[0], 2.0 * 20_001.0 / 65_535.0);
        // Half of a 16 bit step, and what a ray loses on its way.
        assert!((found - wanted).abs() < 3e-5, "{height}: {found}, wanted {wanted}");
    }
    // As light, 20,001 of 65,535 is 0.076.
    let light = r#"Image(file: "height.png", encoding: Srgb)"#;
    let Some(picture) = render(&scene(light, ""), 255, [1, 1]) else { return };
    assert!((3.0 - picture.depth[0] - 2.0 * 0.0759).abs() < 1e-3, "{}", picture.depth[0]);
}

#[test]
fn uv_of_a_model_filter_by_their_own_scale() {
    let Some(_) = device::gpu() else { return };
    // A fine pattern of uv on squares whose files differ in size: from near each line of it is seen, from afar its mean.
    for (name, size) in [("small", 1e-2), ("square", 1.0), ("large", 1e2_f32)] {
        for material in [r#"Image(file: "map.png", width: 0.03125)"#, "Stripes(scale: 64)"] {
            for (share, is_near) in [(1.0, false), (1.0 / 64.0, true)] {
                let eye = share * size * 8.0;
                let scene = format!(
                    "(camera: (eye: ({0}, {0}, {eye}), target: ({0}, {0}, 0), fov_deg: 14), ambient: 1,
                    objects: [Mesh(file: \"{name}.obj\", material: (color: {material}))])",
                    0.01 * size,
                );
                let Some(picture) = render(&scene, 255, [16, 16]) else { return };
                let colors: Vec<_> = (0..256).map(|i| color(&picture, [i % 16, i / 16])).collect();
                let spread = (0..3).map(|k| {
                    let column = colors.iter().map(|color| color[k]);
                    column.clone().max().unwrap() - column.min().unwrap()
                });
                let spread = spread.max().unwrap();
                let what = format!("{material} on {name}, near: {is_near}: {spread}");
                assert!(if is_near { spread > 150 } else { spread < 30 }, "{what}");
            }
        }
    }
}
