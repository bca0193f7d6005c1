//! Pytel's caves, section 5.3: our recipes beside the thesis' measures.

use super::self_organised::{Figure, Page, nothing};

pub(super) const PYTEL_CAVES: Page = Page {
    folder: "docs/pytel",
    file: "caves.md",
    head: "# Pytel's thesis, section 5.3.1: caves, reproduced

Written by `cargo xtask reproduce pytel-caves`. Grids, iterations and rates are the thesis' (tables 5.1 and 5.2); it does not give the places of inlets and outlets, nor beds, fractures and obstacles in numbers, so caves are of the same kind,
not the same. Seconds are of whole recipes, pictures included, on one thread of the machine that wrote the page, one run; the thesis' are 24 min, 11 min and 17 min. Voxels are 1 m wide.

Density, coverage and porosity are over the optimised field, over the rectangle in brackets; a star marks what lies outside the range of confined caves (Klimchouk 2003 for the optimised field, Frumkin & Fischhendler 2005 for the rectangle). The
thesis' widths are of a sloped area: with the plan area, from its density and coverage, they are 1.47, 1.68 and 2.30 m. Here rock opens only beside what water from an inlet
has opened before, a rule that the thesis does not have. Our passages are .19 to .29 times as dense as the thesis' over the optimised field, .40 to .57 over the rectangle. The caves are chosen, not typical: inlets of two were moved and five seeds tried, of which all inlets broke through with one of three_inlets and two of trunk_cave.

| | Figure 5.9 | Figure 5.10 | Figure 5.11 |
|---|---|---|---|
| density, m/m² | 0.317 (0.122) | 0.462 (0.179) | 0.277 (0.105) |
| coverage, % | 46.51 (17.94) | 77.54 (30.05) | 63.66 (24.05) |
| porosity, % | 5.59 (2.16) | 8.74 (3.39) | 14.06 (5.31) |
| L:W | 193.5 | 191.1 | 79.25 |
| W, m | 2.28 | 1.95 | 3.33 |

",
    figures: &[
        Figure { title: "Figure 5.9: three inlets", recipe: "three_inlets", pictures: &["cave"], measures: &["cave"], what: "Balls of dense rock stand in the way." },
        Figure { title: "Figure 5.10: fractures across", recipe: "fractured_cave", pictures: &["cave"], measures: &["cave"], what: "Four inlets, two springs, planes between beds and upright fractures." },
        Figure { title: "Figure 5.11: a broad inlet", recipe: "trunk_cave", pictures: &["cave"], measures: &["cave"], what: "Tilted beds; two weaker inlets above." },
    ],
    tail: nothing,
};
