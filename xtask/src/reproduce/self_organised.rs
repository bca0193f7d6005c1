//! Pages of the docs from recipes: their own pictures and measures, beside the theses' numbers.
//! Here: dunes and coasts.

use std::fmt::Write;
use std::path::Path;
use std::time::Instant;

use landform::core::parallel::with_threads;
use landform::core::verb::MemoryOutput;
use landform::core::{Error, Result};
use landform::io::files::write_whole;
use landform::recipe::{GALLERY, Options, Override, Recipe};
use serde_json::Value as Json;

/// A page of the docs.
pub(super) struct Page {
    pub(super) folder: &'static str,
    pub(super) file: &'static str,
    pub(super) head: &'static str,
    pub(super) figures: &'static [Figure],
    /// What is measured beside the figures, as text.
    pub(super) tail: fn() -> Result<String>,
}

/// A recipe and those of its pictures (and measures of the same name) that are shown.
pub(super) struct Figure {
    pub(super) title: &'static str,
    pub(super) recipe: &'static str,
    pub(super) pictures: &'static [&'static str],
    /// Measures that belong to the pictures, where their names differ; several to a picture are
    /// joined by "+".
    pub(super) measures: &'static [&'static str],
    pub(super) what: &'static str,
}

/// No tail.
pub(super) fn nothing() -> Result<String> {
    Ok(String::new())
}

pub(super) const PYTEL_DUNES: Page = Page {
    folder: "docs/pytel",
    file: "dunes.md",
    head: "# Pytel's thesis, section 4.1: dunes, reproduced

Written by `cargo xtask reproduce pytel-dunes`. Sites are 15 m wide (the thesis gives no unit; its slab of 5 is then a third of a site, as in Werner's model). Seconds are of whole recipes, pictures included, on one thread of
the machine that wrote the page, one run; the thesis' are 40 to 67 s for one field of 256 x 128 on an Athlon 4400+.

Table 4.1 of the thesis, share of sites within a tenth of the angle of repose: shadowing 19.7 % (first start) and 3.4 % (second), protection 50.8 % and 10.2 %. Its starts are not given. Ours are random heaps; shadowing
leaves no dunes of them in 20 rounds, so it runs for longer, and thin sand under three winds is blown into sheets, so there it has one. Shelter by protection against geometric shadows: 36.5 % and 20.8 % of all sites there, 10.1 % and 1.7 % without peaks and troughs (here: where the slope changes by less than a tenth from cell to cell, level ground included). That protection makes steeper dunes in fewer rounds is as the thesis says.

",
    figures: &[
        Figure { title: "Figure 4.1: shadowing", recipe: "werner_dunes", pictures: &["deep", "thin"], measures: &["deep", "thin"], what: "Deep heaps under the thesis' three winds, 150 rounds; thin sand under one wind with Werner's hop of five sites, 300 rounds." },
        Figure { title: "Figure 4.3: protection", recipe: "protection_dunes", pictures: &["deep", "thin"], measures: &["deep", "thin"], what: "20 rounds, then finer slabs, then smoothing." },
        Figure { title: "Beyond the thesis: barchans", recipe: "barchans", pictures: &["barchans"], measures: &["dunes"], what: "Little sand, steady wind." },
        Figure { title: "Transverse dunes", recipe: "transverse_dunes", pictures: &["transverse"], measures: &["dunes"], what: "Much sand, steady wind." },
        Figure { title: "Linear dunes", recipe: "linear_dunes", pictures: &["linear"], measures: &["dunes"], what: "Two winds about a resultant." },
        Figure { title: "Star dunes", recipe: "star_dunes", pictures: &["star"], measures: &["dunes"], what: "Winds from three sides." },
    ],
    tail: nothing,
};

pub(super) const PYTEL_COASTS: Page = Page {
    folder: "docs/pytel",
    file: "coasts.md",
    head: "# Pytel's thesis, section 4.2 and appendix B.1: coasts, reproduced

Written by `cargo xtask reproduce pytel-coasts`. Sites are 15 m wide. Force, damping and exposure (a site is weaker in proportion to the neighbours that it lacks, 4.2.1) are the thesis'. Its radii are read as sites: so its forces leave an
island, a smaller radius erodes more, and its run times grow as discs do. It does not say what a local perimeter is measured against (here 2 R). *D* is the dimension of all shores by boxes. Seconds are of whole recipes, pictures
included, on one thread of the machine that wrote the page, one run; the thesis' are 195 to 308 s a coast (contiguous), 1,444 to 3,724 s (all), 78 s (figure 4.7).

",
    figures: &[
        Figure { title: "Figure 4.4 and table 4.3: the global perimeter", recipe: "coasts_global", pictures: &["global_a", "global_b", "global_c", "global_d"], measures: &["global_a", "global_b", "global_c", "global_d"], what: "g = 0.18, 0.15, 0.13, 0.11." },
        Figure { title: "The same, pruned", recipe: "coasts_global", pictures: &["pruned_a", "pruned_b", "pruned_c", "pruned_d"], measures: &[], what: "Islands with a coast under 24 sites are gone." },
        Figure { title: "Figure 4.5 and table 4.4: the local perimeter of the same shore", recipe: "coasts_local", pictures: &["contiguous_150", "contiguous_200", "contiguous_250"], measures: &["contiguous_150", "contiguous_200", "contiguous_250"], what: "R_p = 150, 200, 250 sites, g = 0.20." },
        Figure { title: "The local perimeter of all shores", recipe: "coasts_local", pictures: &["all_150", "all_200", "all_250"], measures: &["all_150", "all_200", "all_250"], what: "R_p = 150, 200, 250 sites, g = 0.15. Small islands stay near the shore." },
        Figure { title: "Figure 4.6 and table 4.5: more avalanching", recipe: "coasts_weakened", pictures: &["weakened_0", "weakened_05", "weakened_1", "weakened_175"], measures: &["weakened_0", "weakened_05", "weakened_1", "weakened_175"], what: "a = 0, 0.05, 0.10, 0.175 with R_a = 4 sites, k = 0.05, R_p = 10 sites. With the thesis' k = 1 a site falls within three rounds, and weakening has no time to matter; its R_a = 25 is too little in metres and far too much in sites. A little weakening breaks the coast up; more makes it a fifth shorter." },
        Figure { title: "Figure 4.7: mixed", recipe: "mixed_coast", pictures: &["mixed"], measures: &["mixed"], what: "Force and damping differ by side." },
        Figure { title: "Figure 4.8: the interior of an island", recipe: "island_interior", pictures: &["nearest", "hermite"], measures: &[], what: "Level sets by nearest and by Hermite's interpolation. Islets that resist long become needles." },
        Figure { title: "Figures B.4 and B.6, table B.1: sectors", recipe: "sector_coasts", pictures: &["from_square", "from_disc"], measures: &["from_square", "from_disc"], what: "512 x 512 sites, 4 x 4 sectors." },
        Figure { title: "Dunes on an island with an irregular coast", recipe: "dunes_and_coast", pictures: &["dunes"], measures: &[], what: "Two processes after one another." },
    ],
    tail: nothing,
};

pub(super) const KOH_DUNES: Page = Page {
    folder: "docs/koh",
    file: "README.md",
    head: "# Koh's thesis, section 5.2: dunes by an automaton, reproduced

Written by `cargo xtask reproduce koh-dunes`. The thesis has pictures and no numbers. What it leaves open was chosen so that 300 rounds from level sand leave its \"parallel striations\": wind loses its strength behind drops and
wins it back within 10 m, slabs are a tenth of a cell, sand slips at 33 degrees. Sand is held where its cell stands too steeply above one of the three to windward, as the thesis says; that is what ends the growth of dunes.
In the tests half a wave and height keep from 300 to 1,200 rounds, as the thesis finds them kept; ridges get shorter. Any wind is allowed: the three cells become places across it, so that crests do not follow the lattice.

",
    figures: &[
        Figure { title: "Figures 15 and 16: dunes from above, dunes from aside, and the wind over them", recipe: "koh_dunes", pictures: &["wind", "koh", "koh_low"], measures: &["dunes"], what: "300 rounds; the view is three times as high as wide." },
        Figure { title: "Figure 14a: sand and obstacles", recipe: "dunes_and_rocks", pictures: &["rocks"], measures: &[], what: "By Werner's rules: rocks are hard ground. Sand gathers in their lee, and thin streaks trail downwind. Figure 14b, wind around walls, is not reproduced." },
    ],
    tail: nothing,
};

pub(super) fn run(root: &Path, page: &Page) -> Result<()> {
    let folder = root.join(page.folder);
    std::fs::create_dir_all(&folder).map_err(|e| Error::io("create folder", &folder, e))?;
    let mut text = String::from(page.head);
    for figure in page.figures {
        let part = figure.write(root, &folder)?;
        println!("{part}");
        text += &part;
    }
    text += &(page.tail)()?;
    write_whole(&folder.join(page.file), text.as_bytes())
}

impl Figure {
    fn write(&self, root: &Path, folder: &Path) -> Result<String> {
        let recipe = GALLERY.iter().find(|r| r.name == self.recipe);
        let recipe = recipe.ok_or_else(|| Error::Empty { what: self.recipe.into() })?;
        let small = [Override::parse("write_picture.size=420")?];
        let parsed = Recipe::parse(recipe.text, self.recipe, &root.join("crates/landform/gallery"), &small)?;
        let mut out = MemoryOutput::default();
        let begun = Instant::now();
        with_threads(1, || parsed.run(&mut out, &Options::default()))??;
        let seconds = begun.elapsed().as_secs_f64();
        let mut page = format!("## {}\n\nRecipe `{}`, {seconds:.1} s. {}\n\n|", self.title, self.recipe, self.what);
        for name in self.pictures {
            write!(page, " {} |", name.replace('_', " ")).ok();
        }
        page += &format!("\n|{}\n|", "---|".repeat(self.pictures.len()));
        for name in self.pictures {
            let file = format!("{}_{name}.png", self.recipe);
            let bytes = out.0.get(&format!("{name}.png")).ok_or_else(|| Error::Empty { what: file.clone() })?;
            write_whole(&folder.join(&file), bytes)?;
            write!(page, " ![]({file}) |").ok();
        }
        if !self.measures.is_empty() {
            page += "\n|";
            for name in self.measures {
                let of = |name: &str| {
                    let json =
                        out.0.get(&format!("{name}.json")).map(|b| serde_json::from_slice(b).unwrap_or_default());
                    numbers(&json.unwrap_or(Json::Null))
                };
                let all: Vec<String> = name.split('+').filter(|n| !n.is_empty()).map(of).collect();
                write!(page, " {} |", all.join("<br>")).ok();
            }
        }
        Ok(page + "\n\n")
    }
}

fn numbers(m: &Json) -> String {
    let v = |key: &str| m[key].as_f64().unwrap_or(f64::NAN);
    let at = |path: &str| m.pointer(path).and_then(Json::as_f64).unwrap_or(f64::NAN);
    if let Some(text) = super::cave_numbers::numbers(m) {
        return text;
    }
    if m["integral"].is_number() {
        let class = m["class"].as_str().unwrap_or("–");
        return format!("hypsometric integral {:.2}, skew {:.2}: {class}", v("integral"), v("elevation_skew"));
    }
    if m["spectrum"].is_object() {
        let (long, short) = (at("/spectrum/long_waves/exponent"), at("/spectrum/short_waves/exponent"));
        return format!("spectrum falls by k^-{long:.2} at long waves, k^-{short:.2} at short ones");
    }
    if m["scaling"].is_object() {
        let (beta, h) = (at("/scaling/area_exponent"), at("/scaling/hack_exponent"));
        return format!("areas β {beta:.2}, Hack h {h:.2}, slope–area {:.2}", at("/slope_area/concavity"));
    }
    if m["bending_energy"].is_number() {
        return format!("bending energy {:.0}", v("bending_energy"));
    }
    if m["class"].is_string() {
        let error = |key: &str| m["shadow"][key].as_f64().map(|v| 100.0 * v);
        let shadow = match (error("all"), error("flanks")) {
            (Some(all), Some(flanks)) => format!("<br>shelter differs from shadow {all:.1} %, on flanks {flanks:.1} %"),
            _ => String::new(),
        };
        return format!(
            "{}<br>spacing {:.0} m, relief {:.1} m<br>bare {:.0} %, near repose {:.1} %<br>crests {:.0}° off the wind, RDP/DP {:.2}{shadow}",
            m["class"].as_str().unwrap_or("–"),
            v("spacing"),
            v("relief"),
            100.0 * v("bare_share"),
            100.0 * v("near_repose_share"),
            v("crest_to_wind"),
            v("steadiness")
        );
    }
    let coast = if m["coast"].is_object() { &m["coast"] } else { m };
    let v = |key: &str| coast[key].as_f64().unwrap_or(f64::NAN);
    format!(
        "land {:.0} %, {} islands<br>coast {:.1} km, D {:.2}",
        100.0 * v("land_share"),
        coast["islands"],
        v("length") / 1000.0,
        coast["boxes"]["dimension"].as_f64().unwrap_or(f64::NAN)
    )
}
