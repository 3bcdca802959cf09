//! The small pictures of the gallery: of what there are some, and when one that was kept is still right.

use std::fs::{self, File};
use std::path::Path;
use std::time::{Duration, SystemTime};

use raytoy::compile;
use raytoy::engine::thumbnails::store::{Store, prune};
use raytoy::engine::thumbnails::{Subject, Thumbnail, catalog, digest};
use raytoy::gpu::Picture;
use raytoy::library::{Family, Kind};
use raytoy::sources::{Disk, Sources};
use raytoy::wgsl::Mode;
use tempfile::TempDir;

const SIZE: [u32; 2] = [8, 8];

fn red() -> Picture {
    let rgba = [255, 0, 0, 255].repeat(64);
    Picture { size: SIZE, rgba, radiance: vec![], depth: vec![], times: Default::default() }
}

fn is_red(image: &Thumbnail) -> bool {
    // A JPEG is not exact.
    image.rgba.chunks(4).all(|pixel| pixel[0] > 245 && pixel[1] < 10 && pixel[2] < 10)
}

#[test]
fn a_scene_is_captioned_by_the_comment_that_opens_it() {
    let home = TempDir::new().expect("there is room for a folder");
    let caption = |text: &str| {
        let scene = home.path().join("scene.ron");
        fs::write(&scene, text).expect("the folder is writable");
        catalog(&Disk::new(None), home.path(), &[(scene, "scene".into())]).swap_remove(0).caption
    };
    assert_eq!(caption("// Two suns. \n// More.\n()"), "Two suns.");
    assert_eq!(caption("(objects: []) // no"), "");
    assert_eq!(caption(""), "");
}

#[test]
fn files_with_mistakes_are_there_and_say_what_is_wrong() {
    let home = tempfile::TempDir::new().expect("there is room for a folder");
    let folder = home.path();
    std::fs::create_dir(folder.join("shapes")).expect("the folder is writable");
    std::fs::write(folder.join("shapes/wrong.wgsl"), "fn other() {}").expect("the folder is writable");
    let scene = folder.join("broken.ron");
    std::fs::write(&scene, "// Shows nothing.\n(objects: [Spere()])").expect("the folder is writable");
    let items = catalog(&Disk::new(None), folder, &[(scene.clone(), "broken".into())]);
    assert_eq!((&*items[0].name, &*items[0].caption), ("broken", "Shows nothing."));
    let wrong = items.iter().find(|item| item.name == "Wrong").expect("it is listed");
    assert!(wrong.definition.is_none());
    let told = |subject: &Subject| subject.compiled(&Disk::new(None), folder).err().unwrap_or_default();
    assert!(told(&wrong.subject).contains("no function `wrong`"), "{}", told(&wrong.subject));
    assert!(told(&items[0].subject).contains("did you mean `Sphere`?"), "{}", told(&items[0].subject));
}

#[test]
fn what_can_be_copied_can_stand_in_a_scene() {
    let folder = Path::new("/nowhere");
    for item in catalog(&Disk::new(None), folder, &[]) {
        let definition = item.definition.expect("what is built in has no mistakes");
        let Subject::Function(family, _) = item.subject else { panic!("no scene was listed") };
        for call in [&definition.call, &definition.full_call] {
            if call.contains(".obj\"") {
                continue;
            }
            let scene = match (family, definition.function.kind) {
                (Family::Shape, _) => format!("(objects: [{call}])"),
                (_, Kind::Mapping) => {
                    format!("(objects: [Plane(material: (color: Checker(at: {call})))])")
                }
                _ => format!("(objects: [Plane(material: (color: {call}))])"),
            };
            let sources = Sources::in_memory().with("s.ron", &scene);
            let outcome = compile(&sources, "s.ron".as_ref(), Mode::Baked, None);
            assert!(outcome.compiled.is_some(), "{call}: {}", outcome.report);
        }
    }
}

#[test]
fn the_digest_is_of_all_that_is_seen_and_of_nothing_else() {
    let of = |text: &str, size| {
        let sources = Sources::in_memory().with("s.ron", text);
        let outcome = compile(&sources, "s.ron".as_ref(), Mode::Baked, None);
        digest(&outcome.compiled.expect("it is right"), size)
    };
    let scene = "(camera: (eye: (0, 0, 5)), objects: [Sphere(radius: 1)], render: (exposure: 1))";
    let now = of(scene, [8, 6]);
    assert_eq!(now, of(&format!("// A ball.\n\n{scene}"), [8, 6]));
    assert_ne!(now, of(scene, [8, 7]));
    for (old, new) in [("radius: 1", "radius: 2"), ("0, 5", "0, 6"), ("exposure: 1", "exposure: 2")] {
        assert_ne!(now, of(&scene.replace(old, new), [8, 6]), "{new}");
    }
}

#[test]
fn a_thumbnail_is_there_the_next_day_under_its_digest_and_size() {
    let home = TempDir::new().expect("there is room for a folder");
    let folder = Some(home.path().join("a/b"));
    let subject = Subject::Scene("red.ron".into());
    Store::open(folder.clone()).keep(&subject, 7, &red());
    let mut store = Store::open(folder.clone());
    assert!(store.find(&subject, 8, SIZE).is_none());
    assert!(store.find(&subject, 7, [9, 8]).is_none());
    assert!(store.find(&subject, 7, SIZE).is_some_and(|image| is_red(&image)));
    let file = home.path().join("a/b/0000000000000007.jpg");
    fs::write(&file, "no picture").expect("it is writable");
    assert!(store.find(&subject, 7, SIZE).is_some(), "memory has it still");
    assert!(Store::open(folder).find(&subject, 7, SIZE).is_none());
}

#[test]
fn without_a_folder_they_are_known_until_the_subject_changes() {
    let mut store = Store::open(None);
    let subject = Subject::Scene("red.ron".into());
    assert!(store.find(&subject, 7, SIZE).is_none());
    assert!(is_red(&store.keep(&subject, 7, &red())));
    assert!(store.find(&subject, 7, SIZE).is_some());
    store.keep(&subject, 8, &red());
    assert!(store.find(&subject, 7, SIZE).is_none());
}

#[test]
fn the_oldest_go_and_what_is_not_ours_stays() {
    let home = TempDir::new().expect("there is room for a folder");
    for (age, name) in ["new.jpg", "old.jpg", "older.jpg", "mine.txt"].iter().enumerate() {
        let file = File::create(home.path().join(name)).expect("the folder is writable");
        let then = SystemTime::now() - Duration::from_secs(100 * age as u64);
        file.set_modified(then).expect("it is ours");
    }
    prune(home.path(), 2);
    let left = |name: &str| home.path().join(name).exists();
    assert_eq!(["new.jpg", "old.jpg", "older.jpg", "mine.txt"].map(left), [true, true, false, true]);
}
