use landform_core::random::Seed;
use landform_core::terrain::Materials;
use landform_core::units::Erodibility;
use landform_core::verb::{Context, Params};

use super::rock::draw;
use super::*;

fn ground(text: &str) -> Result<LayeredGround> {
    let ground: LayeredGround = serde_json::from_str(text).unwrap();
    ground.validate()?;
    Ok(ground)
}

fn made(text: &str) -> HeightField {
    ground(text).unwrap().generate(&Context::default()).unwrap()
}

/// Beds of many seeds.
fn many(laws: &SequenceParams) -> (Vec<f64>, Vec<(f64, f64)>) {
    let (mut thick, mut strong) = (Vec::new(), Vec::new());
    for seed in 0..100 {
        let (materials, beds) = draw(None, laws, &Materials::default(), Seed(seed)).unwrap();
        thick.extend(beds.iter().map(|b| b.thickness));
        strong.extend(beds.iter().map(|b| {
            let material = materials.get(b.material);
            (math::log(material.erodibility), math::log(material.limiting_slope))
        }));
    }
    (thick, strong)
}

fn mean_and_deviation(values: &[f64]) -> (f64, f64) {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    (mean, (values.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / n).sqrt())
}

#[test]
fn thickness_is_exponential_and_strength_log_normal() {
    let laws: SequenceParams = serde_json::from_str(
        r#"{"beds":100,"thickness":"40 m","erodibility":"1e-5 1/yr","erodibility_spread":0.7,
            "limiting_slope":0.9,"limiting_slope_spread":0.2}"#,
    )
    .unwrap();
    // 10 000 draws: standard errors are 0.01 of the mean and 0.007 of the deviation.
    let (thick, strong) = many(&laws);
    let (mean, deviation) = mean_and_deviation(&thick);
    assert!((mean / 40.0 - 1.0).abs() < 0.04 && (deviation / 40.0 - 1.0).abs() < 0.05, "{mean} {deviation}");
    let beyond = thick.iter().filter(|t| **t > 80.0).count() as f64 / 1e4;
    assert!((beyond - math::exp(-2.0)).abs() < 0.015, "{beyond}");
    let (k, s): (Vec<f64>, Vec<f64>) = strong.into_iter().unzip();
    let ((mk, dk), (ms, ds)) = (mean_and_deviation(&k), mean_and_deviation(&s));
    assert!((mk - math::log(Erodibility::of(1e-5).si())).abs() < 0.03 && (dk - 0.7).abs() < 0.03, "{mk} {dk}");
    assert!((ms - math::log(0.9)).abs() < 0.01 && (ds - 0.2).abs() < 0.01, "{ms} {ds}");
    let together = k.iter().zip(&s).map(|(a, b)| (a - mk) * (b - ms)).sum::<f64>() / (1e4 * dk * ds);
    assert!((together + 0.8).abs() < 0.02, "strong beds stand steeply: {together}");
}

#[test]
fn folds_have_their_wavelength_amplitude_and_axis() {
    let field = made(
        r#"{"grid":{"size":["8 km","8 km"],"cell_size":"100 m"},"rock":"tableland","dip":"0 deg","top":"300 m",
            "folds":{"wavelength":"2 km","amplitude":"150 m","axis":"0 deg","waviness":0}}"#,
    );
    let layers = field.layers().unwrap();
    // The axis runs north: beds rise along x alone.
    for node in 0..81 * 81 {
        let x = field.grid().position(node)[0];
        let expected = 300.0 + 150.0 * math::sin(std::f64::consts::TAU * x / 2000.0);
        assert!((layers.datum(node).unwrap() - expected).abs() < 1e-9);
    }
}

#[test]
fn dip_turns_thickness_and_datum() {
    let text = |dip: &str| {
        format!(
            r#"{{"grid":{{"size":["2 km","2 km"],"cell_size":"100 m"}},"rock":"cuesta","dip":"{dip}","dip_direction":"90 deg","top":"0 m"}}"#
        )
    };
    let (level, tilted) = (made(&text("0 deg")), made(&text("20 deg")));
    let datum = |node: usize| tilted.layers().unwrap().datum(node).unwrap();
    let fall = datum(10 * 21) - datum(10 * 21 + 20);
    assert!((fall - 2000.0 * math::tan(20_f64.to_radians())).abs() < 1e-9, "{fall}");
    let thickness = |field: &HeightField, node: usize| {
        let layers = field.layers().unwrap();
        layers.datum(node).unwrap() - layers.column(node, layers.datum(node).unwrap()).next().unwrap().bottom
    };
    let middle = 10 * 21 + 10;
    let ratio = thickness(&tilted, middle) / thickness(&level, middle);
    assert!((ratio * math::cos(20_f64.to_radians()) - 1.0).abs() < 1e-9, "{ratio}");
}

#[test]
fn rock_follows_from_the_seed_alone() {
    let text = r#"{"grid":{"size":["2 km","2 km"],"cell_size":"100 m"},"rock":"volcanic"}"#;
    let with = |seed: u64| {
        ground(text).unwrap().generate(&Context { seed: Seed(seed), ..Context::default() }).unwrap().layers().cloned()
    };
    assert!(with(1) == with(1) && with(1) != with(2));
}

#[test]
fn beds_beside_a_rock_are_refused() {
    let both = ground(r#"{"rock":"folded","beds":[{"material":"shale","thickness":"9 m"}]}"#);
    assert_eq!(both.unwrap_err().parameter_name(), Some("beds"));
    let laws = SequenceParams { beds: Some(200), ..SequenceParams::default() };
    let full = Materials::default().and(vec![Materials::default().get(0).clone(); 60]).unwrap();
    let error = draw(None, &laws, &full, Seed(1)).unwrap_err();
    assert_eq!(error.parameter_name(), Some("sequence.beds"), "{error}");
}

#[test]
fn a_straight_fault_offsets_beds_and_weakens_rock_along_its_line() {
    let field = made(
        r#"{"grid":{"size":["12 km","2 km"],"cell_size":"20 m"},"rock":"tableland","dip":"0 deg","top":"0 m",
            "joints":[{"spacing":"1 km","direction":"0 deg","width":"40 m","weakness":5,"waviness":0,"throw":"50 m"}]}"#,
    );
    let weakness = field.fields.get(&names::JOINTS, "test").unwrap();
    let layers = field.layers().unwrap();
    let datum = |c: usize| layers.datum(50 * 601 + c).unwrap();
    let row = &weakness[50 * 601..51 * 601];
    assert!(row.iter().all(|w| (1.0..=5.0).contains(w)));
    // Faults run north: every row is alike, and each step of the beds lies on weak rock.
    assert_eq!(row, &weakness[20 * 601..21 * 601]);
    let steps: Vec<usize> = (1..601).filter(|&c| datum(c) != datum(c - 1)).collect();
    assert!((11..=13).contains(&steps.len()), "{steps:?}");
    assert!(steps.iter().all(|&c| row[c].max(row[c - 1]) > 4.0), "{steps:?}");
    let weak = row.iter().filter(|w| **w > 3.0).count();
    // exp(−d²/b²) > 1/2 within 33 m of a line: three cells or four.
    assert!((2 * steps.len()..=5 * steps.len()).contains(&weak), "{weak} for {}", steps.len());
}

#[test]
fn waviness_bends_lines() {
    let text = |waviness: f64| {
        format!(
            r#"{{"grid":{{"size":["4 km","4 km"],"cell_size":"50 m"}},"joints":[{{"direction":"0 deg","waviness":{waviness}}}]}}"#
        )
    };
    let (straight, wavy) = (made(&text(0.0)), made(&text(0.5)));
    let rows = |field: &HeightField| {
        let w = field.fields.get(&names::JOINTS, "test").unwrap();
        w[..81] == w[80 * 81..]
    };
    assert!(rows(&straight) && !rows(&wavy));
}
