//! Rules of the house that a test can hold: headers, lengths, imports, and that what ships is shown.

use crate::common;
use crate::common::{expect_none, files, read};
use raytoy::library::{Family, Library, sample};
use raytoy::sources::Sources;

/// What a room may take from: `crate::` and one of these. Rooms of the same name may take from themselves.
const IMPORTS: &[(&str, &[&str])] = &[
    ("diagnostic", &[]),
    ("sources", &["diagnostic"]),
    ("scene", &["diagnostic"]),
    ("edit", &["diagnostic", "library", "scene"]),
    ("bvh", &[]),
    ("assets", &["bvh"]),
    ("library", &["assets", "diagnostic", "sources"]),
    ("ir/resolve", &["assets", "diagnostic", "library", "scene"]),
    ("ir", &["assets", "library"]),
    ("outline", &["assets", "ir", "library", "scene"]),
    ("bindings", &[]),
    ("wgsl", &["bindings", "ir", "library"]),
    ("module", &["diagnostic", "wgsl"]),
    ("frame", &["assets", "bindings", "ir"]),
    ("gpu", &["assets", "bindings", "compile", "diagnostic", "frame", "ir", "library", "wgsl"]),
    ("export", &["bindings", "compile", "frame", "ir", "library", "module", "wgsl"]),
    ("files", &[]),
    ("capture", &["compile", "files", "frame", "gpu"]),
    ("stage", &["compile", "diagnostic", "sources"]),
    ("watch", &["sources"]),
    ("sketch", &["assets", "bindings", "compile", "diagnostic", "frame", "ir"]),
    // A crate of its own, of which `crate::` is the root.
    ("vm", &["image", "lanes", "lower", "machine", "op", "program"]),
    ("judge", &[]),
    ("difference", &["compile", "frame", "gpu", "judge", "scene", "wgsl"]),
    ("laws", &["compile", "diagnostic", "frame", "gpu", "library", "sources", "wgsl"]),
    (
        "suite",
        &[
            "assets",
            "compile",
            "diagnostic",
            "difference",
            "frame",
            "gpu",
            "judge",
            "laws",
            "library",
            "scene",
            "sketch",
            "sources",
            "wgsl",
        ],
    ),
    (
        "engine",
        &[
            "capture",
            "compile",
            "diagnostic",
            "files",
            "frame",
            "gpu",
            "ir",
            "library",
            "outline",
            "scene",
            "sketch",
            "sources",
            "watch",
            "wgsl",
        ],
    ),
    (
        "panel",
        &[
            "capture",
            "compile",
            "diagnostic",
            "difference",
            "edit",
            "engine",
            "export",
            "files",
            "frame",
            "gpu",
            "ir",
            "library",
            "outline",
            "scene",
            "sources",
            "wgsl",
        ],
    ),
    ("window", &["compile", "diagnostic", "engine", "gpu", "panel", "sources"]),
    (
        "cli",
        &[
            "capture",
            "compile",
            "diagnostic",
            "difference",
            "export",
            "files",
            "frame",
            "gpu",
            "ir",
            "library",
            "panel",
            "sketch",
            "sources",
            "suite",
            "wgsl",
            "window",
        ],
    ),
    ("compile", &["diagnostic", "ir", "library", "module", "scene", "sources", "wgsl"]),
    ("lib", &["compile"]),
];

/// What only some rooms may name, and where.
const RESERVED: [(&str, &[&str]); 10] = [
    ("raytoy_vm", &["sketch"]),
    ("wgpu::", &["gpu", "engine", "window"]),
    ("winit::", &["window"]),
    ("egui::", &["panel", "window"]),
    ("notify::", &["watch"]),
    ("clap::", &["cli"]),
    ("png::", &["capture"]),
    ("std::fs", &["sources", "files", "suite", "engine", "panel", "capture", "cli", "watch", "build"]),
    ("println!", &["cli", "build"]),
    // One line in gpu: an error that slips through all scopes has nowhere else to go.
    ("eprintln!", &["cli", "gpu/device"]),
];

#[test]
fn each_module_opens_with_what_it_is() {
    expect_none(rust().into_iter().filter(|(_, text)| !text.starts_with("//! ")).map(|(file, _)| file));
}

/// Rooms whose docs open with a noun of the field or a verb.
const PLAIN: [&str; 6] = ["diagnostic", "sources", "compile", "frame", "judge", "export"];

#[test]
fn docs_open_with_a_noun_or_a_verb() {
    let openings = ["What ", "Whether ", "The same", "Where "].map(|word| format!("/// {word}"));
    let is_plain = |file: &str| PLAIN.iter().any(|room| file.contains(&format!("src/{room}")));
    let files: Vec<_> = rust().into_iter().filter(|(file, _)| is_plain(&file.replace('\\', "/"))).collect();
    assert!(files.len() > 20, "the rooms have moved");
    expect_none(files.iter().flat_map(|(file, text)| {
        let lines = text.lines().enumerate();
        let opens = |line: &str| openings.iter().any(|opening| line.trim_start().starts_with(opening));
        lines.filter(move |(_, line)| opens(line)).map(move |(i, line)| format!("{file}:{}: {line}", i + 1))
    }));
}

#[test]
fn files_and_lines_stay_short() {
    let wgsl = ["shaders", "textures"].iter().flat_map(|folder| files(folder, "wgsl"));
    let wgsl = wgsl.map(|file| (read(&file), file, 100));
    let rust = rust().into_iter().map(|(file, text)| (text, file, 300));
    expect_none(rust.chain(wgsl).flat_map(|(text, file, most)| {
        let lines = text.lines().count();
        let long = (lines > most).then(|| format!("{file}: {lines} lines, {most} are enough"));
        let wide = (1..).zip(text.lines()).filter(|(_, line)| line.chars().count() > 110);
        let wide = wide.map(|(n, line)| format!("{file}:{n}: {} columns", line.chars().count()));
        long.into_iter().chain(wide).collect::<Vec<_>>()
    }));
}

#[test]
fn rooms_import_only_from_rooms_above() {
    expect_none(sources().into_iter().flat_map(|(room, file, text)| {
        let is_room = |(name, _): &&(&str, &[&str])| room == *name || room.starts_with(&format!("{name}/"));
        let (own, allowed) = IMPORTS.iter().find(is_room).copied().unwrap_or((room.as_str(), &[]));
        let own = own.split('/').next().unwrap_or(own).to_owned();
        let named =
            imports(&text).into_iter().filter(move |name| *name != own && !allowed.contains(&name.as_str()));
        named.map(move |name| format!("{file} takes from crate::{name}")).collect::<Vec<_>>()
    }));
}

#[test]
fn crates_and_the_disk_are_named_only_in_their_rooms() {
    expect_none(sources().into_iter().flat_map(|(room, file, text)| {
        let is_in = |rooms: &[&str]| rooms.iter().any(|r| room == *r || room.starts_with(&format!("{r}/")));
        let is_named = |what: &str| match what {
            // `eprintln!` has `println!` in it.
            "println!" => text.replace("eprintln!", "").contains(what),
            "wgpu::" => text.replace("egui_wgpu::", "").contains(what),
            _ => text.contains(what),
        };
        let named = RESERVED.iter().filter(|(what, rooms)| is_named(what) && !is_in(rooms));
        named.map(|(what, _)| format!("{file} names {what}")).collect::<Vec<_>>()
    }));
}

#[test]
fn each_snippet_has_a_caption_and_is_shown_somewhere() {
    let good = common::good_scenes().into_iter().map(|file| read(&file)).collect::<String>();
    let disk = Sources::in_memory();
    let library = Library::new(&disk, "".as_ref());
    expect_none([Family::Shape, Family::Texture].into_iter().flat_map(|family| {
        library
            .names(family)
            .into_iter()
            .filter_map(|name| match library.find(family, &name) {
                Err(problems) => Some(format!("{name}: {problems:?}")),
                Ok(function) if function.caption.is_empty() => Some(format!("{name} has no caption")),
                Ok(_) if !good.contains(&format!("{name}(")) => {
                    Some(format!("{name} is in no scene and no case"))
                }
                Ok(_) => None,
            })
            .collect::<Vec<_>>()
    }));
}

#[test]
fn each_scene_says_what_it_shows() {
    let silent = common::good_scenes().into_iter().filter(|file| !read(file).starts_with("// "));
    expect_none(silent.map(|file| format!("{file} opens without a comment")));
}

/// Cargo.toml says so of its targets, so that the library is compiled once: nobody would run them.
#[test]
fn no_test_is_inside_of_src() {
    let has_tests = |text: &str| ["#[test]", "#[cfg(test)]"].iter().any(|mark| text.contains(mark));
    let files = rust().into_iter().filter(|(_, text)| has_tests(text));
    expect_none(files.map(|(file, _)| format!("{file} has tests; they belong in tests/")));
}

/// The files of src/ with their texts.
fn rust() -> Vec<(String, String)> {
    files("src", "rs").into_iter().map(|file| (file.clone(), read(&file))).collect()
}

/// The room, the name and the code, without comments, of each file of src/; the program's own few lines aside.
fn sources() -> Vec<(String, String, String)> {
    let room = |file: &str| {
        file.trim_start_matches("src/").trim_end_matches(".rs").trim_end_matches("/mod").to_owned()
    };
    let code =
        |text: &str| text.lines().map(|l| l.split("//").next().unwrap_or(l)).collect::<Vec<_>>().join("\n");
    let all = rust().into_iter().map(|(file, text)| (room(&file), file, code(&text)));
    all.filter(|(room, ..)| room != "main").collect()
}

/// The first name behind each `crate::`, and each one of `crate::{a, b}`.
fn imports(text: &str) -> Vec<String> {
    let name = |part: &str| {
        let part = part.trim_start();
        part[..part.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(part.len())].to_owned()
    };
    let starts = text.match_indices("crate::").filter(|(at, _)| !text[..*at].ends_with('$'));
    let found = starts.flat_map(|(at, found)| match text[at + found.len()..].strip_prefix('{') {
        Some(list) => list[..list.find('}').unwrap_or(0)].split(',').map(name).collect(),
        None => vec![name(&text[at + found.len()..])],
    });
    found.filter(|name| !name.is_empty()).collect()
}

#[test]
fn the_page_of_the_library_has_all_that_scenes_can_name() {
    let page = read("docs/library/README.md");
    let digests = read("docs/library/digests.txt");
    let sources = Sources::in_memory();
    let library = Library::new(&sources, "".as_ref());
    let functions = [Family::Texture, Family::Shape].into_iter().flat_map(|family| {
        let names = library.names(family).into_iter();
        names.filter_map(|name| library.find(family, &name).ok()).collect::<Vec<_>>()
    });
    expect_none(functions.filter_map(|function| {
        let says = |what: &str| page.contains(what);
        let tells_parameters = function.parameters.iter().all(|p| says(&p.doc) && says(&p.default_text));
        let is_complete =
            says(&format!("**{}**", function.name)) && says(&function.caption) && tells_parameters;
        let has_picture = common::root().join(format!("docs/library/{}.jpg", function.name)).exists();
        // A picture is drawn again when its file, or the scene around it, has changed.
        let digest = format!("{:016x} {}", sample::digest(&function), function.name);
        let is_its_picture = has_picture && digests.lines().any(|line| line == digest);
        let advice = "run `raytoy gallery -o docs/library`";
        (!is_complete || !is_its_picture)
            .then(|| format!("{} is not as its file says: {advice}", function.name))
    }));
}

#[test]
fn files_that_comments_and_chapters_name_are_there() {
    let folders = ["src", "shaders", "textures", "scenes", "tests"];
    let there: Vec<String> = folders
        .iter()
        .flat_map(|folder| ["rs", "wgsl", "ron", "md"].map(|ending| files(folder, ending)))
        .flatten()
        .collect();
    // `module/guard.rs` is enough for `src/module/guard.rs`.
    let is_there = |path: &str| there.iter().any(|file| format!("/{file}").ends_with(&format!("/{path}")));
    let comment = |line: &str| line.split_once("//").map(|(_, comment)| comment.to_owned());
    let of_code = [("src", "rs"), ("shaders", "wgsl"), ("textures", "wgsl")];
    let code = of_code.into_iter().flat_map(|(folder, ending)| files(folder, ending));
    let code =
        code.map(|file| (read(&file).lines().filter_map(comment).collect::<Vec<_>>().join("\n"), file));
    let pages = files("docs/dev", "md").into_iter().chain(["ARCHITECTURE.md".to_owned()]);
    let pages = pages.map(|file| (read(&file), file));
    expect_none(code.chain(pages).flat_map(|(text, file)| {
        let missing: Vec<String> = paths(&text).into_iter().filter(|path| !is_there(path)).collect();
        missing.into_iter().map(move |path| format!("{file} names {path}, which is not there"))
    }));
}

/// Words with a slash that end as files of this project do, but for those that stand for any name.
fn paths(text: &str) -> Vec<String> {
    let is_part = |c: char| c.is_alphanumeric() || "_-./*".contains(c);
    let words = text.split(|c| !is_part(c)).map(|word| word.trim_matches('.'));
    let is_path = |word: &&str| {
        let ends = [".rs", ".wgsl", ".ron"].iter().any(|ending| word.ends_with(ending));
        ends && word.contains('/') && !word.starts_with(['/', '.']) && !word.contains('*')
    };
    words.filter(is_path).filter(|word| !word.contains("NAME")).map(str::to_owned).collect()
}
