//! `raytoy scene`: the scene that a picture was drawn from.

use std::io::Read;
use std::path::Path;

use super::{Failure, Result, print_result};
use crate::capture::Origin;

pub fn run(picture: &Path) -> Result {
    let name = picture.display();
    let bytes = if picture == Path::new("-") {
        let mut bytes = vec![];
        std::io::stdin().read_to_end(&mut bytes)?;
        bytes
    } else if picture.exists() {
        std::fs::read(picture).map_err(|error| Failure::Call(format!("cannot read `{name}`: {error}")))?
    } else {
        return Err(Failure::Call(format!("there is no file `{name}`")));
    };
    let origin = Origin::read(&bytes)
        .map_err(|why| Failure::Call(format!("cannot read `{name}` as a PNG file: {why}")))?
        .ok_or_else(|| {
            Failure::Call(format!("`{name}` carries no scene; PNG files as raytoy writes them do"))
        })?;
    for (what, text) in &origin.notes {
        eprintln!("{what}: {text}");
    }
    print_result(&origin.scene)
}
