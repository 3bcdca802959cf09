//! The buffers of a glTF file: in it, as text in its JSON, or in files beside it.
//!
//! In: the document and who reads files. Out: bytes.

use std::sync::Arc;

use super::document::{Document, View, at};
use crate::assets::model::Beside;

/// What a buffer holds.
pub enum Buffer<'a> {
    Here(&'a [u8]),
    Decoded(Vec<u8>),
    Beside(Arc<[u8]>),
    /// Nothing stands for it.
    Missing,
}

/// # Errors
/// Why one cannot be read, in words that follow the file's name.
pub fn read<'a>(
    document: &Document,
    blob: Option<&'a [u8]>,
    beside: &mut Beside<'_>,
) -> Result<Vec<Buffer<'a>>, String> {
    let buffers = document.buffers.iter().enumerate();
    let buffer = |(index, buffer): (usize, &super::document::Buffer)| match (&buffer.uri, blob) {
        (Some(uri), _) => located(uri, beside),
        (None, Some(blob)) if index == 0 => Ok(Buffer::Here(blob)),
        (None, _) => Ok(Buffer::Missing),
    };
    buffers.map(buffer).collect()
}

/// The bytes of a view.
///
/// # Errors
/// Why there are none, in words that follow the file's name.
pub fn viewed<'b>(buffers: &'b [Buffer<'_>], view: &View) -> Result<&'b [u8], String> {
    if let Some(extension) = view.extensions.keys().find(|name| name.ends_with("meshopt_compression")) {
        return Err(super::extensions::compressed("Meshopt", extension));
    }
    let bytes: &[u8] = match at(buffers, view.buffer, "buffer")? {
        Buffer::Here(bytes) => bytes,
        Buffer::Decoded(bytes) => bytes,
        Buffer::Beside(bytes) => bytes,
        Buffer::Missing => return Err("is damaged: a buffer is missing".into()),
    };
    let end = view.byte_offset.checked_add(view.byte_length);
    let found = end.and_then(|end| bytes.get(view.byte_offset..end));
    found.ok_or_else(|| "is damaged: the data of its corners is outside of its buffers".into())
}

fn located<'a>(uri: &str, beside: &mut Beside<'_>) -> Result<Buffer<'a>, String> {
    if let Some(data) = uri.strip_prefix("data:") {
        let (_, text) = data.split_once(";base64,").ok_or("is damaged: a buffer is not valid base64")?;
        let bytes = from_base64(text).ok_or("is damaged: a buffer is not valid base64")?;
        return Ok(Buffer::Decoded(bytes));
    }
    if uri.contains("://") {
        return Err(format!(
            "needs `{uri}` from the network, which raytoy does not read: export the model as one .glb"
        ));
    }
    beside(&from_percents(uri)).map(Buffer::Beside)
}

/// RFC 4648, with or without the signs that fill it up.
fn from_base64(text: &str) -> Option<Vec<u8>> {
    let digit = |byte: u8| match byte {
        b'A'..=b'Z' => Some(byte - b'A'),
        b'a'..=b'z' => Some(byte - b'a' + 26),
        b'0'..=b'9' => Some(byte - b'0' + 52),
        b'+' | b'-' => Some(62),
        b'/' | b'_' => Some(63),
        _ => None,
    };
    let text = text.trim_end_matches('=').as_bytes();
    let mut found = Vec::with_capacity(text.len() / 4 * 3 + 2);
    for four in text.chunks(4) {
        let mut bits = 0_u32;
        for byte in four {
            bits = bits << 6 | u32::from(digit(*byte)?);
        }
        let bytes = (bits << (6 * (4 - four.len()))).to_be_bytes();
        found.extend(&bytes[1..four.len().max(1)]);
    }
    Some(found)
}

/// `my%20model.bin` is the file `my model.bin`.
fn from_percents(uri: &str) -> String {
    let mut found = vec![];
    let mut rest = uri.as_bytes();
    while let Some((first, others)) = rest.split_first() {
        let code = others.get(..2).and_then(|two| std::str::from_utf8(two).ok());
        match code.and_then(|code| u8::from_str_radix(code, 16).ok()).filter(|_| *first == b'%') {
            Some(byte) => {
                found.push(byte);
                rest = &others[2..];
            }
            None => {
                found.push(*first);
                rest = others;
            }
        }
    }
    String::from_utf8(found).unwrap_or_else(|_| uri.to_owned())
}
