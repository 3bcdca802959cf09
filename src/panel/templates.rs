//! New files for an author to begin with: a scene, and a texture.
//!
//! In: the scene that is open. Out: a file beside it, or in a folder `textures/` that it finds textures in,
//! that was not there before.

use std::fs::{self, File};
use std::io::{self, ErrorKind, Write as _};
use std::path::{Path, PathBuf};

use crate::library::name_of;
use crate::sources::Disk;

const SCENE: &str = include_str!("templates/untitled.ron");
const TEXTURE: &str = include_str!("templates/my_texture.wgsl");

/// A new texture's file.
#[derive(Debug)]
pub struct Texture {
    pub path: PathBuf,
    /// As scenes call it.
    pub name: String,
}

/// Writes a small scene into the folder of `scene`; its path.
///
/// # Errors
/// Where the file cannot be written.
pub fn new_scene(scene: &Path) -> io::Result<PathBuf> {
    let named = |stem: &str| (scene.with_file_name(format!("{stem}.ron")), SCENE.to_owned());
    write_new("untitled", |_| false, named).map(|(path, _)| path)
}

/// Writes a texture that works into the nearest folder `textures/` in which `scene` finds any, or a new one
/// beside it, under a name that none of these folders has.
///
/// # Errors
/// Where the file cannot be written.
pub fn new_texture(disk: &Disk, scene: &Path) -> io::Result<Texture> {
    let sources = disk.sources();
    let above = sources.reach(scene.parent().unwrap_or(Path::new(""))).folders();
    let folders: Vec<PathBuf> = above.iter().map(|folder| folder.join("textures")).collect();
    let folder = folders.iter().find(|folder| folder.is_dir()).unwrap_or(&folders[0]);
    fs::create_dir_all(folder)?;
    let is_taken = |stem: &str| folders.iter().any(|folder| folder.join(format!("{stem}.wgsl")).exists());
    let named = |stem: &str| {
        let name = name_of(stem);
        let text = TEXTURE.replace("MyTexture", &name).replace("myTexture", &name.replacen('M', "m", 1));
        (folder.join(format!("{stem}.wgsl")), text)
    };
    write_new("my_texture", is_taken, named).map(|(path, stem)| Texture { path, name: name_of(&stem) })
}

/// Writes what `named` gives for `stem`, or for the first of `stem2`, `stem3`, … that is free; its path and
/// stem.
fn write_new(
    stem: &str,
    is_taken: impl Fn(&str) -> bool,
    named: impl Fn(&str) -> (PathBuf, String),
) -> io::Result<(PathBuf, String)> {
    let mut number = 1;
    loop {
        let stem = if number == 1 { stem.to_owned() } else { format!("{stem}{number}") };
        if is_taken(&stem) {
            number += 1;
            continue;
        }
        let (path, text) = named(&stem);
        match File::create_new(&path) {
            Ok(mut file) => return file.write_all(text.as_bytes()).map(|()| (path, stem)),
            Err(error) if error.kind() == ErrorKind::AlreadyExists => number += 1,
            Err(error) => return Err(error),
        }
    }
}
