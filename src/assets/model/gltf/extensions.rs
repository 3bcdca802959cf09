//! The extensions that a glTF file names: those that are read, and those that it can be read without.

use super::document::Document;

/// Those that say where triangles are, and are read.
const READ: [&str; 3] = ["EXT_mesh_gpu_instancing", "KHR_node_visibility", "KHR_mesh_quantization"];

/// How the names of those begin that are about looks, light, sound, motion or the file itself.
const HARMLESS: [&str; 21] = [
    "KHR_materials_",
    "KHR_texture_",
    "KHR_lights_",
    "KHR_xmp",
    "KHR_animation_",
    "KHR_audio",
    "KHR_interactivity",
    "KHR_physics",
    "KHR_collision",
    "KHR_implicit_shapes",
    "KHR_node_selectability",
    "KHR_node_hoverability",
    "EXT_texture_",
    "EXT_lights_",
    "EXT_materials_",
    "EXT_structural_metadata",
    "EXT_mesh_features",
    "EXT_instance_features",
    "MSFT_texture_",
    "VRM",
    "VRMC_",
];

/// Those that pack triangles, by the names that people know.
const PACKED: [(&str, &str); 3] = [
    ("KHR_draco_mesh_compression", "Draco"),
    ("EXT_meshopt_compression", "Meshopt"),
    ("KHR_meshopt_compression", "Meshopt"),
];

/// Those that it names and that may move its triangles, in words that follow the file's name.
///
/// # Errors
/// That it cannot be read without one that raytoy does not know.
pub fn check(document: &Document) -> Result<Option<String>, String> {
    for needed in &document.extensions_required {
        if let Some((extension, name)) = PACKED.iter().find(|(known, _)| known == needed) {
            return Err(compressed(name, extension));
        }
        if !is_known(needed) {
            return Err(format!(
                "needs `{needed}`, which raytoy does not support: export the model without it"
            ));
        }
    }
    let is_packed = |name: &str| PACKED.iter().any(|(known, _)| *known == name);
    let unknown = document.extensions_used.iter().filter(|name| !is_known(name) && !is_packed(name));
    let unknown: Vec<String> = unknown.map(|name| format!("`{name}`")).collect();
    let warning = || format!("uses {}, which raytoy does not support", unknown.join(", "));
    Ok((!unknown.is_empty()).then(warning))
}

pub fn compressed(name: &str, extension: &str) -> String {
    format!("is packed by {name} (`{extension}`), which raytoy does not read: export it without compression")
}

/// That an accessor without any bytes has them packed, if so.
pub fn draco(document: &Document) -> Option<String> {
    let (extension, name) = PACKED[0];
    document.extensions_used.iter().any(|used| used == extension).then(|| compressed(name, extension))
}

fn is_known(name: &str) -> bool {
    READ.contains(&name) || HARMLESS.iter().any(|known| name.starts_with(known))
}
