//! The JSON of a glTF 2.0 file, as far as it says where triangles are. Each index is as the file has it.

use std::collections::BTreeMap;

use serde::Deserialize;
use serde::de::IgnoredAny;

#[derive(Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub struct Document {
    pub asset: Option<Asset>,
    pub scene: Option<usize>,
    pub scenes: Vec<Scene>,
    pub nodes: Vec<Node>,
    pub meshes: Vec<Mesh>,
    pub skins: Vec<Skin>,
    pub accessors: Vec<Accessor>,
    pub buffer_views: Vec<View>,
    pub buffers: Vec<Buffer>,
    pub extensions_used: Vec<String>,
    pub extensions_required: Vec<String>,
}

#[derive(Deserialize)]
pub struct Asset {
    #[serde(default)]
    pub version: String,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub struct Scene {
    pub nodes: Vec<usize>,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub struct Node {
    pub mesh: Option<usize>,
    pub skin: Option<usize>,
    pub children: Vec<usize>,
    /// Columns.
    pub matrix: Option<[f64; 16]>,
    pub translation: Option<[f64; 3]>,
    pub rotation: Option<[f64; 4]>,
    pub scale: Option<[f64; 3]>,
    pub weights: Option<Vec<f32>>,
    pub extensions: NodeExtensions,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub struct NodeExtensions {
    #[serde(rename = "EXT_mesh_gpu_instancing")]
    pub instancing: Option<Instancing>,
    #[serde(rename = "KHR_node_visibility")]
    pub visibility: Option<Visibility>,
}

#[derive(Deserialize)]
pub struct Instancing {
    #[serde(default)]
    pub attributes: Attributes,
}

#[derive(Deserialize)]
pub struct Visibility {
    #[serde(default = "yes")]
    pub visible: bool,
}

fn yes() -> bool {
    true
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub struct Mesh {
    pub primitives: Vec<Primitive>,
    pub weights: Vec<f32>,
}

/// Accessors by what they hold, such as `POSITION`.
pub type Attributes = BTreeMap<String, usize>;

#[derive(Default, Deserialize)]
#[serde(default)]
pub struct Primitive {
    pub attributes: Attributes,
    pub indices: Option<usize>,
    pub mode: Option<u32>,
    /// What morphs add to the attributes, each by its weight.
    pub targets: Vec<Attributes>,
}

#[derive(Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub struct Skin {
    pub inverse_bind_matrices: Option<usize>,
    pub joints: Vec<usize>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Accessor {
    /// Without any, its elements are zeros.
    pub buffer_view: Option<usize>,
    #[serde(default)]
    pub byte_offset: usize,
    pub component_type: u32,
    #[serde(default)]
    pub normalized: bool,
    pub count: usize,
    #[serde(rename = "type")]
    pub kind: String,
    pub sparse: Option<Sparse>,
}

/// Elements in place of some of those of an accessor.
#[derive(Deserialize)]
pub struct Sparse {
    pub count: usize,
    pub indices: SparseIndices,
    pub values: SparseValues,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct SparseIndices {
    pub buffer_view: usize,
    #[serde(default)]
    pub byte_offset: usize,
    pub component_type: u32,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct SparseValues {
    pub buffer_view: usize,
    #[serde(default)]
    pub byte_offset: usize,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct View {
    pub buffer: usize,
    #[serde(default)]
    pub byte_offset: usize,
    pub byte_length: usize,
    pub byte_stride: Option<usize>,
    #[serde(default)]
    pub extensions: BTreeMap<String, IgnoredAny>,
}

#[derive(Deserialize)]
pub struct Buffer {
    pub uri: Option<String>,
}

impl Document {
    /// # Errors
    /// Why it is none, in words that follow the file's name.
    pub fn read(json: &[u8]) -> Result<Self, String> {
        // Some programs fill up with zeros, where blanks belong.
        let is_padding = |byte: &u8| *byte == 0 || byte.is_ascii_whitespace();
        let end = json.iter().rposition(|byte| !is_padding(byte)).map_or(0, |last| last + 1);
        let json = &json[..end];
        let read: Result<Self, _> = serde_json::from_slice(json);
        let version = match &read {
            Ok(document) => document.asset.as_ref().map(|asset| asset.version.clone()),
            Err(_) => version(json),
        };
        if version.is_some_and(|version| version.starts_with("1.") || version == "1") {
            return Err("is glTF 1.0: export it as glTF 2.0".into());
        }
        let document = read.map_err(|error| format!("is damaged: {error}"))?;
        if document.asset.is_none() && document.meshes.is_empty() {
            return Err("is JSON, but not glTF".into());
        }
        Ok(document)
    }

    /// The nodes of its scene, or where it has none those that are below no other one.
    pub fn roots(&self) -> Result<Vec<usize>, String> {
        let scene = self.scene.unwrap_or(0);
        if let Some(scene) = self.scenes.get(scene) {
            return Ok(scene.nodes.clone());
        }
        if !self.scenes.is_empty() {
            return Err(missing("scene", scene));
        }
        let mut is_root = vec![true; self.nodes.len()];
        for child in self.nodes.iter().flat_map(|node| &node.children) {
            *is_root.get_mut(*child).ok_or_else(|| missing("node", *child))? = false;
        }
        Ok((0..self.nodes.len()).filter(|index| is_root[*index]).collect())
    }
}

/// What of `all` has an index.
///
/// # Errors
/// That there is none, in words that follow the file's name.
pub fn at<'a, T>(all: &'a [T], index: usize, noun: &str) -> Result<&'a T, String> {
    all.get(index).ok_or_else(|| missing(noun, index))
}

fn missing(noun: &str, index: usize) -> String {
    format!("is damaged: it refers to {noun} {index}, which does not exist")
}

/// The version of a document that cannot be read as one of version 2.
fn version(json: &[u8]) -> Option<String> {
    #[derive(Deserialize)]
    struct Head {
        asset: Asset,
    }
    serde_json::from_slice(json).ok().map(|head: Head| head.asset.version)
}
