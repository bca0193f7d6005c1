//! glTF 2.0 binary: y up, metres from the middle of the terrain; east is +x, north is −z.
//!
//! # Sources
//! glTF 2.0 specification, sections 3.6 (accessors want min and max) and 4.4 (binary container).

use landform_core::{Error, Result};
use serde_json::{Value, json};

use super::{MeshFile, Texture};

const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;

pub(super) fn write(mesh: &MeshFile) -> Result<Vec<u8>> {
    let centre = mesh.centre();
    let y_up = |[x, y, z]: [f32; 3]| [x, z, -y];
    let points: Vec<[f32; 3]> =
        mesh.points.iter().map(|p| y_up([0, 1, 2].map(|k| (p[k] - centre[k]) as f32))).collect();
    let normals: Vec<[f32; 3]> = mesh.normals().into_iter().map(y_up).collect();
    let bound = |pick: fn(f32, f32) -> f32, start: f32| -> Vec<f32> {
        (0..3).map(|k| points.iter().map(|p| p[k]).fold(start, pick)).collect()
    };
    let mut buffer: Vec<u8> = points.iter().flatten().flat_map(|v| v.to_le_bytes()).collect();
    let block = buffer.len();
    buffer.extend(normals.iter().flatten().flat_map(|v| v.to_le_bytes()));
    buffer.extend(mesh.triangles.iter().flatten().flat_map(|v| v.to_le_bytes()));
    let count = points.len();
    let mut document = json!({
        "asset": { "version": "2.0", "generator": concat!("landform ", env!("CARGO_PKG_VERSION")) },
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": [{ "mesh": 0, "name": "terrain" }],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0, "NORMAL": 1 }, "indices": 2, "material": 0 }] }],
        "materials": [{ "name": "ground", "pbrMetallicRoughness":
            { "baseColorFactor": [0.47, 0.42, 0.36, 1.0], "metallicFactor": 0.0, "roughnessFactor": 1.0 } }],
        "accessors": [
            { "bufferView": 0, "componentType": FLOAT, "count": count, "type": "VEC3",
              "min": bound(f32::min, f32::INFINITY), "max": bound(f32::max, f32::NEG_INFINITY) },
            { "bufferView": 1, "componentType": FLOAT, "count": count, "type": "VEC3" },
            { "bufferView": 2, "componentType": UNSIGNED_INT, "count": mesh.triangles.len() * 3, "type": "SCALAR" },
        ],
        "bufferViews": [
            { "buffer": 0, "byteOffset": 0, "byteLength": block, "target": 34962 },
            { "buffer": 0, "byteOffset": block, "byteLength": block, "target": 34962 },
            { "buffer": 0, "byteOffset": 2 * block, "byteLength": mesh.triangles.len() * 12, "target": 34963 },
        ],
        "buffers": [{ "byteLength": buffer.len() }],
    });
    if let Some(texture) = &mesh.texture {
        add_texture(&mut document, &mut buffer, texture);
    }
    let mut text = serde_json::to_vec(&document).map_err(|e| Error::format("glTF", e))?;
    text.resize(text.len().next_multiple_of(4), b' ');
    let total = u32::try_from(12 + 8 + text.len() + 8 + buffer.len()).map_err(|e| Error::format("glTF", e))?;
    let mut bytes = Vec::with_capacity(total as usize);
    bytes.extend(b"glTF");
    bytes.extend(2u32.to_le_bytes());
    bytes.extend(total.to_le_bytes());
    for (kind, chunk) in [(b"JSON", &text), (b"BIN\0", &buffer)] {
        bytes.extend((chunk.len() as u32).to_le_bytes());
        bytes.extend(kind);
        bytes.extend(chunk);
    }
    Ok(bytes)
}

/// Puts a picture into the buffer, and on the material: its own colours, without tint.
fn add_texture(document: &mut Value, buffer: &mut Vec<u8>, texture: &Texture) {
    let places = buffer.len();
    buffer.extend(texture.places.iter().flatten().flat_map(|v| v.to_le_bytes()));
    let picture = buffer.len();
    buffer.extend(&texture.png);
    // The chunk ends at a multiple of four bytes.
    buffer.resize(buffer.len().next_multiple_of(4), 0);
    let mut push = |list: &str, item: Value| match &mut document[list] {
        Value::Array(items) => items.push(item),
        other => *other = json!([item]),
    };
    push("bufferViews", json!({ "buffer": 0, "byteOffset": places, "byteLength": picture - places, "target": 34962 }));
    push("bufferViews", json!({ "buffer": 0, "byteOffset": picture, "byteLength": texture.png.len() }));
    push(
        "accessors",
        json!({ "bufferView": 3, "componentType": FLOAT, "count": texture.places.len(), "type": "VEC2" }),
    );
    push("images", json!({ "bufferView": 4, "mimeType": "image/png", "name": "colours" }));
    push("samplers", json!({ "magFilter": 9729, "minFilter": 9987, "wrapS": 33071, "wrapT": 33071 }));
    push("textures", json!({ "sampler": 0, "source": 0 }));
    document["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = json!(3);
    let surface = &mut document["materials"][0]["pbrMetallicRoughness"];
    surface["baseColorFactor"] = json!([1.0, 1.0, 1.0, 1.0]);
    surface["baseColorTexture"] = json!({ "index": 0 });
    document["buffers"][0]["byteLength"] = json!(buffer.len());
}
