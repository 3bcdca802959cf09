//! Picture files: what their bytes mean, and where a picture lies on what it is given to.

use crate::device;
use std::io::Cursor;
use std::path::Path;

use glam::Vec4;
use image::{DynamicImage, ImageBuffer, ImageFormat, Luma, Rgb, RgbImage, Rgba, RgbaImage};
use raytoy::frame::Moment;
use raytoy::gpu;
use raytoy::library::{Channel, Image, Reading};
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;

const COLOR: Reading = Reading { has_curve: true, channel: None };
const DATA: Reading = Reading { has_curve: false, channel: None };

fn number(channel: Channel) -> Reading {
    Reading { has_curve: false, channel: Some(channel) }
}

/// The texels of `bytes`, and how many are in a row.
fn texels(bytes: &[u8], reading: Reading) -> Result<(u32, Vec<Vec4>), String> {
    let image = Image::decode("a".into(), 0, bytes, reading)?;
    Ok((image.levels[0].size[0], image.levels[0].texels.clone()))
}

fn encoded(picture: impl Into<DynamicImage>, format: ImageFormat) -> Vec<u8> {
    let mut bytes = vec![];
    picture.into().write_to(&mut Cursor::new(&mut bytes), format).expect("it is written");
    bytes
}

fn png(picture: impl Into<DynamicImage>) -> Vec<u8> {
    encoded(picture, ImageFormat::Png)
}

fn assert_near(found: Vec4, wanted: [f32; 4]) {
    assert!(found.distance(Vec4::from(wanted)) < 1e-3, "{found}, wanted {wanted:?}");
}

#[test]
fn a_clear_pixel_has_no_color() {
    let picture = RgbaImage::from_fn(2, 1, |x, _| Rgba([255, 0, 255, if x == 0 { 0 } else { 128 }]));
    let image = Image::decode("a".into(), 0, &png(picture), COLOR).unwrap();
    assert!(image.has_alpha);
    let half = 128.0 / 255.0;
    assert_near(image.levels[0].texels[0], [0.0; 4]);
    assert_near(image.levels[0].texels[1], [half, 0.0, half, half]);
    // Seen from afar, too.
    assert_near(image.levels[1].texels[0], [half / 2.0, 0.0, half / 2.0, half / 2.0]);
    let opaque = png(RgbaImage::from_pixel(1, 1, Rgba([9, 9, 9, 255])));
    assert!(!Image::decode("a".into(), 0, &opaque, COLOR).unwrap().has_alpha);
}

#[test]
fn bytes_are_light_or_numbers() {
    let bytes = png(RgbaImage::from_pixel(1, 1, Rgba([255, 128, 0, 51])));
    let read = |reading| texels(&bytes, reading).unwrap().1[0];
    assert_near(read(COLOR), [0.2, 0.2 * 0.21586, 0.0, 0.2]);
    assert_near(read(DATA), [0.2, 0.2 * 0.50196, 0.0, 0.2]);
    let first = |channel| read(number(channel)).x;
    let channels = [Channel::Red, Channel::Green, Channel::Blue, Channel::Alpha, Channel::Luminance];
    assert_near(Vec4::from_slice(&channels.map(first)[..4]), [1.0, 0.50196, 0.0, 0.2]);
    assert!((first(Channel::Luminance) - 0.2 * (0.2126 + 0.7152 * 0.50196)).abs() < 1e-4);
}

#[test]
fn every_kind_of_png_is_read() {
    use png::{BitDepth, ColorType};
    let cases: [(ColorType, BitDepth, &[u8], [f32; 4]); 7] = [
        (ColorType::Grayscale, BitDepth::One, &[0x80], [1.0, 1.0, 1.0, 1.0]),
        (ColorType::Grayscale, BitDepth::Four, &[0x50], [1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0, 1.0]),
        (ColorType::Grayscale, BitDepth::Sixteen, &[0x40, 0x01], [0.25002, 0.25002, 0.25002, 1.0]),
        (ColorType::GrayscaleAlpha, BitDepth::Eight, &[255, 51], [0.2, 0.2, 0.2, 0.2]),
        (ColorType::Indexed, BitDepth::Two, &[0x40], [0.2, 0.0, 0.0, 0.2]),
        (ColorType::Rgb, BitDepth::Sixteen, &[255, 255, 0, 0, 0x33, 0x33], [1.0, 0.0, 0.2, 1.0]),
        (ColorType::Rgba, BitDepth::Sixteen, &[255, 255, 0, 0, 0, 0, 0x33, 0x33], [0.2, 0.0, 0.0, 0.2]),
    ];
    for (color, depth, pixel, wanted) in cases {
        let mut bytes = vec![];
        let mut encoder = png::Encoder::new(&mut bytes, 1, 1);
        encoder.set_color(color);
        encoder.set_depth(depth);
        if color == ColorType::Indexed {
            encoder.set_palette(&[0, 0, 0, 255, 0, 0][..]);
            encoder.set_trns(&[255, 51][..]);
        }
        encoder.write_header().unwrap().write_image_data(pixel).unwrap();
        assert_near(texels(&bytes, DATA).unwrap().1[0], wanted);
    }
}

#[test]
fn a_png_says_its_gamma() {
    let read = |gamma: Option<u32>, is_srgb: bool| {
        let mut bytes = vec![];
        let mut encoder = png::Encoder::new(&mut bytes, 1, 1);
        encoder.set_color(png::ColorType::Grayscale);
        if let Some(gamma) = gamma {
            encoder.set_source_gamma(png::ScaledFloat::from_scaled(gamma));
        }
        if is_srgb {
            encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        }
        encoder.write_header().unwrap().write_image_data(&[128]).unwrap();
        (texels(&bytes, COLOR).unwrap().1[0].x, texels(&bytes, DATA).unwrap().1[0].x)
    };
    let (srgb, plain) = (0.21586, 128.0 / 255.0_f32);
    let power = plain.powf(1.0 / 0.55555);
    for (gamma, is_srgb, wanted) in [
        (None, false, srgb),
        (Some(45455), false, srgb),
        (Some(100_000), false, plain),
        (Some(55_555), false, power),
        (Some(100_000), true, srgb),
    ] {
        let (color, data) = read(gamma, is_srgb);
        assert!((color - wanted).abs() < 1e-4, "{gamma:?} {is_srgb}: {color}, wanted {wanted}");
        assert!((data - plain).abs() < 1e-6, "{gamma:?} {is_srgb}: {data}");
    }
}

#[test]
fn a_photo_stands_as_its_camera_was_held() {
    // White on the left, black on the right; lying on its side it is white on top or at the bottom.
    let picture = RgbImage::from_fn(32, 16, |x, _| Rgb([if x < 16 { 255 } else { 0 }; 3]));
    let plain = encoded(picture, ImageFormat::Jpeg);
    for (orientation, width, first) in [(1, 32, 1.0), (3, 32, 0.0), (6, 16, 1.0), (8, 16, 0.0)] {
        let mut exif = b"\xff\xe1\x00\x22Exif\0\0MM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0".to_vec();
        exif.extend([orientation, 0, 0, 0, 0, 0, 0]);
        let bytes = [&plain[..2], &exif, &plain[2..]].concat();
        let (found, texels) = texels(&bytes, DATA).unwrap();
        assert_eq!(found, width, "orientation {orientation}");
        assert!((texels[0].x - first).abs() < 0.05, "orientation {orientation}: {}", texels[0]);
    }
}

/// A Radiance file of two columns and two rows: 1, 2, 3, 4 in the order of the file.
fn radiance(header: &str, order: &str) -> Vec<u8> {
    let pixels = [1, 2, 3, 4].map(|n| [n * 32, n * 32, n * 32, 131]).concat();
    [format!("#?RGBE\n{header}FORMAT=32-bit_rle_rgbe\n\n{order}\n").as_bytes(), &pixels].concat()
}

#[test]
fn radiance_has_eight_orders_and_exposures() {
    for (order, wanted) in [
        ("-Y 2 +X 2", [1, 2, 3, 4]),
        ("-Y 2 -X 2", [2, 1, 4, 3]),
        ("+Y 2 +X 2", [3, 4, 1, 2]),
        ("+Y 2 -X 2", [4, 3, 2, 1]),
        ("+X 2 -Y 2", [1, 3, 2, 4]),
        ("-X 2 -Y 2", [3, 1, 4, 2]),
        ("+X 2 +Y 2", [2, 4, 1, 3]),
        ("-X 2 +Y 2", [4, 2, 3, 1]),
    ] {
        let (_, found) = texels(&radiance("", order), COLOR).unwrap();
        let found: Vec<f32> = found.iter().map(|texel| texel.x).collect();
        assert_eq!(found, wanted.map(|n| n as f32), "{order}");
    }
    let exposed = radiance("EXPOSURE=2\nEXPOSURE= 4.0\nCOLORCORR=1 2 0.5\n", "-Y 2 +X 2");
    assert_near(texels(&exposed, COLOR).unwrap().1[0], [0.125, 0.0625, 0.25, 1.0]);
    for wrong in ["-Y 2 +Y 2", "-Y 2", "-Y two +X 2", "-Y 0 +X 2", "-Y 90000 +X 90000", "-Y 3 +X 2"] {
        texels(&radiance("", wrong), COLOR).expect_err(wrong);
    }
    texels(&radiance("EXPOSURE=0\n", "-Y 2 +X 2"), COLOR).expect_err("no exposure");
    texels(b"#?RADIANCE", COLOR).expect_err("no header");
}

#[test]
fn damaged_files_are_errors_in_words() {
    let whole = png(RgbImage::from_fn(64, 64, |x, y| Rgb([x as u8, y as u8, (x * y) as u8])));
    for end in [0, 7, 20, 40, whole.len() / 2] {
        let said = texels(&whole[..end], COLOR).expect_err("it is cut off");
        assert!(said.starts_with("is "), "{end}: {said}");
    }
}

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
    let square =
        "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";
    std::fs::write(folder.path().join("square.obj"), square).unwrap();
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
