//! Tint, by which Chrome reads WGSL: Dawn for node, where `.ci/setup test` has put it.

use std::io::Write;
use std::process::{Command, Stdio};

use super::validators::skip;
use crate::common::root;
use crate::device::REQUIRE_GPU;

/// What Tint has against each of `texts`, nothing where it takes one. None where there is no Tint.
pub fn objections(texts: &[String]) -> Option<Vec<String>> {
    let folder = root().join("target/tint");
    let is_there = folder.join("node_modules/webgpu/package.json").exists();
    let mut node = Command::new("node");
    let node = node.arg(root().join("tests/gpu/export/tint.mjs")).arg(&folder);
    let started = node.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
    let Some(mut child) = started.ok().filter(|_| is_there) else {
        let why = "there is no Tint; `.ci/setup test` installs it";
        assert!(std::env::var_os(REQUIRE_GPU).is_none(), "{REQUIRE_GPU} is set, but {why}");
        skip(why);
        return None;
    };
    let input = serde_json::to_vec(texts).expect("texts are JSON");
    child.stdin.take().expect("it is piped").write_all(&input).expect("node reads it");
    let told = child.wait_with_output().expect("node ends");
    let answer = told.stdout.rsplit(|byte| *byte == b'\n').next().unwrap_or_default();
    let answers = serde_json::from_slice::<Vec<String>>(answer);
    Some(answers.unwrap_or_else(|error| panic!("{error}: {}", String::from_utf8_lossy(&told.stderr))))
}
