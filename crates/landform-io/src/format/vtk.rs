//! VTK, the legacy form: binary polygons with 64-bit coordinates, z up, metres; fields as scalars
//! of the points.
//!
//! # Sources
//! VTK file formats (Kitware): "simple legacy formats", version 3.0; binary numbers are big-endian.

use landform_core::{Error, Result};

use super::MeshFile;

pub(super) fn write(mesh: &MeshFile) -> Result<Vec<u8>> {
    let points = mesh.points.len();
    // Indices are 32-bit numbers with a sign.
    i32::try_from(points.max(4 * mesh.triangles.len())).map_err(|e| Error::format("VTK", e))?;
    let mut bytes = format!(
        "# vtk DataFile Version 3.0\nlandform: z up, metres\nBINARY\nDATASET POLYDATA\nPOINTS {points} double\n"
    )
    .into_bytes();
    bytes.extend(mesh.points.iter().flatten().flat_map(|v| v.to_be_bytes()));
    bytes.extend(format!("\nPOLYGONS {} {}\n", mesh.triangles.len(), 4 * mesh.triangles.len()).bytes());
    for t in &mesh.triangles {
        bytes.extend([3, t[0], t[1], t[2]].iter().flat_map(|i| i.to_be_bytes()));
    }
    if !mesh.fields.is_empty() {
        bytes.extend(format!("\nPOINT_DATA {points}").bytes());
    }
    for field in &mesh.fields {
        bytes.extend(format!("\nSCALARS {} double 1\nLOOKUP_TABLE default\n", field.title()).bytes());
        bytes.extend(field.values.iter().flat_map(|v| v.to_be_bytes()));
    }
    bytes.push(b'\n');
    Ok(bytes)
}
