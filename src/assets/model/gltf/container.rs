//! The two parts of a glTF file: its JSON, and the bytes that a binary one brings along (glTF 2.0, 4.4).

/// The JSON, and the bytes of the first buffer where they are in the same file.
///
/// # Errors
/// Why it is no such file, in words that follow its name.
pub fn split(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), String> {
    if !bytes.starts_with(MAGIC) {
        return Ok((bytes, None));
    }
    let length = word(bytes, 8).map_or(HEADER, |length| length as usize);
    if bytes.len() < length.max(HEADER) {
        return Err(format!("is cut off after {} of {length} bytes", bytes.len()));
    }
    match word(bytes, 4) {
        Some(2) => {}
        Some(1) => return Err("is glTF 1.0: export it as glTF 2.0".into()),
        version => return Err(format!("is glTF {}, which raytoy does not support", version.unwrap_or(0))),
    }
    let (mut json, mut blob) = (None, None);
    let mut rest = &bytes[HEADER..];
    while let (Some(length), Some(kind)) = (word(rest, 0), word(rest, 4)) {
        let end = (length as usize).saturating_add(8);
        let Some(chunk) = rest.get(8..end) else {
            return Err("is damaged: a chunk is longer than the file".into());
        };
        match kind {
            JSON => json = json.or(Some(chunk)),
            BINARY => blob = blob.or(Some(chunk)),
            _ => {}
        }
        rest = &rest[end..];
    }
    Ok((json.ok_or("is damaged: it has no JSON")?, blob))
}

pub const MAGIC: &[u8] = b"glTF";

const HEADER: usize = 12;
const JSON: u32 = u32::from_le_bytes(*b"JSON");
const BINARY: u32 = u32::from_le_bytes(*b"BIN\0");

fn word(bytes: &[u8], at: usize) -> Option<u32> {
    bytes.get(at..)?.first_chunk().copied().map(u32::from_le_bytes)
}
