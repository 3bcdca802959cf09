//! How the picture is made of the light that reaches the camera.

/// How the picture is made. All of it is data: none of it changes the shader.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Render {
    pub max_bounces: u32,
    pub shadows: bool,
    pub shadow_samples: u32,
    pub texture_filter: bool,
    pub transfer: Transfer,
    /// Factor of the light, from the author's stops.
    pub gain: f32,
    pub tone_map: ToneMap,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Transfer {
    Linear,
    Srgb,
    Gamma(f32),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ToneMap {
    Clamp,
    Reinhard,
    Aces,
    Agx,
}

/// The most bounces that a scene may ask for.
pub const MAX_BOUNCES: u32 = 100;
