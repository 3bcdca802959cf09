//! What the tests of models share: models, numbers, and what is read from a file.

pub mod random;
pub mod shapes;

use raytoy::assets::Model;

/// What is read from a file of these bytes.
pub fn decoded(bytes: &[u8]) -> Result<Model, String> {
    Model::decode("a".into(), bytes, &mut |name| Err(format!("points to `{name}`")))
}
