//! For whom a module is written: this decides its entry points, and which files of shaders/ it has.
//!
//! In: the wishes of who draws. Out: a [`Target`] for [`super::generate`].

use crate::library::Const;

/// All that a module depends on besides its scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Target {
    pub host: Host,
    pub mode: Mode,
    /// Whether it draws debug views. Drivers compile a module without them a fifth sooner.
    pub views: bool,
    /// Whether it also has the entry points of shaders/probe.wgsl.
    pub probe: bool,
}

/// The program that draws with a module, and calls its entry points.
#[derive(Clone, Debug, PartialEq)]
pub enum Host {
    /// This program: [`crate::gpu`].
    Raytoy,
    /// A program of anyone's, without raytoy.
    Any,
    /// shadertoy.com, which takes one function without any bindings.
    Shadertoy {
        /// Fields of `Frame` in shaders/frame.wgsl, which are text here; `pixel_spread` is that of a picture
        /// one pixel high.
        settings: Vec<(&'static str, Const)>,
    },
}

/// What becomes of a scene's numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Slots of [`super::Source::numbers`], which the shader reads: an edit of a number changes no text.
    Live,
    /// Literals.
    Baked,
}

impl Target {
    /// raytoy itself, with its debug views.
    pub fn raytoy(mode: Mode) -> Self {
        Self { host: Host::Raytoy, mode, views: true, probe: false }
    }

    /// raytoy itself while nobody looks at a debug view.
    pub fn plain() -> Self {
        Self { views: false, ..Self::raytoy(Mode::Baked) }
    }

    /// A program without raytoy.
    pub fn without_raytoy(host: Host) -> Self {
        Self { host, ..Self::plain() }
    }
}
