//! STL: binary, 32-bit, z up, metres from the middle of the terrain.

use landform_core::{Error, Result};

use super::MeshFile;

pub(super) fn write(mesh: &MeshFile) -> Result<Vec<u8>> {
    let count = u32::try_from(mesh.triangles.len()).map_err(|e| Error::format("STL", e))?;
    let centre = mesh.centre();
    let mut bytes = Vec::with_capacity(84 + 50 * mesh.triangles.len());
    bytes.extend(b"landform: z up, metres from the middle");
    bytes.resize(80, b' ');
    bytes.extend(count.to_le_bytes());
    for &t in &mesh.triangles {
        bytes.extend(mesh.face_normal(t).iter().flat_map(|v| v.to_le_bytes()));
        for i in t {
            let p = mesh.points[i as usize];
            bytes.extend((0..3).flat_map(|k| ((p[k] - centre[k]) as f32).to_le_bytes()));
        }
        bytes.extend([0, 0]);
    }
    Ok(bytes)
}
