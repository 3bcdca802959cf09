//! Picture files: what their bytes mean.

use std::io::Cursor;

use glam::Vec4;
use image::{DynamicImage, ImageFormat, Rgb, RgbImage, Rgba, RgbaImage};
use raytoy::assets::{Channel, Image, Reading};

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
