//! OpenEXR: light, as renderers and sites of panoramas store it. In: the bytes. Out: the first layer's color.

use std::io::Cursor;

use exr::prelude::{FlatSamples, MetaData, ReadChannels, ReadLayers, read};
use image::{DynamicImage, Rgba, Rgba32FImage};

use super::check_size;

pub fn is_openexr(bytes: &[u8]) -> bool {
    bytes.starts_with(b"\x76\x2f\x31\x01")
}

/// Linear light, whose alpha is not in its color, as in other files.
///
/// # Errors
/// Why it cannot be shown.
pub fn decode(bytes: &[u8]) -> Result<DynamicImage, String> {
    let damaged = |error: exr::error::Error| match error {
        exr::error::Error::NotSupported(what) => format!("is an OpenEXR file that cannot be read: {what}"),
        error => format!("is damaged: {error}"),
    };
    let meta = MetaData::read_from_buffered(Cursor::new(bytes), false).map_err(damaged)?;
    for header in &meta.headers {
        check_size([header.layer_size.0, header.layer_size.1].map(|n| u32::try_from(n).unwrap_or(u32::MAX)))?;
    }
    let reader = read().no_deep_data().largest_resolution_level().all_channels().first_valid_layer();
    let image = reader.all_attributes().non_parallel().from_buffered(Cursor::new(bytes)).map_err(damaged)?;
    let layer = image.layer_data;
    let channel = |name: &str| {
        let list = &layer.channel_data.list;
        list.iter().find(|channel| channel.name.eq_case_insensitive(name)).map(|channel| &channel.sample_data)
    };
    let color = ["R", "G", "B"].map(channel);
    let color = if color.iter().all(Option::is_none) { [channel("Y"); 3] } else { color };
    if color.iter().all(Option::is_none) {
        return Err("has no channels R, G, B or Y".into());
    }
    let alpha = channel("A");
    let (width, height) = (layer.size.0 as u32, layer.size.1 as u32);
    let picture = Rgba32FImage::from_fn(width, height, |x, y| {
        let i = y as usize * layer.size.0 + x as usize;
        let alpha = alpha.map_or(1.0, |alpha| value(alpha, i).clamp(0.0, 1.0));
        let light = color.map(|channel| channel.map_or(0.0, |channel| value(channel, i)));
        let [r, g, b] = light.map(|x| if alpha > 0.0 { x / alpha } else { 0.0 });
        Rgba([r, g, b, alpha])
    });
    Ok(DynamicImage::ImageRgba32F(picture))
}

/// A sample, 0 where it is no number or below 0.
fn value(samples: &FlatSamples, i: usize) -> f32 {
    let value = samples.value_by_flat_index(i).to_f32();
    if value.is_finite() { value.max(0.0) } else { 0.0 }
}
