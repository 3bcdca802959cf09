//! `raytoy scene`: the scene that a picture was drawn from.

use std::io::Read;
use std::path::Path;

use super::{Failure, Result, print_result};
use crate::capture::Origin;
use crate::sources::Disk;

pub fn run(picture: &Path) -> Result {
    let origin = origin(picture, &bytes(picture)?)?;
    for (what, text) in &origin.notes {
        eprintln!("{what}: {text}");
    }
    print_result(&origin.scene)
}

/// What is at `path`, or comes by standard input where that is `-`.
pub fn bytes(path: &Path) -> Result<Vec<u8>> {
    if path == Path::new("-") {
        let mut bytes = vec![];
        std::io::stdin().read_to_end(&mut bytes)?;
        Ok(bytes)
    } else {
        let bytes = Disk::new(None).sources().bytes(path);
        bytes.map(|bytes| bytes.to_vec()).map_err(|problem| Failure::Call(problem.message))
    }
}

/// What the PNG file of `bytes` carries.
pub fn origin(picture: &Path, bytes: &[u8]) -> Result<Origin> {
    let name = picture.display();
    let read = Origin::read(bytes)
        .map_err(|why| Failure::Call(format!("cannot read `{name}` as a PNG file: {why}")))?;
    read.ok_or_else(|| {
        Failure::Call(format!("`{name}` contains no scene; only PNG files written by raytoy contain one"))
    })
}
