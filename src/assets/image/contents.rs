//! What a file is by its first bytes, where it is no picture that can be read, and whether a JPEG ends early.

/// Why `bytes` are no picture, in words that follow the file's name.
pub fn refusal(bytes: &[u8]) -> String {
    const NONE: &str = "is neither PNG, JPEG, Radiance HDR nor OpenEXR";
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start();
    let start = text[..text.len().min(1024)].to_ascii_lowercase();
    let has = |word: &[u8]| start.windows(word.len()).any(|part| part == word);
    if bytes.is_empty() {
        return "is empty: save or fetch it again".into();
    }
    if crate::assets::is_lfs_pointer(bytes) {
        return "is a pointer of Git LFS, not the picture: run `git lfs pull` to fetch it".into();
    }
    if start.starts_with(b"<!doctype html") || start.starts_with(b"<html") {
        return "is a web page, not a picture: fetch the picture itself".into();
    }
    if start.starts_with(b"<") && has(b"<svg") {
        return "is an SVG file: save it as PNG".into();
    }
    let format = match bytes {
        [b'R', b'I', b'F', b'F', _, _, _, _, b'W', b'E', b'B', b'P', ..] => "WebP",
        [b'G', b'I', b'F', b'8', ..] => "GIF",
        [b'I', b'I', 42 | 43, 0, ..] | [b'M', b'M', 0, 42 | 43, ..] => "TIFF",
        [b'B', b'M', _, _, _, _, 0, 0, 0, 0, ..] => "BMP",
        [_, _, _, _, b'f', b't', b'y', b'p', b'a', b'v', b'i', b'f' | b's', ..] => "AVIF",
        [_, _, _, _, b'f', b't', b'y', b'p', b'h' | b'm', ..] => "HEIC",
        [0xff, 0x0a, ..] | [0, 0, 0, 12, b'J', b'X', b'L', b' ', ..] => "JPEG XL",
        [0xff, 0x4f, 0xff, 0x51, ..] | [0, 0, 0, 12, b'j', b'P', ..] => "JPEG 2000",
        [b'D', b'D', b'S', b' ', ..] => "DDS",
        [0xab, b'K', b'T', b'X', ..] => "KTX",
        [b'8', b'B', b'P', b'S', ..] => "a Photoshop file",
        [b'P', b'1'..=b'7' | b'F' | b'f', b'\n' | b'\r' | b' ', ..] => "a Netpbm file",
        [b'q', b'o', b'i', b'f', ..] => "QOI",
        _ => return NONE.into(),
    };
    format!("is {format}, which cannot be read: save it as PNG, JPEG or, for light, OpenEXR")
}

/// Whether a JPEG stops before the mark of its end. Decoders fill up what is missing with gray.
pub fn ends_early(jpeg: &[u8]) -> bool {
    let mut at = 2;
    loop {
        match jpeg.get(at..) {
            Some([0xff, 0xd9, ..]) => return false,
            // Fill bytes, codes of pixels that look like marks, and marks without a length.
            Some([0xff, 0xff | 0 | 1 | 0xd0..=0xd8, ..]) => at += 1,
            Some([0xff, _, high, low, ..]) => at += 2 + usize::from(u16::from_be_bytes([*high, *low])),
            Some([_, ..]) => at += 1,
            Some([]) | None => return true,
        }
    }
}
