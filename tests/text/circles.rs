//! No files of src/ import each other in a circle: inside of a room, too, imports go one way.
//!
//! A name that a `mod.rs` passes on counts as one from the file that defines it. A module and those inside of
//! it are one, so a part may name what its whole defines.

use std::collections::{BTreeMap, BTreeSet};

use crate::common::{expect_none, files, read};

/// What a module's `use` lines name, as paths from the crate's root; true for those that it passes on.
type Uses = Vec<(bool, Vec<String>)>;

#[test]
fn files_import_each_other_one_way() {
    let mut ways = imports(&modules());
    // Whoever imports nothing, or is imported by nobody, is in no circle.
    loop {
        let imported: BTreeSet<String> = ways.values().flatten().cloned().collect();
        let before = ways.len();
        ways.retain(|module, named| !named.is_empty() && imported.contains(module));
        let left: BTreeSet<String> = ways.keys().cloned().collect();
        ways.values_mut().for_each(|named| named.retain(|other| left.contains(other)));
        if ways.len() == before {
            break;
        }
    }
    expect_none(ways.iter().flat_map(|(module, named)| {
        named.iter().map(move |other| format!("in a circle: {module} imports {other}"))
    }));
}

#[test]
fn a_circle_is_found() {
    let module = |path: &str, text: &str| (path.to_owned(), uses(path, text));
    let modules = BTreeMap::from([
        module("a", "pub use self::one::One;\nmod one; mod two;"),
        module("a::one", "use super::two::{Two, self};"),
        module("a::two", "use crate::a::One;\nuse std::fmt;"),
    ]);
    let ways = imports(&modules);
    assert_eq!(ways["a::one"], BTreeSet::from(["a::two".to_owned()]));
    assert_eq!(ways["a::two"], BTreeSet::from(["a::one".to_owned()]));
}

/// The modules that each module imports, those around it and inside of it aside.
fn imports(modules: &BTreeMap<String, Uses>) -> BTreeMap<String, BTreeSet<String>> {
    let is_around = |outer: &str, inner: &str| inner == outer || inner.starts_with(&format!("{outer}::"));
    let of = |(module, uses): (&String, &Uses)| {
        let named = uses.iter().filter_map(|(_, path)| defining(modules, path));
        let others = named.filter(|other| !is_around(other, module) && !is_around(module, other));
        (module.clone(), others.collect())
    };
    modules.iter().map(of).collect()
}

/// The module that defines what `path` names, though others may pass it on.
fn defining(modules: &BTreeMap<String, Uses>, path: &[String]) -> Option<String> {
    let holder = |path: &[String]| {
        let length = (1..=path.len()).rev().find(|n| modules.contains_key(&path[..*n].join("::")))?;
        Some((path[..length].join("::"), length))
    };
    let (module, length) = holder(path)?;
    let passed_on = modules[&module].iter().find(|(is_public, origin)| {
        let is_elsewhere = holder(origin).is_some_and(|(other, _)| other != module);
        *is_public && is_elsewhere && origin.last() == path.get(length)
    });
    passed_on.and_then(|(_, origin)| defining(modules, origin)).or(Some(module))
}

fn modules() -> BTreeMap<String, Uses> {
    let sources = files("src", "rs").into_iter().map(|file| {
        let path = file.trim_start_matches("src/").trim_end_matches(".rs").trim_end_matches("/mod");
        let module = path.replace('/', "::");
        let text = read(&file);
        let lines = text.lines().map(|line| line.split("//").next().unwrap_or(line));
        let uses = uses(&module, &lines.collect::<Vec<_>>().join("\n"));
        (module, uses)
    });
    sources.collect()
}

/// The names of the `use` lines in the text of `module`, other crates' left out.
fn uses(module: &str, text: &str) -> Uses {
    let around: Vec<&str> = module.split("::").collect();
    let statements = text.split(';').filter_map(|statement| {
        let (before, tree) = statement.rsplit_once("use ")?;
        Some((before.rsplit('\n').next()?.contains("pub"), tree))
    });
    let named = statements.flat_map(|(is_public, tree)| {
        expanded(&tree.replace(char::is_whitespace, "")).into_iter().map(move |path| (is_public, path))
    });
    let from_root = named.filter_map(|(is_public, path)| {
        let parts: Vec<&str> = path.split("::").collect();
        let ups = parts.iter().take_while(|part| **part == "super").count();
        let (base, rest) = match parts[0] {
            "crate" => (&[][..], &parts[1..]),
            "self" => (&around[..], &parts[1..]),
            "super" => (&around[..around.len().checked_sub(ups)?], &parts[ups..]),
            // A module of its own, or another crate.
            _ => (&around[..], &parts[..]),
        };
        Some((is_public, base.iter().chain(rest).map(|part| (*part).to_owned()).collect()))
    });
    from_root.collect()
}

/// `a::{b, c::d}` as `a::b` and `a::c::d`.
fn expanded(tree: &str) -> Vec<String> {
    let Some((before, inner)) = tree.split_once('{') else { return vec![tree.to_owned()] };
    let inner = inner.strip_suffix('}').unwrap_or(inner);
    let mut depth = 0;
    let branches = inner.split(|c: char| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        c == ',' && depth == 0
    });
    let branches = branches.filter(|branch| !branch.is_empty());
    branches.flat_map(|branch| expanded(branch).into_iter().map(|path| format!("{before}{path}"))).collect()
}
