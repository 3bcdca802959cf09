//! A picture as the bytes of a file, the same bytes for the same picture.

use std::io::{self, Cursor, Write};

use image::{ImageFormat, RgbImage};

use super::{CaptureError, Origin};
use crate::gpu::{Identity, Picture};

/// A PNG file with what the picture is made of as text chunks. `draw` hands over the picture as a screen
/// shows it, a strip after the other from the top.
pub(super) fn png<T>(
    out: &mut dyn Write,
    size: [u32; 2],
    origin: &Origin,
    draw: impl FnOnce(&mut dyn FnMut(&Picture) -> io::Result<()>) -> Result<T, CaptureError>,
) -> Result<T, CaptureError> {
    let mut encoder = png::Encoder::new(out, size[0], size[1]);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::Fast);
    encoder.set_filter(png::Filter::Adaptive);
    for (keyword, text) in origin.chunks() {
        encoder.add_itxt_chunk(keyword, text).map_err(refused)?;
    }
    let mut writer = encoder.write_header().map_err(refused)?;
    let mut rows = writer.stream_writer().map_err(refused)?;
    let drawn = draw(&mut |strip| rows.write_all(&rgb(strip)))?;
    rows.finish().map_err(refused)?;
    writer.finish().map_err(refused)?;
    Ok(drawn)
}

fn refused(error: png::EncodingError) -> CaptureError {
    match error {
        png::EncodingError::IoError(error) => CaptureError::Output(error),
        other => CaptureError::Format(format!("no PNG file: {other}")),
    }
}

/// The picture as a screen shows it, in a small file.
///
/// # Errors
/// Where it is wider or higher than the 65535 pixels of a JPEG.
pub fn jpeg(picture: &Picture) -> Result<Vec<u8>, CaptureError> {
    let image = RgbImage::from_raw(picture.size[0], picture.size[1], rgb(picture));
    let mut bytes = Cursor::new(vec![]);
    let written = image.expect("three bytes a pixel").write_to(&mut bytes, ImageFormat::Jpeg);
    written.map_err(|error| CaptureError::Format(format!("no JPEG file: {error}")))?;
    Ok(bytes.into_inner())
}

/// R, G and B are linear light before exposure; Z is the distance, infinite where the ray leaves the scene;
/// `object` is the index in the scene's list, -1 for none.
pub(super) fn exr(picture: &Picture, seen: &Identity) -> Result<Vec<u8>, CaptureError> {
    use exr::prelude::{
        AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, LayerAttributes, SmallVec,
        WritableImage,
    };
    let channel = |name: &str, values: Vec<f32>| AnyChannel::new(name, FlatSamples::F32(values));
    let light = |i: usize| picture.radiance.iter().map(|texel| texel[i]).collect();
    let [width, height] = picture.size;
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let index = pixels.map(|(x, y)| seen.object(x, y).map_or(-1.0, |object| object as f32)).collect();
    let channels = AnyChannels::sort(SmallVec::from_vec(vec![
        channel("R", light(0)),
        channel("G", light(1)),
        channel("B", light(2)),
        channel("Z", picture.depth.clone()),
        channel("object", index),
    ]));
    let [width, height] = picture.size.map(|n| n as usize);
    let image = Image::from_layer(Layer::new(
        (width, height),
        LayerAttributes::named("raytoy"),
        Encoding::FAST_LOSSLESS,
        channels,
    ));
    let mut bytes = Cursor::new(vec![]);
    let written = image.write().non_parallel().to_buffered(&mut bytes);
    written.map_err(|error| CaptureError::Format(format!("no EXR file: {error}")))?;
    Ok(bytes.into_inner())
}

/// Red, green and blue of each pixel.
fn rgb(picture: &Picture) -> Vec<u8> {
    picture.rgba.chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect()
}
