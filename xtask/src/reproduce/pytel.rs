//! Pytel's figures of synthesis and analysis: surfaces, their spectra, their numbers.

use std::fmt::Write;
use std::path::Path;

use landform::core::algo::noise::spectral_surface;
use landform::core::analysis::{ModelCurve, classify, density, thesis_fit};
use landform::core::grid::{Grid, Shape};
use landform::core::random::Seed;
use landform::core::verb::MemoryOutput;
use landform::core::{Error, Result};
use landform::io::files::write_whole;
use landform::recipe::{GALLERY, Options, Recipe};
use serde_json::Value as Json;

pub(super) fn run(root: &Path) -> Result<()> {
    let folder = root.join("docs/pytel");
    std::fs::create_dir_all(&folder).map_err(|e| Error::io("create folder", &folder, e))?;
    let mut page = String::from(HEAD);
    for figure in FIGURES {
        let text = figure.write(root, &folder)?;
        println!("{text}");
        page += &text;
    }
    page += &families(&folder)?;
    page += &base_line();
    write_whole(&folder.join("README.md"), page.as_bytes())
}

const HEAD: &str = "# Pytel's thesis, chapter 2.1 and 4.4.5: synthesis and analysis, reproduced

Written by `cargo xtask reproduce pytel`; every picture is a stage of a recipe of the gallery (`landform new NAME` writes it). Spectra are drawn with density and radius
logarithmic, long waves in the middle: the thesis draws the same over logarithmic x and y (its triple-log plots).

*β* is the slope of the radially averaged spectrum by rings, 2H + 2 for fractional Brownian ground (the thesis writes 2H + 1, which is that of a profile). *RMS* and *R²* are the
thesis' figures of merit by its procedure 2.1.6 to the letter; they cannot see the slope. *HI* is the hypsometric integral.

";

/// A figure: stages of one recipe.
struct Figure {
    title: &'static str,
    recipe: &'static str,
    labels: &'static [&'static str],
    map: bool,
    what: &'static str,
}

const FIGURES: &[Figure] = &[
    Figure {
        title: "Figure 2.2: coasts of fractal land",
        recipe: "fractal_coasts",
        labels: &["rough", "brownian", "middling", "smooth"],
        map: true,
        what: "H = 0.3, 0.5, 0.7, 0.9. The shore's dimension is 2 − H; counting boxes on a raster reads 1.56, 1.40, 1.24, 1.12 for it.",
    },
    Figure {
        title: "Figure 2.3: spectral synthesis",
        recipe: "spectral_synthesis",
        labels: &["land"],
        map: false,
        what: "H = 0.8: β should be 3.6.",
    },
    Figure {
        title: "Figure 2.5: one point raised, refined without offsets",
        recipe: "bare_subdivision",
        labels: &["diamond_square", "four_eight_held", "four_eight"],
        map: true,
        what: "Bumps in rows and a needle; the needle alone; a dome.",
    },
    Figure {
        title: "Figure 2.6: a fractal mountain, diamond-square",
        recipe: "diamond_square",
        labels: &["land"],
        map: false,
        what: "A needle of a summit where one point was raised.",
    },
    Figure {
        title: "Figure 2.6: the same by 4-8 subdivision",
        recipe: "four_eight",
        labels: &["land"],
        map: false,
        what: "The raised point is smoothed away: a broad height.",
    },
    Figure {
        title: "Figure 2.7: one, two, four, eight octaves",
        recipe: "octaves_of_noise",
        labels: &["octaves_1", "octaves_2", "octaves_4", "octaves_8"],
        map: false,
        what: "Power reaches the rim of the spectrum with the last only: few octaves leave ground too smooth for its cells. R² falls as detail comes in, which shows what R² is worth.",
    },
    Figure {
        title: "Figure 2.8: creases",
        recipe: "creases",
        labels: &["land"],
        map: true,
        what: "Detail hangs on the coarse lattice, whose beat stands out of the spectrum.",
    },
    Figure {
        title: "Section 2.1.3: faults",
        recipe: "faults",
        labels: &["few", "many"],
        map: false,
        what: "A dozen faults, one ray each; two thousand, Brownian: β should be 3.",
    },
    Figure {
        title: "Figures 4.23 and 4.24: noise, multifractal noise, ridges",
        recipe: "kinds_of_noise",
        labels: &["fbm", "billow", "ridged", "ridged_multifractal", "hybrid_multifractal", "multifractal"],
        map: false,
        what: "As in the thesis: alike in their spectra, less so in their hypsometry. The hybrid alone lacks short waves here.",
    },
    Figure {
        title: "Figure 4.23: glaciation and canyonism",
        recipe: "glaciers_and_canyons",
        labels: &["plain", "glaciated", "canyons"],
        map: false,
        what: "Low ground filled, high ground cut level. The spectra hardly change; the curves become a monadnock's and one that is convex throughout, as the thesis finds for Terragen's two options.",
    },
];

impl Figure {
    fn write(&self, root: &Path, folder: &Path) -> Result<String> {
        let recipe = GALLERY.iter().find(|r| r.name == self.recipe);
        let recipe = recipe.ok_or_else(|| Error::Empty { what: self.recipe.into() })?;
        let view = if self.map { "map" } else { "perspective" };
        let mut text = recipe.text.to_string();
        for label in self.labels {
            // What the recipe itself writes stays in memory; these are ours.
            write!(
                text,
                "\n[[stage]]\nuse = \"write_picture\"\nfrom = \"{label}\"\npath = \"our/{label}.png\"\nview = \"{view}\"\nsize = 340\nwater = false\n\
                 \n[[stage]]\nuse = \"write_picture\"\nfrom = \"{label}\"\npath = \"our/{label}_spectrum.png\"\nview = \"spectrum\"\nsize = 201\n\
                 \n[[stage]]\nuse = \"measure_landscape\"\nfrom = \"{label}\"\npath = \"our/{label}.json\"\n"
            )
            .ok();
        }
        let mut out = MemoryOutput::default();
        let options = Options::default();
        Recipe::parse(&text, self.recipe, &root.join("crates/landform/gallery"), &[])?.run(&mut out, &options)?;
        let mut page = format!("## {}\n\nRecipe `{}`. {}\n\n|", self.title, self.recipe, self.what);
        let name = |label: &str| format!("{}_{label}", self.recipe);
        for kind in ["", "_spectrum"] {
            for label in self.labels {
                let bytes = &out.0[&format!("our/{label}{kind}.png")];
                write_whole(&folder.join(format!("{}{kind}.png", name(label))), bytes)?;
            }
        }
        for label in self.labels {
            write!(page, " {} |", label.replace('_', " ")).ok();
        }
        page += &format!("\n|{}\n", "---|".repeat(self.labels.len()));
        for kind in ["", "_spectrum"] {
            page += "|";
            for label in self.labels {
                write!(page, " ![]({}{kind}.png) |", name(label)).ok();
            }
            page += "\n";
        }
        page += "|";
        for label in self.labels {
            let json: Json = serde_json::from_slice(&out.0[&format!("our/{label}.json")]).unwrap_or_default();
            write!(page, " {} |", numbers(&json["metrics"])).ok();
        }
        Ok(page + "\n\n")
    }
}

fn numbers(m: &Json) -> String {
    let v = |path: &[&str]| path.iter().fold(m, |j, k| &j[*k]).as_f64().unwrap_or(f64::NAN);
    let s = |path: &[&str]| v(&[&["spectrum"], path].concat());
    let shore = v(&["coast", "boxes", "dimension"]);
    let shore = if shore.is_nan() { String::new() } else { format!("<br>shore: D {shore:.2} by boxes") };
    format!(
        "β {:.2}<br>RMS {:.3}, R² {:.3}<br>axes/diagonals {:.2}<br>HI {:.2}, {}{shore}",
        s(&["surface", "exponent"]),
        s(&["thesis_fit", "rms"]),
        s(&["thesis_fit", "r2"]),
        s(&["axes_over_diagonals"]),
        v(&["hypsometry", "integral"]),
        m["hypsometry"]["class"].as_str().unwrap_or("–")
    )
}

/// Figures 2.11 to 2.13: curves as drawings and their classes.
fn families(folder: &Path) -> Result<String> {
    let mut page = String::from(
        "## Figures 2.11 to 2.13: hypsometric curves\n\nStrahler's family (Eq. 2.9) for a/d = 0.01, 0.1, 0.5, and three curves that rivers do not leave. Abscissa: part of the area that lies higher; ordinate: relative elevation.\n\n",
    );
    let curve = |f: &dyn Fn(f64) -> f64| -> Vec<f64> { (0..=100).map(|k| f(f64::from(k) / 100.0)).collect() };
    page += "| a/d | curves | z: integral, class |\n|---|---|---|\n";
    for ratio in [0.01, 0.1, 0.5] {
        let exponents = [0.1, 0.25, 0.5, 1.0, 2.0];
        let curves: Vec<Vec<f64>> =
            exponents.iter().map(|&exponent| curve(&|x| ModelCurve { ratio, exponent, rms: 0.0 }.at(x))).collect();
        let file = format!("family_{}.svg", (ratio * 100.0) as u32);
        write_whole(&folder.join(&file), drawing(&curves).as_bytes())?;
        let classes: Vec<String> = exponents.iter().zip(&curves).map(|(z, c)| format!("{z}: {}", class(c))).collect();
        writeln!(page, "| {ratio} | ![]({file}) | {} |", classes.join("<br>")).ok();
    }
    let unusual = [
        ("convex", curve(&|x| 1.0 - x * x)),
        ("inflections", curve(&|x| 1.0 - x - 0.11 * landform::core::math::sin(4.0 * std::f64::consts::PI * x))),
        ("reversed", curve(&|x| 1.0 - landform::core::math::smoothstep(0.0, 1.0, x))),
    ];
    page += "\n| unusual | curve | class |\n|---|---|---|\n";
    for (name, c) in unusual {
        let file = format!("unusual_{name}.svg");
        write_whole(&folder.join(&file), drawing(std::slice::from_ref(&c)).as_bytes())?;
        writeln!(page, "| {name} | ![]({file}) | {} |", class(&c)).ok();
    }
    Ok(page + "\n")
}

fn class(curve: &[f64]) -> String {
    let integral = curve.iter().sum::<f64>() / curve.len() as f64;
    let (class, reason) = classify(curve, integral);
    format!("{integral:.2}, {} ({reason})", class.name())
}

fn drawing(curves: &[Vec<f64>]) -> String {
    let mut svg = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"220\" height=\"220\" viewBox=\"-10 -10 220 220\"><rect x=\"-10\" y=\"-10\" width=\"220\" height=\"220\" fill=\"#fbfaf8\"/><path d=\"M0 0V200H200\" stroke=\"#8f949a\" fill=\"none\"/>",
    );
    for curve in curves {
        let points: Vec<String> =
            curve.iter().enumerate().map(|(k, y)| format!("{} {:.1}", 2 * k, 200.0 * (1.0 - y))).collect();
        write!(svg, "<path d=\"M{}\" stroke=\"#2f67a1\" stroke-width=\"2\" fill=\"none\"/>", points.join("L")).ok();
    }
    svg + "</svg>\n"
}

/// Section 2.1.6: 33 surfaces.
fn base_line() -> String {
    let n = 256;
    let shape = Shape::new(n, n);
    let Ok(grid) = Grid::new(shape, [1.0, 1.0]) else { return String::new() };
    let ranges = |shift: f64| {
        let mut range = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        for k in 0..33 {
            let hurst = 0.5 + 0.48 * f64::from(k) / 32.0;
            let z = spectral_surface(shape, [1.0, 1.0], hurst - shift, Seed(k as u64));
            if let Some((window, d)) = density(&grid, &z, false) {
                let fit = thesis_fit(&d, &z, window, shape);
                for (r, v) in range.iter_mut().zip([fit.rms, fit.r2]) {
                    *r = [r[0].min(v), r[1].max(v)];
                }
            }
        }
        range
    };
    let mut page = String::from(
        "## Section 2.1.6: the base line of 33 surfaces\n\nH from 0.5 to 0.98, 256 x 256, periodic.\n\n| exponent of the density | RMS | R² |\n|---|---|---|\n| thesis | 0.199 – 0.223 | 0.331 – 0.526 |\n",
    );
    for (name, shift) in [("2H + 2, fractional Brownian", 0.0), ("2H + 1, as the thesis writes", 0.5)] {
        let [rms, r2] = ranges(shift);
        writeln!(page, "| {name} | {:.3} – {:.3} | {:.3} – {:.3} |", rms[0], rms[1], r2[0], r2[1]).ok();
    }
    page + "\nThe thesis' range of R² is that of surfaces made with the exponent of a profile, so its reference terrains look rougher by half in H than stated. RMS depends on how T scales r, \
            which the thesis leaves open; R² does not. Both measure the noise of a periodogram and the steepness of its fall, not likeness to fractional Brownian ground.\n"
}
