//! The one device that the tests of a program share.

use std::io::Write;
use std::sync::LazyLock;

use raytoy::gpu::{AdapterChoice, Gpu};

/// Set, it turns a missing adapter from a skip into a failure.
pub const REQUIRE_GPU: &str = "RAYTOY_REQUIRE_GPU";

/// The variable with a part of the name of another adapter to test than the software one.
const ADAPTER: &str = "RAYTOY_ADAPTER";

/// The GPU that runs on the processor, unless [`ADAPTER`] names another, one for the whole program; without one the
/// test is skipped.
pub fn gpu() -> Option<&'static Gpu> {
    static GPU: LazyLock<Option<Gpu>> = LazyLock::new(|| {
        let choice = std::env::var(ADAPTER).map_or(AdapterChoice::Software, AdapterChoice::Named);
        match Gpu::headless(&choice) {
            Ok(gpu) => Some(gpu),
            Err(error) if std::env::var_os(REQUIRE_GPU).is_some() => {
                panic!("{REQUIRE_GPU} is set, but {error}")
            }
            Err(error) => {
                // Past the capture of a test that passes: who runs the tests shall see it.
                let _ = writeln!(std::io::stderr(), "skipped: no adapter ({error})");
                None
            }
        }
    });
    GPU.as_ref()
}
