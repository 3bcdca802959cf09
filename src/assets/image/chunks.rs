//! The chunks of a PNG: names and contents, as far as the file goes.

/// All chunks of `bytes` in their order; none where they are no PNG.
pub fn chunks(bytes: &[u8]) -> impl Iterator<Item = (&[u8], &[u8])> {
    let mut rest = bytes.strip_prefix(b"\x89PNG\r\n\x1a\n").unwrap_or_default();
    std::iter::from_fn(move || {
        let (length, after) = rest.split_first_chunk()?;
        let (name, after) = after.split_at_checked(4)?;
        let (content, after) = after.split_at_checked(u32::from_be_bytes(*length) as usize)?;
        // Behind its sum of four bytes.
        rest = after.get(4..).unwrap_or_default();
        Some((name, content))
    })
}
