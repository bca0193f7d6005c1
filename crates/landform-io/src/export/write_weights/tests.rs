use landform_core::grid::{Grid, Shape};
use landform_core::verb::MemoryOutput;

use super::engines::control_word;
use super::*;
use crate::format::read_grey;

fn layer(json: &str) -> WeightLayer {
    serde_json::from_str(json).unwrap()
}

/// A letter F, 300 m and 200 m high, on level ground; no flip, turn or transpose leaves it as it
/// is.
fn letter(n: usize) -> HeightField {
    let grid = Grid::new(Shape::new(n, n), [20.0; 2]).unwrap();
    let z = (0..n * n).map(|i| {
        let (row, col) = (8 * (i / n) / n, 8 * (i % n) / n);
        let bars = (row == 1 && (1..6).contains(&col)) || (row == 3 && (1..4).contains(&col));
        if col == 1 && (1..7).contains(&row) {
            300.0
        } else if bars {
            200.0
        } else {
            0.0
        }
    });
    let mut field = HeightField::new(grid, z.collect()).unwrap();
    let wet = (0..n * n).map(|i| (i % n) as f64 / (n - 1) as f64).collect();
    field.fields_mut().insert_values("wet", landform_core::field::Values::F64(wet)).unwrap();
    field
}

fn write(preset: WeightPreset, layers: &[&str], field: &HeightField, tiles: [usize; 2]) -> MemoryOutput {
    let layers = layers.iter().map(|json| layer(json)).collect();
    let stage =
        WriteWeights { preset, layers, tiles, height_softness: Some(Length::of(0.0)), ..WriteWeights::default() };
    stage.validate().unwrap();
    let mut out = MemoryOutput::default();
    stage.export(&Landscape::plain(field), &mut out).unwrap();
    let mut planned = stage.outputs();
    planned.sort();
    assert_eq!(out.0.keys().cloned().collect::<Vec<_>>(), planned, "what is planned is written");
    out
}

const HIGH: &str = r#"{"name":"high","height":{"above":"250 m"}}"#;
const WET: &str = r#"{"name":"wet","field":"wet","range":[0, "1"]}"#;
const STEEP: &str = r#"{"name":"steep","slope":{"above":"30 deg"}}"#;
const REST: &str = r#"{"name":"rest"}"#;

#[test]
fn whole_parts_sum_to_255_whatever_the_shares() {
    for k in 0..2000u64 {
        let seed = landform_core::random::Seed(k);
        let raw: Vec<f64> = (0..1 + k % 9).map(|j| seed.uniform(j) * seed.uniform(100 + j)).collect();
        let sum: f64 = raw.iter().sum();
        let shares: Vec<f64> = raw.iter().map(|v| v / sum).collect();
        let parts = share_out(&shares);
        assert_eq!(parts.iter().map(|&p| u32::from(p)).sum::<u32>(), 255, "{shares:?}");
        // No part is off by one or more: the method of largest remainders keeps the quota.
        assert!(parts.iter().zip(&shares).all(|(&p, s)| (f64::from(p) - 255.0 * s).abs() < 1.0));
    }
    assert_eq!(share_out(&[0.5, 0.5]), [128, 127], "of equals the first");
    assert_eq!(share_out(&[1.0]), [255]);
}

#[test]
fn unreal_has_a_picture_a_layer_upright_and_weights_sum_to_255() {
    let out = write(WeightPreset::Unreal, &[HIGH, WET, STEEP, REST], &letter(127), [1, 1]);
    let pictures: Vec<Vec<u32>> = ["high", "wet", "steep", "rest"]
        .iter()
        .map(|n| read_grey(&out.0[&format!("weights/{n}.png")]).unwrap())
        .inspect(|p| assert_eq!((p.rows, p.cols), (127, 127)))
        .map(|p| p.values.iter().map(|v| (v * 255.0).round() as u32).collect())
        .collect();
    let field = letter(127);
    for i in 0..127 * 127 {
        assert_eq!(pictures.iter().map(|p| p[i]).sum::<u32>(), 255);
        assert_eq!(pictures[0][i] == 255, field.elevation()[i] > 250.0, "the stem of the F");
    }
    // Wet ground grows to the east: beside the F at the right edge it is all.
    assert_eq!((pictures[1][0], pictures[1][126]), (0, 255));
    let card = String::from_utf8_lossy(&out.0["weights/weights.md"]).into_owned();
    assert!(card.contains("| high | `high.png` | grey | height above 250 m |"), "{card}");
}

#[test]
fn unity_has_powers_of_two_and_four_layers_a_picture() {
    let out = write(
        WeightPreset::Unity,
        &[HIGH, WET, STEEP, r#"{"name":"low","height":{"below":"-1 m"}}"#, REST],
        &letter(129),
        [1, 1],
    );
    let names: Vec<&str> = out.0.keys().map(String::as_str).collect();
    assert_eq!(names, ["weights/splat0.png", "weights/splat1.png", "weights/weights.md"]);
    let decode = |name: &str| {
        let mut reader = png::Decoder::new(std::io::Cursor::new(&out.0[name])).read_info().unwrap();
        let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut bytes).unwrap();
        assert_eq!((info.width, info.height, info.color_type), (128, 128, png::ColorType::Rgba));
        bytes
    };
    let (first, second) = (decode("weights/splat0.png"), decode("weights/splat1.png"));
    for (a, b) in first.chunks(4).zip(second.chunks(4)) {
        assert_eq!(a.iter().chain(b).map(|&v| u32::from(v)).sum::<u32>(), 255);
    }
}

#[test]
fn words_of_terrain3d_have_their_bits_where_its_documentation_says() {
    for (weights, hole, base, overlay, blend) in [
        (&[255, 0, 0][..], false, 0, 0, 0),
        (&[0, 255, 0], false, 1, 1, 0),
        (&[100, 155, 0], true, 1, 0, 100),
        (&[60, 55, 140], false, 2, 0, 77),
        (&[128, 127], false, 0, 1, 127),
    ] {
        let x = control_word(weights, hole);
        // Decoded as the documentation writes it.
        assert_eq!((x >> 27 & 0x1F, x >> 22 & 0x1F, x >> 14 & 0xFF), (base, overlay, blend), "{weights:?}");
        assert_eq!((x >> 10 & 0xF, x >> 7 & 0x7), (0, 0), "UV angle and scale");
        assert_eq!((x >> 2 & 1, x >> 1 & 1, x & 1), (u32::from(hole), 0, 0), "hole, navigation, auto");
    }
    let many: Vec<u8> = (0..32).map(|k| if k == 31 { 200 } else { u8::from(k == 30) * 55 }).collect();
    let x = control_word(&many, false);
    assert_eq!((x >> 27, x >> 22 & 0x1F, x >> 14 & 0xFF), (31, 30, 55));
}

#[test]
fn a_control_map_comes_back_bit_by_bit_even_where_its_floats_are_none() {
    // Texture 31 below texture 31 is a NaN with a payload, texture 0 a number below the normal ones.
    let mut words: Vec<u32> = (0..32)
        .map(|k| control_word(&(0..32).map(|j| 255 * u8::from(j == k)).collect::<Vec<_>>(), k % 2 == 0))
        .collect();
    words.extend([0xffff_ffff, 0x7f80_0001, 0x0000_0001, 0x8000_0000]);
    let bytes = crate::format::write_exr_words(&words, Shape::new(4, 9)).unwrap();
    use exr::prelude::{ReadChannels, ReadLayers};
    let reader = exr::prelude::read().no_deep_data().largest_resolution_level().all_channels().first_valid_layer();
    let image = reader.all_attributes().from_buffered(std::io::Cursor::new(bytes)).unwrap();
    let channel = &image.layer_data.channel_data.list[0];
    assert_eq!(channel.name.to_string(), "R");
    let exr::prelude::FlatSamples::F32(samples) = &channel.sample_data else { panic!("no floats") };
    assert_eq!(samples.iter().map(|v| v.to_bits()).collect::<Vec<_>>(), words);
}

#[test]
fn tiles_share_the_pixels_of_their_common_border() {
    let out = write(WeightPreset::Unreal, &[WET, REST], &letter(253), [2, 2]);
    let read = |name: &str| read_grey(&out.0[&format!("weights/{name}.png")]).unwrap();
    let (west, east, south) = (read("wet_x0_y0"), read("wet_x1_y0"), read("wet_x0_y1"));
    assert_eq!((west.rows, west.cols), (127, 127));
    assert!((0..127).all(|k| west.values[k * 127 + 126] == east.values[k * 127]));
    assert!((0..127).all(|k| west.values[126 * 127 + k] == south.values[k]));
}

#[test]
fn what_makes_no_weights_is_refused() {
    let refused = |layers: &[&str]| {
        let layers = layers.iter().map(|json| layer(json)).collect();
        WriteWeights { layers, ..WriteWeights::default() }.validate().unwrap_err().to_string()
    };
    assert!(refused(&[]).contains("1 to 32 layers"));
    assert!(refused(&[HIGH]).contains("the last layer takes"));
    assert!(refused(&[REST, REST]).contains("no rule, so that none"));
    assert!(refused(&[HIGH, HIGH, REST]).contains("twice"));
    assert!(refused(&[r#"{"name":"a/../b","height":{"above":"1 m"}}"#, REST]).contains("a name of letters"));
    assert!(refused(&[r#"{"name":"a","height":{"above":"9 m","below":"3 m"}}"#, REST]).contains("less than `below`"));
    assert!(refused(&[r#"{"name":"a","field":"deposition","range":["1 m","1 m"]}"#, REST]).contains("two different"));
    assert!(
        refused(&[r#"{"name":"a","field":"deposition","range":["1 m","3 kyr"]}"#, REST]).contains("wrong dimension")
    );
    assert!(refused(&[r#"{"name":"a","height":{"above":"1 m"},"range":[0,1]}"#, REST]).contains("field"));
    let absent = WriteWeights {
        layers: vec![layer(r#"{"name":"a","field":"nothing"}"#), layer(REST)],
        ..WriteWeights::default()
    };
    assert!(absent.export(&Landscape::plain(&letter(33)), &mut MemoryOutput::default()).is_err());
}
