//! Nodes as a table (CSV): a row a point, its place in metres and its fields; without triangles.

use std::fmt::Write;

use landform_core::Result;

use super::MeshFile;

pub(super) fn write(mesh: &MeshFile) -> Result<Vec<u8>> {
    let mut text = String::from("x_m,y_m,elevation_m");
    for field in &mesh.fields {
        write!(text, ",{}", field.title()).ok();
    }
    text.push('\n');
    for (i, [x, y, z]) in mesh.points.iter().enumerate() {
        write!(text, "{x},{y},{z}").ok();
        for field in &mesh.fields {
            write!(text, ",{}", field.values[i]).ok();
        }
        text.push('\n');
    }
    Ok(text.into_bytes())
}
