//! Wavefront OBJ: text, z up, metres.

use std::fmt::Write;

use landform_core::Result;

use super::MeshFile;

pub(super) fn write(mesh: &MeshFile) -> Result<Vec<u8>> {
    let mut text = String::from("# landform: z up, metres\no terrain\n");
    for [x, y, z] in &mesh.points {
        writeln!(text, "v {x:.4} {y:.4} {z:.4}").ok();
    }
    for [a, b, c] in mesh.triangles.iter().map(|t| t.map(|i| i + 1)) {
        writeln!(text, "f {a} {b} {c}").ok();
    }
    Ok(text.into_bytes())
}
