//! A world for Gazebo: SDF 1.9.
//!
//! The greatest pixel is 65535 and the least 0, so that a reader that divides by the greatest one
//! and one that divides by 65535 agree. The collision is set at its height by its pose, the visual
//! by the height map's position: gz-sim reads no other of the two. Objects fall through height maps
//! with DART's usual detector of collisions; with bullet they do not.

use landform_core::Result;
use landform_core::terrain::{Interpolation, NodeSurface, resample};
use landform_core::verb::Output;

use super::{BYTES_OF_A_MESH, World, WriteWorld, Writer, digits, filled, range};
use crate::export::colours::ground_texture;
use crate::export::layout;
use crate::format::{RasterFile, encode_grey, encode_png, mesh_format, quantize};
use landform_core::grid::Shape;

pub(super) static WRITER: Writer = Writer {
    word: "gazebo",
    extensions: &["sdf", "world"],
    beside: |stage| match (stage.max_error, stage.texture) {
        (Some(_), _) => vec![MESH],
        (None, false) => vec![HEIGHTS],
        (None, true) => vec![HEIGHTS, COLOURS, NORMALS],
    },
    check,
    bytes: |stage| if stage.max_error.is_some() { BYTES_OF_A_MESH } else { BYTES_OF_HEIGHTS },
    write,
};

const HEIGHTS: &str = "_heights.png";
const COLOURS: &str = "_colours.png";
const NORMALS: &str = "_normals.png";
const MESH: &str = "_ground.stl";
const BYTES_OF_HEIGHTS: u64 = 64;
/// Heights between the least and the greatest pixel of level ground, m.
const FLAT: f64 = 1e-6;

fn check(stage: &WriteWorld) -> Result<()> {
    if stage.texture && stage.max_error.is_some() {
        let expected =
            "false with `max_error`: the mesh of Gazebo has one colour; leave `max_error` out for a height map";
        return Err(landform_core::Error::parameter("texture", "true", expected));
    }
    layout::GAZEBO.check("gazebo", stage.size, [1, 1])
}

fn write(world: &World, out: &mut dyn Output) -> Result<()> {
    let path = &world.stage.path;
    let (collision, visual, rows) =
        if world.stage.max_error.is_some() { mesh(world, out)? } else { height_map(world, out)? };
    out.put(path, text(&collision, &visual).as_bytes())?;
    let steps = format!(
        "1. `gz sim {}` in the folder of the file: it finds what it reads beside it.\n\
         2. `gz model` or *Resource Spawner* puts a robot on it; or name the file in the `world` argument of your launch file.\n\n\
         The detector of collisions is bullet: with DART's usual one objects fall through height maps. The height map of \
         gz-physics is one part in its number of nodes narrower than it is drawn; where that matters give `max_error`, for a mesh.\n",
        world.name(&format!(".{}", path.rsplit('.').next().unwrap_or("sdf"))),
    );
    out.put(&format!("{path}.md"), world.card("Gazebo", &rows, &steps).as_bytes())
}

/// Elements of the collision and the visual, and rows for the card.
type Ground = (String, String, Vec<(&'static str, String)>);

fn height_map(world: &World, out: &mut dyn Output) -> Result<Ground> {
    let own = world.field.grid();
    let layout = layout::GAZEBO.layout("gazebo", own, world.stage.size, [1, 1], BYTES_OF_HEIGHTS)?;
    if let Some(note) = layout.note(&world.stage.path, own) {
        out.note(note);
    }
    let [w, h] = own.extent();
    if (w / h - 1.0).abs() > 1e-9 {
        out.note(format!(
            "{}: some of Gazebo's renderers draw height maps as squares, and this one is {} m x {} m; `max_error` makes a mesh",
            world.stage.path,
            digits(w),
            digits(h)
        ));
    }
    let (field, holes) = filled(world.field)?;
    let field = if layout.whole == *own { field } else { resample(&field, &layout.whole, Interpolation::Linear)? };
    let (lo, hi) = range(&field);
    let file = RasterFile::real(field.grid(), field.elevation(), "elevation", "m", world.seed);
    out.put(&world.stage.beside(HEIGHTS), &encode_grey(&quantize(&file), field.grid().shape)?)?;
    let mut texture = String::new();
    if world.stage.texture {
        out.put(&world.stage.beside(COLOURS), &ground_texture(world.field, world.environment, None)?.png)?;
        // A normal of every pixel that points up.
        out.put(&world.stage.beside(NORMALS), &encode_png(&[[128, 128, 255]; 16], Shape::new(4, 4))?)?;
        texture = format!(
            "\n              <texture><size>{}</size><diffuse>{}</diffuse><normal>{}</normal></texture>",
            digits(w.max(h)),
            world.name(COLOURS),
            world.name(NORMALS)
        );
    }
    let size = format!("{} {} {}", digits(w), digits(h), digits((hi - lo).max(FLAT)));
    let element = |at: &str, texture: &str| {
        format!(
            "<heightmap>\n              <uri>{}</uri>\n              <size>{size}</size>\n              \
             <pos>{at}</pos>{texture}\n            </heightmap>",
            world.name(HEIGHTS)
        )
    };
    let collision = format!(
        "<pose>0 0 {} 0 0 0</pose>\n          <geometry>\n            {}\n          </geometry>",
        digits(lo),
        element("0 0 0", "")
    );
    let visual =
        format!("<geometry>\n            {}\n          </geometry>", element(&format!("0 0 {}", digits(lo)), &texture));
    let mut rows = vec![
        (
            "height map",
            format!(
                "`{}`, {} x {} nodes, 16 bits",
                world.name(HEIGHTS),
                field.grid().shape.cols,
                field.grid().shape.rows
            ),
        ),
        ("size (x, y, z)", size.replace(' ', ", ")),
        ("pose and pos, z", digits(lo)),
        ("one step of the heights", format!("{} m", digits((hi - lo) / crate::format::STEPS))),
    ];
    if holes > 0 {
        rows.push(("nodes without data", format!("{holes}, at the least height")));
    }
    Ok((collision, visual, rows))
}

fn mesh(world: &World, out: &mut dyn Output) -> Result<Ground> {
    let (mesh, error) = world.mesh()?;
    let stl = (mesh_format(MESH.as_ref())?.write)(&mesh)?;
    out.put(&world.stage.beside(MESH), &stl)?;
    let geometry =
        format!("<geometry>\n            <mesh><uri>{}</uri></mesh>\n          </geometry>", world.name(MESH));
    let visual = format!(
        "{geometry}\n          <material>\n            <ambient>0.47 0.42 0.36 1</ambient>\n            \
         <diffuse>0.47 0.42 0.36 1</diffuse>\n          </material>"
    );
    let error = error.unwrap_or(0.0);
    out.note(format!("{}: {} nodes, every one of the land within {error:.3} m", world.stage.path, mesh.points.len()));
    let rows = vec![
        ("mesh", format!("`{}`, {} triangles", world.name(MESH), mesh.triangles.len())),
        ("greatest error", format!("{} m", digits(error))),
    ];
    Ok((geometry, visual, rows))
}

fn text(collision: &str, visual: &str) -> String {
    format!(
        r#"<?xml version="1.0"?>
<sdf version="1.9">
  <world name="landform">
    <physics name="step" type="dart">
      <max_step_size>0.001</max_step_size>
      <real_time_factor>1</real_time_factor>
      <dart>
        <collision_detector>bullet</collision_detector>
      </dart>
    </physics>
    <plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics"/>
    <plugin filename="gz-sim-user-commands-system" name="gz::sim::systems::UserCommands"/>
    <plugin filename="gz-sim-scene-broadcaster-system" name="gz::sim::systems::SceneBroadcaster"/>
    <gravity>0 0 -9.80665</gravity>
    <light name="sun" type="directional">
      <cast_shadows>true</cast_shadows>
      <pose>0 0 1000 0 0 0</pose>
      <diffuse>0.9 0.9 0.85 1</diffuse>
      <specular>0.1 0.1 0.1 1</specular>
      <direction>0.5 -0.5 -0.7</direction>
    </light>
    <model name="terrain">
      <static>true</static>
      <link name="ground">
        <collision name="collision">
          {collision}
        </collision>
        <visual name="visual">
          {visual}
        </visual>
      </link>
    </model>
  </world>
</sdf>
"#
    )
}
