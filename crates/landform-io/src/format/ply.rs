//! PLY: binary little-endian, 64-bit coordinates, z up, metres.

use landform_core::Result;

use super::MeshFile;

pub(super) fn write(mesh: &MeshFile) -> Result<Vec<u8>> {
    let mut bytes = format!(
        "ply\nformat binary_little_endian 1.0\ncomment landform: z up, metres\nelement vertex {}\n\
         property double x\nproperty double y\nproperty double z\nelement face {}\n\
         property list uchar uint vertex_indices\nend_header\n",
        mesh.points.len(),
        mesh.triangles.len()
    )
    .into_bytes();
    bytes.extend(mesh.points.iter().flatten().flat_map(|v| v.to_le_bytes()));
    for t in &mesh.triangles {
        bytes.push(3);
        bytes.extend(t.iter().flat_map(|i| i.to_le_bytes()));
    }
    Ok(bytes)
}
