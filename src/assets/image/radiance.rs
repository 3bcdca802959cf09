//! Radiance HDR: the header, in full, around the pixels that the `image` crate decodes.

use std::str::FromStr;

use glam::Vec3;
use image::{DynamicImage, ImageFormat, Rgb, Rgb32FImage};

use super::check_size;

pub fn is_radiance(bytes: &[u8]) -> bool {
    bytes.starts_with(b"#?")
}

/// The light before any exposure, upright.
///
/// # Errors
/// Why it cannot be shown.
pub fn decode(bytes: &[u8]) -> Result<DynamicImage, String> {
    let mut rest = bytes;
    let mut factor = Vec3::ONE;
    let mut is_xyz = false;
    loop {
        let line = line(&mut rest)?;
        match line.trim().split_once('=') {
            // Each program that made it brighter added a line.
            Some(("EXPOSURE", value)) => factor /= numbers::<f32>(value)?.first().copied().unwrap_or(1.0),
            Some(("COLORCORR", value)) => match numbers::<f32>(value)?[..] {
                [r, g, b] => factor /= Vec3::new(r, g, b),
                _ => return Err("is damaged: COLORCORR needs three numbers".into()),
            },
            Some(("FORMAT", value)) => is_xyz = value.trim() == "32-bit_rle_xyze",
            _ if line.trim().is_empty() => break,
            _ => {}
        }
    }
    if !factor.is_finite() || factor.min_element() <= 0.0 {
        return Err("is damaged: its exposure must be a number above 0".into());
    }
    let order = line(&mut rest)?;
    let words: Vec<&str> = order.split_whitespace().collect();
    let [outer, rows, inner, columns] = words[..] else {
        return Err(format!("is damaged: `{}` is not a size such as `-Y 512 +X 1024`", order.trim()));
    };
    let axis = |word: &str| matches!(word, "+X" | "-X" | "+Y" | "-Y");
    let ([rows], [columns]) = (&numbers::<u32>(rows)?[..], &numbers::<u32>(columns)?[..]) else {
        return Err("is damaged: its size is 0".into());
    };
    if !axis(outer) || !axis(inner) || outer[1..] == inner[1..] {
        return Err(format!("is damaged: `{outer}` and `{inner}` are not a valid order of rows"));
    }
    check_size([*columns, *rows])?;
    let mut plain = format!("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {rows} +X {columns}\n").into_bytes();
    plain.extend_from_slice(rest);
    let stored = image::load_from_memory_with_format(&plain, ImageFormat::Hdr);
    let stored = stored.map_err(|error| format!("is damaged: {error}"))?.into_rgb32f();
    Ok(DynamicImage::ImageRgb32F(upright(&stored, outer, inner, |texel| {
        let light = Vec3::from(texel) * factor;
        if is_xyz { from_xyz(light) } else { light }.to_array()
    })))
}

/// A picture whose first row goes along `inner`, and whose rows follow each other along `outer`.
fn upright(
    stored: &Rgb32FImage,
    outer: &str,
    inner: &str,
    light: impl Fn([f32; 3]) -> [f32; 3],
) -> Rgb32FImage {
    let (columns, rows) = stored.dimensions();
    let is_by_rows = outer.ends_with('Y');
    let (width, height) = if is_by_rows { (columns, rows) } else { (rows, columns) };
    Rgb32FImage::from_fn(width, height, |x, y| {
        let x = if [outer, inner].contains(&"-X") { width - 1 - x } else { x };
        let y = if [outer, inner].contains(&"+Y") { height - 1 - y } else { y };
        let (column, row) = if is_by_rows { (x, y) } else { (y, x) };
        Rgb(light(stored.get_pixel(column, row).0))
    })
}

/// The next line of the header.
fn line(rest: &mut &[u8]) -> Result<String, String> {
    let end = rest.iter().position(|byte| *byte == b'\n').ok_or("is damaged: its header has no end")?;
    let line = String::from_utf8_lossy(&rest[..end]).into_owned();
    *rest = &rest[end + 1..];
    Ok(line)
}

fn numbers<T: FromStr>(text: &str) -> Result<Vec<T>, String> {
    let words = text.split_whitespace();
    let numbers: Result<_, _> = words.map(str::parse).collect();
    numbers.map_err(|_| format!("is damaged: `{}` is not a number", text.trim()))
}

/// To linear Rec. 709, from the white that Radiance has, 1/3 in x and y.
fn from_xyz(xyz: Vec3) -> Vec3 {
    let rows = [[2.5651, -1.1665, -0.3986], [-1.0217, 1.9777, 0.0439], [0.0753, -0.2543, 1.1892]];
    Vec3::from(rows.map(|row| Vec3::from(row).dot(xyz).max(0.0)))
}
