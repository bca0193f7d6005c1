//! A stage for OpenUSD, as text: a mesh with normals that is collided with as it is, a scene of
//! physics, a sun, and the ground's colours if they are asked for.

use std::fmt::Write;

use landform_core::Result;
use landform_core::verb::Output;

use super::{BYTES_OF_A_MESH, World, Writer, digits};
use crate::format::MeshFile;

pub(super) static WRITER: Writer = Writer {
    word: "usd",
    extensions: &["usda"],
    beside: |stage| if stage.texture { vec![COLOURS] } else { Vec::new() },
    check: |_| Ok(()),
    bytes: |stage| BYTES_OF_A_MESH + if stage.texture { 80 } else { 0 },
    write,
};

const COLOURS: &str = "_colours.png";
/// Triangles above which the size of the text is told.
const MANY: usize = 2_000_000;

fn write(world: &World, out: &mut dyn Output) -> Result<()> {
    let (mesh, error) = world.mesh()?;
    let path = &world.stage.path;
    match error {
        Some(error) => {
            out.note(format!("{path}: {} nodes, every one of the land within {error:.3} m", mesh.points.len()));
        }
        None if mesh.triangles.len() > MANY => {
            let triangles = mesh.triangles.len();
            out.note(format!("{path}: {triangles} triangles are much text; `max_error` leaves out what is not seen"));
        }
        None => {}
    }
    let colours = mesh.texture.as_ref().map(|_| world.name(COLOURS));
    if let Some(texture) = &mesh.texture {
        out.put(&world.stage.beside(COLOURS), &texture.png)?;
    }
    out.put(path, text(&mesh, colours.as_deref()).as_bytes())?;
    let mut rows = vec![("mesh", format!("/World/terrain, {} triangles", mesh.triangles.len()))];
    if let Some(error) = error {
        rows.push(("greatest error", format!("{} m", digits(error))));
    }
    let steps = "1. Isaac Sim, Omniverse: File, Open; or *Add Reference* under a stage of your own (the default prim is /World).\n\
                 2. Physics: the mesh has CollisionAPI with approximation `none`, so that bodies touch its own triangles; it has no \
                 RigidBodyAPI and stands still. /World/physics is the scene, gravity 9.80665 m/s² down.\n\n\
                 A stage whose unit is the centimetre scales a reference by metersPerUnit = 1 itself in Omniverse, elsewhere by hand.\n";
    out.put(&format!("{path}.md"), world.card("OpenUSD", &rows, steps).as_bytes())
}

/// Items of an array, separated by commas.
fn list<I>(text: &mut String, declaration: &str, items: I, end: &str)
where
    I: Iterator<Item: std::fmt::Display>,
{
    write!(text, "        {declaration} = [").ok();
    for (k, item) in items.enumerate() {
        write!(text, "{}{item}", if k > 0 { ", " } else { "" }).ok();
    }
    writeln!(text, "]{end}").ok();
}

fn triple<V: std::fmt::Display>([x, y, z]: [V; 3]) -> String {
    format!("({x}, {y}, {z})")
}

fn text(mesh: &MeshFile, colours: Option<&str>) -> String {
    let mut text = String::from(HEAD);
    let points: Vec<[f32; 3]> = mesh.points.iter().map(|p| p.map(|v| v as f32)).collect();
    let bound = |pick: fn(f32, f32) -> f32, start: f32| {
        triple([0, 1, 2].map(|k| points.iter().map(|p| p[k]).fold(start, pick)))
    };
    let extent = [bound(f32::min, f32::INFINITY), bound(f32::max, f32::NEG_INFINITY)];
    list(&mut text, "float3[] extent", extent.into_iter(), "");
    list(&mut text, "int[] faceVertexCounts", mesh.triangles.iter().map(|_| 3), "");
    list(&mut text, "int[] faceVertexIndices", mesh.triangles.iter().flatten(), "");
    list(&mut text, "point3f[] points", points.iter().map(|&p| triple(p)), "");
    let each_point = " (\n            interpolation = \"vertex\"\n        )";
    list(&mut text, "normal3f[] normals", mesh.normals().into_iter().map(triple), each_point);
    if let (Some(texture), Some(_)) = (&mesh.texture, colours) {
        // The picture's first row is at the top, where t is 1.
        let places = texture.places.iter().map(|[s, t]| format!("({s}, {})", 1.0 - t));
        list(&mut text, "texCoord2f[] primvars:st", places, each_point);
    }
    text += "        uniform token subdivisionScheme = \"none\"\n        uniform token orientation = \"rightHanded\"\n        \
             bool physics:collisionEnabled = true\n        uniform token physics:approximation = \"none\"\n        \
             rel material:binding = </World/ground>\n    }\n\n";
    text + &material(colours) + "}\n"
}

const HEAD: &str = r#"#usda 1.0
(
    defaultPrim = "World"
    metersPerUnit = 1
    upAxis = "Z"
)

def Xform "World"
{
    def PhysicsScene "physics"
    {
        vector3f physics:gravityDirection = (0, 0, -1)
        float physics:gravityMagnitude = 9.80665
    }

    def DistantLight "sun"
    {
        float inputs:intensity = 3000
        float3 xformOp:rotateXYZ = (40, 30, 0)
        uniform token[] xformOpOrder = ["xformOp:rotateXYZ"]
    }

    def Mesh "terrain" (
        prepend apiSchemas = ["PhysicsCollisionAPI", "PhysicsMeshCollisionAPI", "MaterialBindingAPI"]
    )
    {
"#;

/// The ground's material: its picture, or one colour.
fn material(colours: Option<&str>) -> String {
    let (colour, readers) = match colours {
        None => ("color3f inputs:diffuseColor = (0.47, 0.42, 0.36)".to_string(), String::new()),
        Some(file) => (
            "color3f inputs:diffuseColor.connect = </World/ground/picture.outputs:rgb>".to_string(),
            format!(
                r#"
        def Shader "picture"
        {{
            uniform token info:id = "UsdUVTexture"
            asset inputs:file = @./{file}@
            token inputs:sourceColorSpace = "sRGB"
            float2 inputs:st.connect = </World/ground/places.outputs:result>
            token inputs:wrapS = "clamp"
            token inputs:wrapT = "clamp"
            float3 outputs:rgb
        }}

        def Shader "places"
        {{
            uniform token info:id = "UsdPrimvarReader_float2"
            string inputs:varname = "st"
            float2 outputs:result
        }}
"#
            ),
        ),
    };
    format!(
        r#"    def Material "ground"
    {{
        token outputs:surface.connect = </World/ground/surface.outputs:surface>

        def Shader "surface"
        {{
            uniform token info:id = "UsdPreviewSurface"
            {colour}
            float inputs:roughness = 1
            float inputs:metallic = 0
            token outputs:surface
        }}
{readers}    }}
"#
    )
}
