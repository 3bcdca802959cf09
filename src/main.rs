//! The program: hand the arguments to the command line's room, return its exit code.

use std::process::ExitCode;

fn main() -> ExitCode {
    raytoy::cli::run()
}
