//! What differs between the shaders of two scenes: the scene's own text, and the files that go with it.

use std::sync::Arc;

use super::text::{TextDifference, with_origin_of};
use crate::compile::Compiled;
use crate::wgsl::{Mode, Section, Target, generate};

/// How the shaders of two scenes differ.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ShaderDifference {
    /// Of the text that is written for the scene, with its numbers written out; None where it is the same.
    pub text: Option<TextDifference>,
    /// Whether all text is the same once the numbers are data, and so no other pipeline is needed.
    pub is_same_live: bool,
    /// The files of the new scene that are called as some of the old one, and hold something else: textures,
    /// shapes, images and models.
    pub files: Vec<String>,
}

impl ShaderDifference {
    /// Both with their numbers written out.
    pub fn between(old: &Compiled, new: &Compiled) -> Self {
        let (golden, actual) = (old.source.generated(), new.source.generated());
        let [live, new_live] =
            [old, new].map(|compiled| generate(&compiled.scene, &Target::raytoy(Mode::Live)));
        let own_is_same = with_origin_of(new_live.generated(), live.generated()) == new_live.generated();
        let texts = |sections: &[Section]| -> Vec<Arc<str>> {
            sections[1..].iter().map(|section| section.text.clone()).collect()
        };
        let files: Vec<String> =
            [other_texts(old, new), other_assets(old, new)].into_iter().flatten().collect();
        Self {
            text: TextDifference::between(&with_origin_of(actual, golden), actual),
            is_same_live: own_is_same
                && texts(&live.sections) == texts(&new_live.sections)
                && files.is_empty(),
            files,
        }
    }

    pub fn is_none(&self) -> bool {
        self.text.is_none() && self.is_same_live
    }

    /// One line of what it is, and one for each object and each file.
    pub fn told(&self) -> Vec<String> {
        let head = match &self.text {
            None if self.is_none() => "equal".into(),
            None => "the scene's own text is equal".into(),
            Some(difference) => {
                let [gone, new] = difference.counts();
                let pipeline = match self.is_same_live {
                    true => "only numbers and comments differ, so the window keeps its pipeline",
                    false => "the window must build a new pipeline",
                };
                format!("{gone} lines removed, {new} added; {pipeline}")
            }
        };
        let objects = self.text.iter().flat_map(TextDifference::told);
        let files = self.files.iter().map(|file| format!("the content of the file `{file}` differs"));
        [head].into_iter().chain(objects).chain(files).collect()
    }
}

/// The textures and shapes of `new` whose text is not that of `old`.
fn other_texts(old: &Compiled, new: &Compiled) -> Vec<String> {
    let others = |section: &&Section| {
        let place = tail(&section.name, 2);
        let before = old.source.sections[1..].iter().find(|before| tail(&before.name, 2) == place);
        before.is_some_and(|before| before.text != section.text)
    };
    let found = new.source.sections[1..].iter().filter(others);
    found.map(|section| section.name.clone()).collect()
}

/// The images and models of `new` whose bytes are not those of `old`.
fn other_assets(old: &Compiled, new: &Compiled) -> Vec<String> {
    let all = |compiled: &Compiled| {
        let images = compiled.scene.images.iter().map(|image| (image.file.clone(), image.digest));
        let models = compiled.scene.models.iter().map(|model| (model.file.clone(), model.digest));
        images.chain(models).collect::<Vec<_>>()
    };
    let before = all(old);
    let others = |(name, digest): &(String, u64)| {
        let mut so_called = before.iter().filter(|(other, _)| tail(other, 1) == tail(name, 1)).peekable();
        so_called.peek().is_some() && so_called.all(|(_, other)| other != digest)
    };
    all(new).into_iter().filter(others).map(|(name, _)| name).collect()
}

/// The last parts of a file's name: the folder that it begins in may be another one. Textures are told from
/// shapes by the last of their folders.
fn tail(name: &str, parts: usize) -> Vec<&str> {
    name.rsplit('/').take(parts).collect()
}
