//! raytoy as a shell runs it, in the project's folder.

use std::io::Write;
use std::process::{Command, Output, Stdio};

use super::root;

/// Runs raytoy in the project's folder.
pub fn raytoy(arguments: &[&str]) -> Output {
    command(arguments).output().expect("raytoy runs")
}

/// The same, with `input` at standard input.
pub fn with_input(arguments: &[&str], input: &str) -> Output {
    let mut child = command(arguments).stdin(Stdio::piped()).spawn().expect("raytoy runs");
    let mut stdin = child.stdin.take().expect("it is piped");
    stdin.write_all(input.as_bytes()).expect("raytoy reads");
    drop(stdin);
    child.wait_with_output().expect("raytoy ends")
}

/// A call of raytoy in the project's folder.
pub fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_raytoy"));
    command.current_dir(root()).args(arguments).stdin(Stdio::null());
    command.env_remove("COLUMNS").stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

/// The text at standard error.
pub fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}
