//! A model for MuJoCo: MJCF, and heights in MuJoCo's own form: the numbers of rows and of columns
//! and the heights from 0 to 1 as 32-bit floats, row by row from the south.

use landform_core::terrain::NodeSurface;
use landform_core::verb::Output;
use landform_core::{Error, Result};

use super::{World, WriteWorld, Writer, digits, filled, range};

pub(super) static WRITER: Writer =
    Writer { word: "mujoco", extensions: &["xml"], beside: |_| vec![HEIGHTS], check, bytes: |_| 32, write };

const HEIGHTS: &str = ".hfield";
/// Heights of level ground, m: MuJoCo asks for more than none.
const FLAT: f64 = 1e-6;
/// Thickness of the body under the lowest place, as a part of the relief.
const BASE: f64 = 0.1;

fn check(stage: &WriteWorld) -> Result<()> {
    if stage.max_error.is_some() {
        let expected = "none: MuJoCo's height fields have all nodes; `resample` makes a coarser one";
        return Err(Error::parameter("max_error", "given for preset \"mujoco\"", expected));
    }
    if stage.texture {
        return Err(Error::parameter("texture", "true for preset \"mujoco\"", "false"));
    }
    Ok(())
}

fn write(world: &World, out: &mut dyn Output) -> Result<()> {
    let (field, holes) = filled(world.field)?;
    let (lo, hi) = range(&field);
    let relief = (hi - lo).max(FLAT);
    let [w, h] = field.grid().extent();
    let base = (BASE * relief).max(1.0);
    let size = [0.5 * w, 0.5 * h, relief, base].map(digits);
    out.put(&world.stage.beside(HEIGHTS), &heights(&field, lo, relief)?)?;
    out.put(&world.stage.path, text(&world.name(HEIGHTS), &size, lo).as_bytes())?;
    let shape = field.grid().shape;
    let mut rows = vec![
        ("height field", format!("`{}`, {} x {} nodes, 32-bit floats", world.name(HEIGHTS), shape.cols, shape.rows)),
        ("size (half x, half y, heights, base)", size.join(", ")),
        ("position of the geom, z", digits(lo)),
    ];
    if holes > 0 {
        rows.push(("nodes without data", format!("{holes}, at the least height")));
    }
    let name = world.stage.path.rsplit('/').next().unwrap_or_default();
    let steps = format!(
        "1. `python -m mujoco.viewer --mjcf={name}`, or `mujoco.MjModel.from_xml_path(\"{name}\")`.\n\
         2. Into a model of your own: `<include file=\"{name}\"/>` takes the asset and the geom.\n\n\
         Contacts with a height field are found cell by cell: cells much finer than the parts of a robot cost time, not exactness.\n"
    );
    out.put(&format!("{}.md", world.stage.path), world.card("MuJoCo", &rows, &steps).as_bytes())
}

fn heights(field: &landform_core::terrain::HeightField, lo: f64, relief: f64) -> Result<Vec<u8>> {
    let shape = field.grid().shape;
    let mut bytes = Vec::with_capacity(8 + 4 * shape.len());
    for n in [shape.rows, shape.cols] {
        bytes.extend(i32::try_from(n).map_err(|e| Error::format("MuJoCo", e))?.to_le_bytes());
    }
    for row in field.elevation().chunks(shape.cols).rev() {
        bytes.extend(row.iter().flat_map(|z| (((z - lo) / relief) as f32).to_le_bytes()));
    }
    Ok(bytes)
}

fn text(heights: &str, size: &[String; 4], z: f64) -> String {
    format!(
        r#"<mujoco model="landform">
  <asset>
    <hfield name="terrain" file="{heights}" size="{}"/>
  </asset>
  <worldbody>
    <light name="sun" directional="true" pos="0 0 1000" dir="0.5 -0.5 -0.7" diffuse="0.8 0.8 0.75"/>
    <geom name="terrain" type="hfield" hfield="terrain" pos="0 0 {}" rgba="0.47 0.42 0.36 1"/>
  </worldbody>
</mujoco>
"#,
        size.join(" "),
        digits(z)
    )
}
