//! PLY: binary little-endian, 64-bit coordinates, z up, metres; fields as properties of the
//! vertices.

use landform_core::Result;

use super::MeshFile;

pub(super) fn write(mesh: &MeshFile) -> Result<Vec<u8>> {
    let properties: String = mesh.fields.iter().map(|field| format!("property double {}\n", field.name)).collect();
    let units: String = mesh.fields.iter().map(|field| format!("comment {} in {}\n", field.name, field.unit)).collect();
    let mut bytes = format!(
        "ply\nformat binary_little_endian 1.0\ncomment landform: z up, metres\n{units}element vertex {}\n\
         property double x\nproperty double y\nproperty double z\n{properties}element face {}\n\
         property list uchar uint vertex_indices\nend_header\n",
        mesh.points.len(),
        mesh.triangles.len()
    )
    .into_bytes();
    for (i, point) in mesh.points.iter().enumerate() {
        let numbers = point.iter().copied().chain(mesh.fields.iter().map(|field| field.values[i]));
        bytes.extend(numbers.flat_map(f64::to_le_bytes));
    }
    for t in &mesh.triangles {
        bytes.push(3);
        bytes.extend(t.iter().flat_map(|i| i.to_le_bytes()));
    }
    Ok(bytes)
}
