//! Binary glTF files, made for the tests.

use serde_json::{Value, json};

/// The parts of a file, so far.
#[derive(Default)]
pub struct Writer {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
    meshes: Vec<Value>,
}

pub const U8: u32 = 5121;
pub const U16: u32 = 5123;
pub const U32: u32 = 5125;
pub const F32: u32 = 5126;

impl Writer {
    /// The index of a new accessor; `kind` is VEC3 and the like.
    pub fn accessor(&mut self, bytes: &[u8], component: u32, kind: &str, count: usize) -> usize {
        while !self.bytes.len().is_multiple_of(4) {
            self.bytes.push(0);
        }
        let view = json!({ "buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len() });
        self.bytes.extend(bytes);
        self.views.push(view);
        let mut accessor = json!({
            "bufferView": self.views.len() - 1, "componentType": component, "type": kind, "count": count,
        });
        if kind == "VEC3" {
            // The format asks for them where they are positions.
            accessor["min"] = json!([0, 0, 0]);
            accessor["max"] = json!([0, 0, 0]);
        }
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    pub fn vectors<const N: usize>(&mut self, vectors: &[[f32; N]]) -> usize {
        let bytes: Vec<u8> = vectors.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
        self.accessor(&bytes, F32, if N == 2 { "VEC2" } else { "VEC3" }, vectors.len())
    }

    pub fn indices(&mut self, indices: &[u32], component: u32) -> usize {
        let size = match component {
            U8 => 1,
            U16 => 2,
            _ => 4,
        };
        let bytes: Vec<u8> = indices.iter().flat_map(|i| i.to_le_bytes().into_iter().take(size)).collect();
        self.accessor(&bytes, component, "SCALAR", indices.len())
    }

    /// The index of a new mesh.
    pub fn mesh(&mut self, primitives: Value) -> usize {
        self.meshes.push(json!({ "primitives": primitives }));
        self.meshes.len() - 1
    }

    /// The file, with these nodes, of which the `roots` are in its scene.
    pub fn finish(self, nodes: Value, roots: &[usize]) -> Vec<u8> {
        let (document, bytes) = self.parts(nodes, roots);
        file(&document.to_string(), &bytes)
    }

    /// The same, before it is written.
    pub fn parts(self, nodes: Value, roots: &[usize]) -> (Value, Vec<u8>) {
        let document = json!({
            "asset": { "version": "2.0" },
            "buffers": [{ "byteLength": self.bytes.len() }],
            "bufferViews": self.views,
            "accessors": self.accessors,
            "meshes": self.meshes,
            "nodes": nodes,
            "scenes": [{ "nodes": roots }],
            "scene": 0,
        });
        (document, self.bytes)
    }
}

/// A header and two chunks (glTF 2.0, 4.4).
pub fn file(document: &str, bytes: &[u8]) -> Vec<u8> {
    let padded = |bytes: &[u8], with: u8| {
        let mut bytes = bytes.to_vec();
        bytes.resize(bytes.len().next_multiple_of(4), with);
        bytes
    };
    let (document, bytes) = (padded(document.as_bytes(), b' '), padded(bytes, 0));
    let word = |n: usize| (n as u32).to_le_bytes();
    let mut file = b"glTF".to_vec();
    file.extend(word(2));
    file.extend(word(28 + document.len() + bytes.len()));
    file.extend(word(document.len()));
    file.extend(b"JSON");
    file.extend(document);
    file.extend(word(bytes.len()));
    file.extend(b"BIN\0");
    file.extend(bytes);
    file
}
