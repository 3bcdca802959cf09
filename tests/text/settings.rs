//! What the window remembers: what is written is read, and whatever else is in the file does no harm.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use glam::Vec3;
use raytoy::ir::Camera;
use raytoy::panel::{Bookmarks, Settings, Theme, cache, folder, free_digit};
use tempfile::TempDir;

/// The settings read from a file that says `text`.
fn read(text: impl AsRef<[u8]>) -> Settings {
    let home = TempDir::new().expect("there is room for a folder");
    fs::write(home.path().join("window.json"), text).expect("the folder is writable");
    Settings::read(home.path())
}

#[test]
fn what_is_written_is_read_again() {
    let home = TempDir::new().expect("there is room for a folder");
    let place = home.path().join("a/b");
    let mut settings = Settings {
        size: [900, 700],
        panel: 411.5,
        theme: Theme::Light,
        handles: false,
        ..Settings::default()
    };
    settings.visit(&home.path().join("scene \"1\".ron"));
    settings.write(&place).expect("the folder is made");
    assert_eq!(Settings::read(&place), settings);
    settings.theme = Theme::Dark;
    settings.write(&place).expect("the folder is writable");
    assert_eq!(Settings::read(&place), settings);
    let files = fs::read_dir(&place).expect("it is there").flatten().map(|entry| entry.file_name());
    assert_eq!(files.collect::<Vec<_>>(), ["window.json"], "nothing lies beside it");
}

#[test]
fn a_file_that_is_missing_or_damaged_counts_as_none() {
    assert_eq!(Settings::read(Path::new("/there is no such folder")), Settings::default());
    for damaged in
        ["", "{", "[]", "null", "{\"size\": \"big\"}", "{\"theme\": \"pink\"}", "{\"panel\": 1e999}"]
    {
        assert_eq!(read(damaged), Settings::default(), "{damaged}");
    }
    assert_eq!(read([0xff, 0xfe, 0x00]), Settings::default());
}

#[test]
fn what_a_file_does_not_say_is_the_default_and_what_it_says_more_is_ignored() {
    let settings = read("{\"theme\": \"light\", \"mood\": \"good\"}");
    assert_eq!(settings, Settings { theme: Theme::Light, ..Settings::default() });
}

#[test]
fn a_window_is_never_too_small_to_find_or_too_large_to_open() {
    assert_eq!(read("{\"size\": [0, 4000000000]}").size, [200, 16384]);
    assert_eq!(read("{\"panel\": -5}").panel, 240.0);
    assert_eq!(read("{\"panel\": 1e30}").panel, 640.0);
}

#[test]
fn the_last_twelve_scenes_are_remembered_once_each_the_last_one_first() {
    let mut settings = Settings::default();
    for i in 0..20 {
        settings.visit(Path::new(&format!("/scenes/{i}.ron")));
    }
    settings.visit(Path::new("/scenes/10.ron"));
    let wanted =
        [10, 19, 18, 17, 16, 15, 14, 13, 12, 11, 9, 8].map(|i| PathBuf::from(format!("/scenes/{i}.ron")));
    assert_eq!(settings.recent, wanted);
    settings.visit(Path::new("near.ron"));
    assert_eq!(settings.recent[0], std::env::current_dir().expect("it is there").join("near.ron"));
}

#[test]
fn a_program_that_drives_the_window_has_no_settings_unless_it_says_where() {
    let place = |is_driven, config: Option<&str>| {
        let variables = [("RAYTOY_CONFIG", config), ("HOME", Some("/h")), ("APPDATA", Some("C:\\a"))];
        let value = |name: &str| variables.iter().find(|(known, _)| *known == name)?.1.map(OsString::from);
        folder(is_driven, value)
    };
    assert_eq!(place(true, None), None);
    assert_eq!(place(true, Some("here")), Some("here".into()));
    assert_eq!(place(false, Some("")), None);
    assert!(place(false, None).is_some_and(|folder| folder.ends_with("raytoy")));
}

#[test]
fn pictures_that_can_be_drawn_again_lie_beside_the_settings_only_where_raytoy_config_says_so() {
    let place = |is_driven, config: Option<&str>| {
        let variables = [("RAYTOY_CONFIG", config), ("HOME", Some("/h")), ("LOCALAPPDATA", Some("C:\\a"))];
        let value = |name: &str| variables.iter().find(|(known, _)| *known == name)?.1.map(OsString::from);
        cache(is_driven, value)
    };
    assert_eq!(place(true, None), None);
    assert_eq!(place(false, Some("")), None);
    assert_eq!(place(true, Some("here")), Some("here/thumbnails".into()));
    assert!(place(false, None).is_some_and(|folder| folder.ends_with("raytoy/thumbnails")));
    if cfg!(target_os = "linux") {
        assert_eq!(place(false, None), Some("/h/.cache/raytoy/thumbnails".into()));
    }
}

#[cfg(target_os = "linux")]
#[test]
fn on_linux_they_lie_where_xdg_says() {
    let place = |xdg: Option<&str>| {
        let variables = [("XDG_CONFIG_HOME", xdg), ("HOME", Some("/h"))];
        let value = |name: &str| variables.iter().find(|(known, _)| *known == name)?.1.map(OsString::from);
        folder(false, value)
    };
    assert_eq!(place(Some("/x")), Some("/x/raytoy".into()));
    assert_eq!(place(Some("relative")), Some("/h/.config/raytoy".into()), "a relative one is to be ignored");
    assert_eq!(place(None), Some("/h/.config/raytoy".into()));
}

fn looking_from(x: f32) -> Camera {
    Camera { eye: Vec3::new(x, 0.0, 0.0), target: Vec3::ZERO, up: Vec3::Y, fov: 0.7 }
}

#[test]
fn cameras_are_kept_by_their_digits_and_come_back_as_they_were() {
    let mut kept = Bookmarks::default();
    for (digit, x) in [(3, 3.0), (1, 1.1), (3, 4.0)] {
        kept.keep(digit, &looking_from(x));
    }
    let digits: Vec<u8> = kept.all().iter().map(|known| known.digit).collect();
    assert_eq!(digits, [1, 3]);
    assert_eq!(kept.all()[1].camera(), looking_from(4.0));
    let told = serde_json::to_string(&kept).expect("it is JSON");
    assert_eq!(serde_json::from_str::<Bookmarks>(&told).expect("it is JSON"), kept);
}

#[test]
fn a_name_stays_where_the_camera_is_another_and_goes_with_it() {
    let mut kept = Bookmarks::default();
    kept.keep(2, &looking_from(1.0));
    assert_eq!(kept.all()[0].title(), "camera 2");
    kept.rename(2, "front".into());
    kept.keep(2, &looking_from(2.0));
    assert_eq!(kept.all()[0].title(), "front");
    assert_eq!(free_digit(kept.all()), Some(1));
    kept.remove(2);
    kept.keep(2, &looking_from(1.0));
    assert_eq!(kept.all()[0].title(), "camera 2");
}

#[test]
fn there_are_nine() {
    let mut kept = Bookmarks::default();
    while let Some(digit) = free_digit(kept.all()) {
        kept.keep(digit, &looking_from(1.0));
    }
    assert_eq!(kept.all().len(), 9);
}
