//! Picture files as strangers have them: named wrongly, of rare kinds, turned, damaged, of other formats.

use std::fs;
use std::io::Cursor;
use std::path::Path;

use glam::Vec4;
use image::{DynamicImage, ImageFormat, Rgb, Rgb32FImage, RgbImage};
use raytoy::assets::{Image, Reading};
use raytoy::compile;
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;

const PROGRESSIVE: &[u8] = include_bytes!("picture_files/progressive.jpg");
const CMYK: &[u8] = include_bytes!("picture_files/cmyk.jpg");
const INTERLACED: &[u8] = include_bytes!("picture_files/interlaced.png");

fn read(bytes: &[u8]) -> Result<Image, String> {
    Image::decode("a".into(), 0, bytes, Reading { has_curve: false, channel: None })
}

fn encoded(picture: impl Into<DynamicImage>, format: ImageFormat) -> Vec<u8> {
    let mut bytes = Cursor::new(vec![]);
    picture.into().write_to(&mut bytes, format).expect("it is written");
    bytes.into_inner()
}

fn red(format: ImageFormat) -> Vec<u8> {
    encoded(RgbImage::from_pixel(16, 16, Rgb([230, 30, 40])), format)
}

/// An OpenEXR file of one row, 16-bit numbers, with these channels.
fn openexr(channels: &[(&str, [f32; 2])]) -> Vec<u8> {
    use exr::prelude::{
        AnyChannel, AnyChannels, Encoding, FlatSamples, Layer, LayerAttributes, WritableImage, f16,
    };
    let channel = |(name, values): &(&str, [f32; 2])| {
        AnyChannel::new(*name, FlatSamples::F16(values.map(f16::from_f32).to_vec()))
    };
    let channels = AnyChannels::sort(channels.iter().map(channel).collect());
    let attributes = LayerAttributes::named("first");
    let layer = Layer::new((2, 1), attributes, Encoding::SMALL_LOSSLESS, channels);
    let mut bytes = Cursor::new(vec![]);
    exr::prelude::Image::from_layer(layer).write().non_parallel().to_buffered(&mut bytes).unwrap();
    bytes.into_inner()
}

/// What `raytoy check` says of a scene with `bytes` in a file of this name.
fn said(name: &str, bytes: &[u8]) -> (bool, String) {
    let folder = tempfile::tempdir().expect("there is room");
    fs::write(folder.path().join(name), bytes).expect("it is writable");
    let scene = folder.path().join("a.ron");
    let text = format!(
        "(camera: (eye: (0, 1, 5), target: (0, 0, 0)), materials: {{\"a\": (color: Image(file: \
         {name:?}))}}, objects: [Sphere(material: \"a\")])"
    );
    fs::write(&scene, text).expect("it is writable");
    let outcome = compile(&Sources::on_disk(folder.path()), Path::new(&scene), Mode::Baked, None);
    let texts = outcome.report.diagnostics.iter().map(|d| format!("{}\n{}\n", d.message, d.help.join("\n")));
    (outcome.compiled.is_some(), texts.collect())
}

#[test]
fn contents_count_and_names_do_not() {
    let light = encoded(Rgb32FImage::from_pixel(16, 16, Rgb([0.9, 0.12, 0.16])), ImageFormat::Hdr);
    let exr = openexr(&[("R", [0.9; 2]), ("G", [0.12; 2]), ("B", [0.16; 2])]);
    for (name, bytes) in [
        ("jpeg.png", red(ImageFormat::Jpeg)),
        ("png.jpg", red(ImageFormat::Png)),
        ("radiance.png", light),
        ("exr.hdr", exr),
        ("progressive.png", PROGRESSIVE.to_vec()),
        ("cmyk", CMYK.to_vec()),
    ] {
        assert_eq!(said(name, &bytes), (true, String::new()), "{name}");
        let found = read(&bytes).unwrap().levels[0].texels[0];
        assert!(found.distance(Vec4::new(0.9, 0.12, 0.16, 1.0)) < 0.05, "{name}: {found}");
    }
}

#[test]
fn an_interlaced_png_is_in_order() {
    let image = read(INTERLACED).unwrap();
    for (i, texel) in image.levels[0].texels.iter().enumerate() {
        let wanted = 1.0 - (i / 8) as f32 / 7.0;
        assert!((texel.x - wanted).abs() < 0.01, "{i}: {texel}, wanted {wanted}");
    }
}

#[test]
fn one_gray_of_a_png_may_be_clear() {
    let mut bytes = vec![];
    let mut encoder = png::Encoder::new(&mut bytes, 2, 1);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.set_depth(png::BitDepth::One);
    encoder.set_trns(&[0, 1][..]);
    encoder.write_header().unwrap().write_image_data(&[0x40]).unwrap();
    let image = read(&bytes).unwrap();
    assert!(image.has_alpha);
    assert_eq!(image.levels[0].texels, [Vec4::W, Vec4::ZERO]);
}

#[test]
fn a_png_stands_as_its_camera_was_held() {
    // White, black.
    let plain =
        encoded(RgbImage::from_fn(2, 1, |x, _| Rgb([if x == 0 { 255 } else { 0 }; 3])), ImageFormat::Png);
    let head = 8 + 25;
    for place in [head, plain.len() - 12] {
        for (orientation, size, first) in
            [(1, [2, 1], 1.0), (2, [2, 1], 0.0), (6, [1, 2], 1.0), (8, [1, 2], 0.0)]
        {
            let mut chunk = b"eXIfMM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0".to_vec();
            chunk.extend([orientation, 0, 0, 0, 0, 0, 0]);
            let sum = png_sum(&chunk).to_be_bytes();
            let length = (chunk.len() as u32 - 4).to_be_bytes();
            let bytes = [&plain[..place], &length, &chunk, &sum, &plain[place..]].concat();
            let image = read(&bytes).unwrap();
            let texel = image.levels[0].texels[0].x;
            assert_eq!((image.levels[0].size, texel), (size, first), "{orientation} at {place}");
        }
    }
}

/// CRC-32, as each chunk of a PNG ends in it.
fn png_sum(bytes: &[u8]) -> u32 {
    let step = |sum: u32, _| if sum & 1 == 1 { (sum >> 1) ^ 0xedb8_8320 } else { sum >> 1 };
    !bytes.iter().fold(!0, |sum, byte| (0..8).fold(sum ^ u32::from(*byte), step))
}

#[test]
fn radiance_may_be_xyz() {
    // White of Radiance: X = Y = Z, then red of Rec. 709 about that white.
    for (xyz, wanted) in [([128, 128, 128], [1.0, 1.0, 1.0]), ([132, 68, 6], [2.09, 0.01, 0.0])] {
        let header = b"#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n";
        let image = read(&[&header[..], &xyz, &[129]].concat()).unwrap();
        let found = image.levels[0].texels[0].truncate();
        assert!(found.distance(wanted.into()) < 0.1, "{xyz:?}: {found}, wanted {wanted:?}");
    }
}

#[test]
fn openexr_is_light() {
    let texels =
        |channels: &[(&str, [f32; 2])]| read(&openexr(channels)).map(|i| i.levels[0].texels.to_vec());
    // Beyond white, no numbers, and color times alpha.
    let color =
        [("R", [64.0, f32::NAN]), ("G", [0.5, f32::INFINITY]), ("B", [-1.0, 0.25]), ("A", [1.0, 0.5])];
    let wanted = [Vec4::new(64.0, 0.5, 0.0, 1.0), Vec4::new(0.0, 0.0, 0.25, 0.5)];
    assert_eq!(texels(&color).unwrap(), wanted);
    let gray = [Vec4::new(3.0, 3.0, 3.0, 1.0), Vec4::new(4.0, 4.0, 4.0, 1.0)];
    assert_eq!(texels(&[("Y", [3.0, 4.0]), ("Z", [9.0, 9.0])]).unwrap(), gray);
    assert_eq!(texels(&[("Z", [9.0, 9.0])]), Err("has no channels R, G, B or Y".into()));
    let whole = openexr(&color);
    for end in [4, 8, 50, whole.len() - 1] {
        let said = read(&whole[..end]).expect_err("it is cut off");
        assert!(said.starts_with("is damaged: "), "{end}: {said}");
    }
}

#[test]
fn what_is_cut_off_is_said() {
    let picture = || RgbImage::from_fn(64, 64, |x, y| Rgb([x as u8 * 4, y as u8 * 4, (x * y) as u8]));
    let (jpeg, png) = (encoded(picture(), ImageFormat::Jpeg), encoded(picture(), ImageFormat::Png));
    for end in [jpeg.len() / 2, jpeg.len() * 3 / 4, jpeg.len() - 1] {
        let (is_read, text) = said("a.jpg", &jpeg[..end]);
        assert!(is_read && text.contains("`a.jpg` ends early"), "{end}: {text}");
    }
    // What cameras lay behind the end, and a picture in the head.
    let head = [b"\xff\xd8\xff\xe2\0\x06\xff\xd9\xff\xd9", &jpeg[2..]].concat();
    let behind = [&jpeg[..], b"MotionPhoto"].concat();
    assert!(read(&head).unwrap().warning.is_none() && read(&behind).unwrap().warning.is_none());
    assert!(read(&head[..head.len() - 2]).unwrap().warning.is_some());
    for end in [png.len() / 2, png.len() - 20] {
        let (is_read, text) = said("a.png", &png[..end]);
        assert!(!is_read && text.contains("`a.png` is damaged or ends early"), "{end}: {text}");
    }
}

#[test]
fn other_formats_are_refused_by_name() {
    for (start, wanted) in [
        (&b""[..], "is empty"),
        (b"RIFF\x10\0\0\0WEBPVP8 ", "is WebP"),
        (b"GIF89a\x01\0\x01\0", "is GIF"),
        (b"II*\0\x08\0\0\0", "is TIFF"),
        (b"MM\0*\0\0\0\x08", "is TIFF"),
        (b"BM\x3a\0\0\0\0\0\0\0\x36\0\0\0", "is BMP"),
        (b"\0\0\0\x1cftypavif\0\0\0\0", "is AVIF"),
        (b"\0\0\0\x18ftypheic\0\0\0\0", "is HEIC"),
        (b"\xff\x0a\xfa", "is JPEG XL"),
        (b"\0\0\0\x0cjP  \r\n", "is JPEG 2000"),
        (b"DDS |\0\0\0", "is DDS"),
        (b"8BPS\0\x01", "is a Photoshop file"),
        (b"P6\n2 2\n255\n", "is a Netpbm file"),
        (b"<?xml version=\"1.0\"?>\n<svg xmlns=", "is an SVG file"),
        (b"\n<!DOCTYPE html><title>404", "is a web page"),
        (b"version https://git-lfs.github.com/spec/v1\n", "is a pointer of Git LFS"),
        (b"words", "is neither PNG, JPEG, Radiance HDR nor OpenEXR"),
    ] {
        let (is_read, text) = said("a.png", start);
        assert!(!is_read && text.contains(&format!("`a.png` {wanted}")), "{wanted}: {text}");
        assert!(text.contains("PNG"), "no way out: {text}");
    }
}
