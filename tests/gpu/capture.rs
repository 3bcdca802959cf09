//! Captures: what a picture carries, frames and movies, what is left where one is stopped or fails.

use crate::common;
use crate::device;
use std::io::Write;
use std::ops::ControlFlow;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use crate::common::{check_text, expect_compiled};
use raytoy::Compiled;
use raytoy::capture::{self, CaptureError, Format, Frames, MovieFormat, Numbered, Origin, Shot};
use raytoy::frame::{Moment, View};
use raytoy::gpu::{AdapterChoice, Gpu};
use raytoy::sources::Sources;
use raytoy::wgsl::Mode;

/// A grey that is the fraction of the time.
const TIDE: &str = "/// It rises.\nfn tide(at: Surface) -> f32 { return fract(frame.time); }\n";
const SCENE: &str = "// größer als 波 🌊\r\n(ambient: 1, render: (transfer: Linear),\n\
                     \tobjects: [Plane(material: (color: Tide())), Sphere()])\n";
const SIZE: [u32; 2] = [16, 10];

#[test]
fn a_picture_carries_its_scene_and_what_else_made_it() {
    if device::gpu().is_none() {
        return;
    }
    let folder = studio();
    expect_done(&folder, &["-o", "a.png", "--time", "0.1", "--samples", "3", "--view", "material"]);
    let told = raytoy(&folder, &["scene", "a.png"]);
    assert_eq!(told.stdout, SCENE.as_bytes());
    let version = env!("CARGO_PKG_VERSION");
    let notes = format!("version: {version}\nfile: wave.ron\ntime: 0.1\nview: material\nsamples: 3\n");
    assert_eq!(stderr(&told), notes);
    let picture = std::fs::File::open(folder.path().join("a.png")).expect("it is there");
    let piped = command(&folder, &["scene", "-"]).stdin(picture).output().expect("raytoy runs");
    assert_eq!(piped.stdout, SCENE.as_bytes());
    // The scene that came out draws the picture that it came from, each time.
    std::fs::write(folder.path().join("wave.ron"), told.stdout).expect("it is writable");
    expect_done(&folder, &["-o", "b.png", "--time", "0.1", "--samples", "3", "--view", "material"]);
    assert!(read(&folder, "a.png") == read(&folder, "b.png"));
}

#[test]
fn a_picture_by_another_camera_carries_that() {
    let Some(gpu) = device::gpu() else { return };
    let compiled = compiled();
    let mut shot = shot(gpu, &compiled);
    shot.moment.camera.eye = [1.5, -2.25, 7.0].into();
    shot.moment.camera.fov = 1.0;
    shot.moment.mouse = [3.0, 4.5];
    let still = capture::still(&shot, Format::Png, &mut |_| ControlFlow::Continue(())).expect("it is drawn");
    let origin = Origin::read(&still.bytes).expect("a PNG").expect("it has a scene");
    assert_eq!(origin, Origin::of(&shot));
    let note = |what: &str| {
        let note = origin.notes.iter().find(|(name, _)| name == what);
        note.unwrap_or_else(|| panic!("{what}: {:?}", origin.notes)).1.as_str()
    };
    assert_eq!(note("mouse"), "3, 4.5");
    let scene = format!("(camera: {}, objects: [Sphere()])", note("camera"));
    let again = expect_compiled(common::outcome_of("again.ron", &scene, Mode::Baked)).scene.camera;
    let camera = shot.moment.camera;
    assert_eq!((again.eye, again.target, again.up), (camera.eye, camera.target, camera.up));
    assert!((again.fov - camera.fov).abs() < 1e-6);
}

#[test]
fn a_file_without_a_scene_is_told() {
    let folder = studio();
    image::RgbImage::new(2, 2).save(folder.path().join("photo.png")).expect("it is writable");
    for (file, told) in [
        ("photo.png", "`photo.png` contains no scene; only PNG files written by raytoy contain one"),
        ("wave.ron", "cannot read `wave.ron` as a PNG file: Invalid PNG signature."),
        ("nothing.png", "there is no file `nothing.png`"),
    ] {
        let done = raytoy(&folder, &["scene", file]);
        assert_eq!((done.status.code(), stderr(&done)), (Some(2), format!("raytoy: {told}\n")));
        assert!(done.stdout.is_empty());
    }
}

#[test]
fn frames_have_numbers_and_are_the_stills_of_their_times() {
    if device::gpu().is_none() {
        return;
    }
    let folder = studio();
    expect_done(&folder, &["-o", "deep/er/a##b.png", "--frames", "98..101", "--fps", "8"]);
    assert_eq!(listed(&folder, "deep/er"), ["a100b.png", "a98b.png", "a99b.png"]);
    expect_done(&folder, &["-o", "still.png", "--time", "12.375"]);
    assert!(read(&folder, "still.png") == read(&folder, "deep/er/a99b.png"));
    let greys = ["98", "99", "100"].map(|n| corner(&folder, &format!("deep/er/a{n}b.png")));
    assert_eq!(greys, [0.25, 0.375, 0.5f32].map(|grey| (grey * 255.0).round() as u8));

    let stats = ["--stats", "stats.json"];
    expect_done(&folder, &[&["-o", "#1/####.exr", "--frames", "0..2", "--fps", "0.4"][..], &stats].concat());
    assert_eq!(listed(&folder, "#1"), ["0000.exr", "0001.exr"]);
    expect_done(&folder, &["-o", "still.exr", "--time", "2.5"]);
    assert!(read(&folder, "still.exr") == read(&folder, "#1/0001.exr"));
    let stats: serde_json::Value = serde_json::from_slice(&read(&folder, "stats.json")).expect("JSON");
    let of_pipelines = [0, 1].map(|frame| stats[frame]["pipeline_ms"].as_f64().expect("milliseconds"));
    assert!(
        of_pipelines[0] > 0.0 && of_pipelines[1] == 0.0 && stats.as_array().is_some_and(|s| s.len() == 2)
    );
}

#[test]
fn a_scene_that_does_not_move_is_told_once() {
    if device::gpu().is_none() {
        return;
    }
    let folder = studio();
    std::fs::write(folder.path().join("wave.ron"), "(objects: [Sphere()])").expect("it is writable");
    let done = raytoy(&folder, &render(&["-o", "#.png", "--frames", "0..3"]));
    let told = "warning: `wave.ron` does not move: all 3 frames are equal\n \
                = help: textures and shapes move if they read `frame.time`\n\n\
                1 warning\n#.png: 3 frames of 16x10\n";
    assert_eq!((done.status.code(), stderr(&done).as_str()), (Some(0), told));
    assert_eq!(listed(&folder, "."), ["0.png", "1.png", "2.png", "textures", "wave.ron"]);
    let single = raytoy(&folder, &render(&["-o", "#.png", "--frames", "7..8"]));
    assert_eq!(stderr(&single), "#.png: 1 frame of 16x10\n");
}

#[test]
fn wrong_calls_are_told() {
    let folder = studio();
    let before = listed(&folder, ".");
    let mut told = String::new();
    for call in [
        "-o a.png --frames 0..3",
        "-o a#/b.png --frames 0..3",
        "-o ####.jpg --frames 0..3",
        "-o - --frames 0..3",
        "-o a.mp4",
        "-o #.png --frames 3..3",
        "-o #.png --frames 3",
        "-o #.png --frames 0..3 --fps 0",
        "-o #.png --frames 0..3 --time 1",
        "-o #.png --fps 25",
        "other.ron -o #.png --frames 0..3",
    ] {
        let done =
            raytoy(&folder, &[&["render", "wave.ron"], &call.split(' ').collect::<Vec<_>>()[..]].concat());
        assert_eq!((done.status.code(), done.stdout.len()), (Some(2), 0), "{call}");
        told += &format!("$ raytoy render wave.ron {call}\n{}\n", stderr(&done));
    }
    assert_eq!(listed(&folder, "."), before);
    check_text("tests/cases/help/wrong_frames.txt", &told)
        .unwrap_or_else(|difference| panic!("{difference}"));
}

#[test]
fn progress_runs_from_0_to_1_over_all_frames_and_there_is_one_pipeline() {
    if device::gpu().is_none() {
        return;
    }
    // One of its own, since other tests make pipelines at the same time.
    let gpu = Gpu::headless(&AdapterChoice::Software).expect("there was one before");
    let folder = studio();
    let compiled = compiled();
    let frames = Frames { numbers: 0..3, rate: 4.0 };
    let names = Numbered::of(&folder.path().join("#.exr")).expect("it has a place for the number");
    let mut shares = vec![0.0];
    let shot = Shot { samples: 2, ..shot(&gpu, &compiled) };
    let times = capture::stills(&shot, &frames, &names, &mut |share| {
        shares.push(share);
        ControlFlow::Continue(())
    });
    assert_eq!(times.expect("nothing stops it").0.len(), 3);
    assert!(shares.is_sorted() && shares.last() == Some(&1.0), "{shares:?}");
    assert!([0.3, 0.6, 0.9].iter().all(|share| shares.iter().any(|s| (share - s).abs() < 0.1)), "{shares:?}");
    assert_eq!(gpu.pipelines_made(), 1);
}

#[test]
fn what_is_stopped_leaves_whole_files_or_none() {
    let Some(gpu) = device::gpu() else { return };
    let folder = tempfile::tempdir().expect("a temporary folder");
    let compiled = compiled();
    let shot = shot(gpu, &compiled);
    let until = |most: f32| {
        move |share: f32| if share > most { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    for format in [Format::Png, Format::Exr] {
        let stopped = capture::still(&shot, format, &mut until(0.4));
        assert!(matches!(stopped, Err(CaptureError::Stopped)), "{stopped:?}");
    }
    let frames = Frames { numbers: 0..4, rate: 4.0 };
    let names = Numbered::of(&folder.path().join("new/#.png")).expect("it has a place for the number");
    let stopped = capture::stills(&shot, &frames, &names, &mut until(0.1));
    assert!(matches!(stopped, Err(CaptureError::Stopped)), "{stopped:?}");
    assert_eq!(listed(&folder, "."), [""; 0]);
    let stopped = capture::stills(&shot, &frames, &names, &mut until(0.6));
    assert!(matches!(stopped, Err(CaptureError::Stopped)), "{stopped:?}");
    assert_eq!(listed(&folder, "new"), ["0.png", "1.png"]);
    assert_eq!(corner(&folder, "new/1.png"), 64);
}

#[test]
#[cfg(unix)]
fn files_are_replaced_as_what_they_are() {
    use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
    let folder = studio();
    let path = |name: &str| folder.path().join(name);
    std::fs::write(path("kept.wgsl"), "old").expect("it is writable");
    std::fs::set_permissions(path("kept.wgsl"), PermissionsExt::from_mode(0o640)).expect("it is ours");
    symlink("kept.wgsl", path("link.wgsl")).expect("it is writable");
    let made = Command::new("mkfifo").arg(path("pipe")).status().expect("every Unix has it");
    assert!(made.success());
    let pipe = path("pipe");
    let reader = std::thread::spawn(move || std::fs::read_to_string(pipe).expect("it is text"));
    for output in ["link.wgsl", "pipe"] {
        let done = raytoy(&folder, &["generate", "wave.ron", "-o", output]);
        assert!(done.status.success(), "{}", stderr(&done));
    }
    let text = std::fs::read_to_string(path("kept.wgsl")).expect("it is text");
    assert!(text.contains("fn rayTraceScene") && reader.join().expect("it reads") == text);
    let metadata = |name: &str| std::fs::symlink_metadata(path(name)).expect("it is there");
    assert_eq!(metadata("kept.wgsl").permissions().mode() & 0o777, 0o640);
    assert!(metadata("link.wgsl").is_symlink() && metadata("pipe").file_type().is_fifo());
    let refused = raytoy(&folder, &["generate", "wave.ron", "-o", "textures"]);
    assert_eq!(stderr(&refused), "raytoy: cannot write `textures`: Is a directory (os error 21)\n");
    assert_eq!(listed(&folder, "."), ["kept.wgsl", "link.wgsl", "pipe", "textures", "wave.ron"]);
}

#[cfg(unix)]
mod movies {
    use super::*;

    /// Notes what it is called with and given, and writes its name as the movie.
    const NOTES: &str = "printf '%s\\n' \"$@\" > arguments; cat > input; for last; do :; done; \
                         echo ffmpeg > \"${last#file:}\"";
    const TAKEN: &str = "-hide_banner -loglevel error -y \
                         -f rawvideo -pixel_format rgba -video_size 16x10 -framerate 4 -i pipe:0";
    const COLORS: &str = "-vf scale=out_color_matrix=bt709:out_range=tv -pix_fmt yuv420p \
                          -colorspace bt709 -color_primaries bt709 -color_trc iec61966-2-1 -color_range tv";

    #[test]
    fn ffmpeg_gets_the_frames_and_the_formats_words() {
        if device::gpu().is_none() {
            return;
        }
        let folder = studio();
        ffmpeg(&folder, NOTES);
        expect_done(&folder, &["-o", "#.png", "--frames", "1..4", "--fps", "4"]);
        let stills = ["1.png", "2.png", "3.png"]
            .map(|name| image::open(folder.path().join(name)).expect("a PNG").to_rgba8().into_raw());
        for (name, made) in [
            ("a.mp4", format!("-c:v libx264 -preset slow -crf 16 {COLORS} -movflags +faststart -f mp4")),
            ("b.WEBM", format!("-c:v libvpx-vp9 -crf 20 -b:v 0 -row-mt 1 {COLORS} -f webm")),
            (
                "c: d.gif",
                "-filter_complex \
                 split[seen][drawn];[seen]palettegen[palette];[drawn][palette]paletteuse -f gif"
                    .to_owned(),
            ),
        ] {
            let done = draw(&folder, &["-o", name, "--frames", "1..4", "--fps", "4"]);
            assert_eq!(stderr(&done), format!("{name}: 3 frames of 16x10\n"));
            let words = format!("{TAKEN} {made} file:").replace(' ', "\n") + name + ".part\n";
            assert_eq!(String::from_utf8_lossy(&read(&folder, "arguments")), words);
            assert!(read(&folder, "input") == stills.concat());
            assert_eq!(read(&folder, name), b"ffmpeg\n");
        }
        let made = ["1.png", "2.png", "3.png", "a.mp4", "arguments", "b.WEBM", "c: d.gif", "ffmpeg", "input"];
        assert_eq!(listed(&folder, "."), [&made[..], &["textures", "wave.ron"]].concat());
    }

    #[test]
    fn a_movie_that_fails_leaves_the_one_before() {
        if device::gpu().is_none() {
            return;
        }
        let folder = studio();
        let begin = "for last; do :; done; echo half > \"${last#file:}\"";
        for (script, told) in [
            (format!("{begin}; echo no such encoder >&2; exit 3"), "no such encoder"),
            (format!("{begin}; cat > input; echo the disk is full >&2; exit 3"), "the disk is full"),
            (format!("{begin}; cat > input; exit 3"), "exit status: 3"),
        ] {
            ffmpeg(&folder, &script);
            std::fs::write(folder.path().join("a.mp4"), "before").expect("it is writable");
            // More than a pipe holds, so that the frames of one who does not read get stuck.
            let done = draw(&folder, &["-o", "a.mp4", "--frames", "0..2", "--size", "160x160"]);
            let told = format!("raytoy: ffmpeg made no movie: {told}\n");
            assert_eq!((done.status.code(), stderr(&done)), (Some(2), told));
            assert_eq!(read(&folder, "a.mp4"), b"before");
            let _ = std::fs::remove_file(folder.path().join("input"));
            assert_eq!(listed(&folder, "."), ["a.mp4", "ffmpeg", "textures", "wave.ron"]);
        }
    }

    #[test]
    fn what_no_movie_can_be_is_told_before_a_frame_is_drawn() {
        if device::gpu().is_none() {
            return;
        }
        let folder = studio();
        let told = |arguments: &[&str]| {
            let done = command(&folder, &render(&[&["--frames", "0..2"], arguments].concat()))
                .env("PATH", folder.path())
                .output()
                .expect("raytoy runs");
            assert_eq!(done.status.code(), Some(2));
            stderr(&done)
        };
        assert_eq!(
            told(&["-o", "a.webm"]),
            "raytoy: movies need ffmpeg, which is not installed\n\
             \x20 Debian, Ubuntu  apt install ffmpeg\n\
             \x20 Fedora          dnf install ffmpeg, from rpmfusion.org\n\
             \x20 Arch            pacman -S ffmpeg\n\
             \x20 macOS           brew install ffmpeg\n\
             \x20 Windows         winget install ffmpeg\n\
             without it, write the frames as pictures: `-o frames/####.png`\n"
        );
        ffmpeg(&folder, "touch started");
        assert_eq!(
            told(&["-o", "a.mp4", "--size", "15x10"]),
            "raytoy: width and height of an .mp4 movie must be even: 16x10 instead of 15x10\n"
        );
        assert_eq!(
            told(&["-o", "a.gif", "--fps", "60"]),
            "raytoy: a .gif movie has at most 50 frames per second, not 60\n"
        );
        assert_eq!(
            told(&["-o", "no/a.gif"]),
            "raytoy: cannot write `no/a.gif`: No such file or directory (os error 2)\n"
        );
        assert_eq!(listed(&folder, "."), ["ffmpeg", "textures", "wave.ron"]);
    }

    /// Runs itself once more, with a ffmpeg of its own in the path.
    #[test]
    fn a_stopped_movie_leaves_nothing() {
        const INSIDE: &str = "RAYTOY_TEST_FOLDER";
        let Some(gpu) = device::gpu() else { return };
        let Some(inside) = std::env::var_os(INSIDE) else {
            let folder = studio();
            // It never ends by itself once it has all frames.
            ffmpeg(&folder, &format!("{NOTES}; exec sleep 1000"));
            let itself = std::env::current_exe().expect("it runs");
            let mut again = Command::new(itself);
            again
                .args(["--exact", "capture::movies::a_stopped_movie_leaves_nothing"])
                .current_dir(folder.path());
            again.env("PATH", path_to(&folder)).env(INSIDE, folder.path());
            let done = again.output().expect("it runs");
            assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stdout));
            assert_eq!(listed(&folder, "."), ["arguments", "ffmpeg", "input", "textures", "wave.ron"]);
            return;
        };
        let compiled = compiled();
        let shot = shot(gpu, &compiled);
        let frames = Frames { numbers: 0..4, rate: 4.0 };
        let path = Path::new(&inside).join("a.mp4");
        // In the second frame, and while ffmpeg works after the last.
        for most in [0.3, 0.999] {
            let mut asked_at_the_end = 0;
            let stopped = capture::movie(&shot, &frames, &path, MovieFormat::Mp4, &mut |share| {
                asked_at_the_end += u32::from(share == 1.0);
                let stop = if most < 0.9 { share > most } else { asked_at_the_end == 2 };
                if stop { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            });
            assert!(matches!(stopped, Err(CaptureError::Stopped)), "{stopped:?}");
        }
    }

    #[test]
    fn a_real_ffmpeg_makes_movies_of_the_frames() {
        if device::gpu().is_none() {
            return;
        }
        let listed = Command::new("ffmpeg").args(["-v", "error", "-encoders"]).output();
        let encoders = listed.map_or(String::new(), |o| String::from_utf8_lossy(&o.stdout).into_owned());
        let folder = studio();
        for (name, encoder) in [("a.mp4", " libx264 "), ("a.webm", " libvpx-vp9 "), ("a.gif", " gif ")] {
            if !encoders.contains(encoder) {
                // Past the capture of a test that passes.
                let _ = writeln!(std::io::stderr(), "skipped: no ffmpeg with{encoder}");
                continue;
            }
            let done = draw(&folder, &["-o", name, "--frames", "0..4", "--fps", "4", "--size", "64x40"]);
            assert!(done.status.success(), "{}", stderr(&done));
            let mut back = Command::new("ffmpeg");
            back.current_dir(folder.path()).args(["-v", "error", "-i", name]);
            let frames =
                back.args(["-f", "rawvideo", "-pix_fmt", "rgb24", "-"]).output().expect("it runs").stdout;
            let corners: Vec<u8> = frames.chunks(64 * 40 * 3).map(|f| *f.last().expect("pixels")).collect();
            let near = |(a, b): (&u8, u8)| a.abs_diff(b) <= 4;
            assert!(
                corners.len() == 4 && corners.iter().zip([0, 64, 128, 191]).all(near),
                "{name}: {corners:?}"
            );
        }
    }

    /// Puts a program of this name into `folder`.
    fn ffmpeg(folder: &tempfile::TempDir, script: &str) {
        // Written by another process: what a test starts meanwhile would hold the file open too, and nobody
        // can run a file that is open for writing.
        let mut shell = Command::new("sh");
        shell.args(["-c", r#"printf '#!/bin/sh\n%s\n' "$1" > ffmpeg && chmod +x ffmpeg"#, "sh", script]);
        assert!(shell.current_dir(folder.path()).status().expect("every Unix has it").success());
    }

    /// Where programs are looked for, `folder` first.
    fn path_to(folder: &tempfile::TempDir) -> std::ffi::OsString {
        let others = std::env::var_os("PATH").unwrap_or_default();
        let all = std::iter::once(folder.path().to_owned()).chain(std::env::split_paths(&others));
        std::env::join_paths(all).expect("the folder's name has no colon")
    }

    /// Draws the scene of `folder`, where a program of that folder goes before others.
    fn draw(folder: &tempfile::TempDir, arguments: &[&str]) -> Output {
        command(folder, &render(arguments)).env("PATH", path_to(folder)).output().expect("raytoy runs")
    }
}

/// A folder with a scene that moves, `wave.ron`.
fn studio() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    std::fs::create_dir(folder.path().join("textures")).expect("it is writable");
    std::fs::write(folder.path().join("textures/tide.wgsl"), TIDE).expect("it is writable");
    std::fs::write(folder.path().join("wave.ron"), SCENE).expect("it is writable");
    folder
}

/// The same scene.
fn compiled() -> Compiled {
    let sources = Sources::in_memory().with("textures/tide.wgsl", TIDE).with("wave.ron", SCENE);
    expect_compiled(raytoy::compile(&sources, Path::new("wave.ron"), Mode::Baked, None))
}

fn shot<'a>(gpu: &'a Gpu, compiled: &'a Compiled) -> Shot<'a> {
    let moment = Moment { view: View::Color, ..Moment::of(&compiled.scene) };
    Shot { gpu, compiled, moment, size: SIZE, samples: 1 }
}

/// The red of the last pixel, which shows the plane.
fn corner(folder: &tempfile::TempDir, name: &str) -> u8 {
    let picture = image::open(folder.path().join(name)).expect("a picture").to_rgb8();
    picture.get_pixel(SIZE[0] - 1, SIZE[1] - 1).0[0]
}

/// The names of what is in a folder, sorted.
fn listed(folder: &tempfile::TempDir, name: &str) -> Vec<String> {
    let entries = std::fs::read_dir(folder.path().join(name)).expect("a folder").flatten();
    let mut names: Vec<_> = entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

fn read(folder: &tempfile::TempDir, name: &str) -> Vec<u8> {
    std::fs::read(folder.path().join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Draws the scene of `folder`, without a word but where it went.
fn expect_done(folder: &tempfile::TempDir, arguments: &[&str]) {
    let done = raytoy(folder, &render(arguments));
    assert!(done.status.success() && stderr(&done).lines().count() == 1, "{arguments:?}: {}", stderr(&done));
}

/// How to draw the scene in [`SIZE`], unless `arguments` have another.
fn render<'a>(arguments: &[&'a str]) -> Vec<&'a str> {
    let size: &[&str] = if arguments.contains(&"--size") { &[] } else { &["--size", "16x10"] };
    [&["render", "wave.ron", "--adapter", "software"], size, arguments].concat()
}

fn raytoy(folder: &tempfile::TempDir, arguments: &[&str]) -> Output {
    command(folder, arguments).output().expect("raytoy runs")
}

fn command(folder: &tempfile::TempDir, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_raytoy"));
    command.current_dir(folder.path()).args(arguments).env_remove("COLUMNS");
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).replace("raytoy.exe", "raytoy")
}
