//! When the files of a scene count as changed, and how often they are read to know.

use std::cell::Cell;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use raytoy::sources::{Answer, Sources};
use raytoy::watch::Seen;

use crate::common::folder::Folder;

/// A folder, what a scene in it was answered, and how often a file was read since.
struct Watched {
    folder: Folder,
    seen: Seen,
    reads: Cell<usize>,
}

impl Watched {
    /// A scene in `project/scenes` asks for `files`, which were written this long ago, if they are there.
    fn asking(folder: Folder, files: &[&str], age: Duration) -> Self {
        let project = folder.path().join("project");
        let sources = Sources::on_disk(&project);
        let scenes = project.join("scenes");
        for file in files {
            date(&scenes.join(file), age);
            let _ = sources.reach(&scenes).text(&scenes.join(file));
        }
        Self { folder, seen: Seen::new(sources.asked()), reads: Cell::new(0) }
    }

    /// Whether something counts as changed, and how many files were read to know.
    fn look(&mut self) -> (bool, usize) {
        self.reads.set(0);
        let differs = self.seen.differs(&|path| {
            self.reads.set(self.reads.get() + 1);
            Sources::on_disk(Path::new("/")).read(path)
        });
        (differs, self.reads.get())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }
}

/// Lets the file at `path` be written this long ago.
fn date(path: &Path, age: Duration) {
    if let Ok(file) = File::options().write(true).open(path) {
        file.set_modified(SystemTime::now() - age).expect("times can be set");
    }
}

const OLD: Duration = Duration::from_secs(3600);
const MODEL: &str = "project/scenes/a.obj";

fn with_model() -> Folder {
    let folder = Folder::new();
    folder.write(MODEL, "v 0 0 0\n");
    folder
}

#[test]
fn a_file_at_rest_is_read_once_more_and_then_no_more() {
    let mut old = Watched::asking(with_model(), &["a.obj"], OLD);
    assert_eq!([(); 4].map(|()| old.look()), [(false, 1), (false, 0), (false, 0), (false, 0)]);
    // An event may mean a change that keeps the length and the time.
    old.seen.distrust();
    assert_eq!([(); 2].map(|()| old.look()), [(false, 1), (false, 0)]);
    old.folder.write(MODEL, "v 9 0 0\n");
    date(&old.path(MODEL), OLD);
    old.seen.distrust();
    assert_eq!(old.look(), (true, 1));
}

#[test]
fn another_length_or_time_is_looked_into() {
    for (text, age, differs) in [
        ("v 9 0 0\n", Duration::from_secs(60), true),
        ("v 9 0 0\n", Duration::ZERO, true),
        ("v 0 0 0\n", Duration::from_secs(60), false),
        ("", OLD, true),
    ] {
        let mut watched = Watched::asking(with_model(), &["a.obj"], OLD);
        assert_eq!([(); 2].map(|()| watched.look()), [(false, 1), (false, 0)]);
        watched.folder.write(MODEL, text);
        date(&watched.path(MODEL), age);
        assert_eq!(watched.look(), (differs, 1), "{text:?} {age:?}");
    }
    let mut watched = Watched::asking(with_model(), &["a.obj"], OLD);
    watched.look();
    std::fs::remove_file(watched.path(MODEL)).expect("it is there");
    assert!(watched.look().0);
}

#[test]
fn a_young_file_is_read_until_its_time_can_be_trusted() {
    let mut young = Watched::asking(with_model(), &["a.obj"], Duration::ZERO);
    assert_eq!([(); 3].map(|()| young.look()), [(false, 1); 3]);
    // Two saves in one tick of the clock, of one length.
    let written = young.path(MODEL).metadata().and_then(|found| found.modified()).expect("there are times");
    young.folder.write(MODEL, "v 9 0 0\n");
    File::options().write(true).open(young.path(MODEL)).expect("it is there").set_modified(written).unwrap();
    assert_eq!(young.look(), (true, 1));
}

#[test]
fn a_refusal_is_no_change_until_it_would_be_taken_back() {
    let refused = |file: &str| {
        let folder = with_model();
        folder.write("outside.obj", "v 0 0 0\n");
        folder.write("project/scenes/folder/b.obj", "");
        folder.write("project/scenes/huge.obj", "");
        let huge = File::options().write(true).open(folder.path().join("project/scenes/huge.obj"));
        huge.and_then(|file| file.set_len((16 << 20) + 1)).expect("a file may have a hole");
        let mut watched = Watched::asking(folder, &[file], OLD);
        assert!(!watched.look().0 && !watched.look().0, "{file}");
        watched
    };
    let mut outside = refused("../../outside.obj");
    assert_eq!(outside.look(), (false, 0), "nobody reads it");
    outside.folder.write("outside.obj", "v 1 0 0\n");
    assert_eq!(outside.look(), (false, 0));
    let mut missing = refused("folder/b.obj/c.obj");
    assert!(!missing.look().0);
    let mut missing = refused("b.obj");
    missing.folder.write("project/scenes/b.obj", "");
    assert!(missing.look().0);
    let mut folder = refused("folder");
    std::fs::remove_dir_all(folder.path("project/scenes/folder")).expect("it is there");
    assert!(folder.look().0);
    let mut huge = refused("huge.obj");
    assert_eq!(huge.look(), (false, 0), "nobody reads it");
    huge.folder.write("project/scenes/huge.obj", "v 0 0 0\n");
    assert!(huge.look().0);
}

#[cfg(unix)]
#[test]
fn a_link_that_leads_outside_is_no_change_until_it_leads_inside() {
    let folder = with_model();
    folder.write("outside.obj", "v 0 0 0\n");
    let link = folder.path().join("project/scenes/link.obj");
    std::os::unix::fs::symlink("../../outside.obj", &link).expect("it is writable");
    let mut watched = Watched::asking(folder, &["link.obj"], OLD);
    assert_eq!([(); 2].map(|()| watched.look()), [(false, 0); 2]);
    std::fs::remove_file(&link).expect("it is there");
    std::os::unix::fs::symlink("a.obj", &link).expect("it is writable");
    assert!(watched.look().0);
}

#[test]
fn standard_input_is_not_watched() {
    let sources = Sources::on_disk(Path::new(".")).with("-", "(objects: [])");
    let mut seen = Seen::new(sources.asked());
    assert!(seen.paths().next().is_none() && !seen.differs(&|_| Answer::Missing));
}
