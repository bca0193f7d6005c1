//! Measures of real ground against independent tools, and coasts against a divider walk; see
//! data/README.md.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]

use std::path::{Path, PathBuf};

use landform_core::algo::derivative::{gradient, gradient_of_four, hillshade, position_index};
use landform_core::algo::flow::{Flow, direction, node_areas};
use landform_core::algo::network::strahler;
use landform_core::analysis::{dimension_by_divider, metrics};
use landform_core::grid::RasterDomain;
use landform_core::math;
use landform_core::terrain::{HeightField, NodeSurface};
use landform_io::format::load_raster;
use landform_io::import::lines;
use serde_json::Value as Json;

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name)
}

struct Reference {
    field: HeightField,
    json: Json,
}

impl Reference {
    fn all() -> [Self; 2] {
        ["tujunga", "cevennes"].map(|name| Self {
            field: load_raster(&data(&format!("reference/{name}_crop.tif"))).unwrap(),
            json: serde_json::from_slice(&std::fs::read(data(&format!("reference/{name}.json"))).unwrap()).unwrap(),
        })
    }

    /// (node, value of the tool) at the forty cells.
    fn cells(&self, quantity: &str) -> Vec<(usize, f64)> {
        let values = self.json["quantities"][quantity]["values"].as_array().unwrap();
        let cells = self.json["cells"].as_array().unwrap();
        assert_eq!((cells.len(), values.len()), (40, 40));
        let at = |c: &Json, k: usize| c[k].as_u64().unwrap() as usize;
        cells
            .iter()
            .zip(values)
            .map(|(c, v)| (self.field.grid().shape.index(at(c, 0), at(c, 1)), v.as_f64().unwrap()))
            .collect()
    }

    fn statistic(&self, quantity: &str, name: &str) -> f64 {
        self.json["quantities"][quantity][name].as_f64().unwrap()
    }

    /// Nodes that are not on the border.
    fn inner(&self) -> Vec<usize> {
        let shape = self.field.grid().shape;
        let inside = |i: &usize| {
            let c = shape.cell(*i);
            c.row > 0 && c.col > 0 && c.row + 1 < shape.rows && c.col + 1 < shape.cols
        };
        (0..shape.len()).filter(inside).collect()
    }

    /// Values at the cells and the mean over inner nodes agree with the tool's to a relative 1e-4
    /// (of at least `unit`).
    fn check(&self, quantity: &str, unit: f64, value: impl Fn(usize) -> f64) {
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-4 * b.abs().max(unit);
        for (node, expected) in self.cells(quantity) {
            assert!(near(value(node), expected), "{quantity} at {node}: {} for {expected}", value(node));
        }
        let inner = self.inner();
        let values: Vec<f64> = inner.iter().map(|&i| value(i)).filter(|v| v.is_finite()).collect();
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let expected = self.statistic(quantity, "mean");
        assert!(near(mean, expected), "mean of {quantity}: {mean} for {expected}");
    }

    /// The surface without ties on which single paths can be compared.
    fn without_ties(&self) -> HeightField {
        let shape = self.field.grid().shape;
        let tie = |i: usize| {
            let c = shape.cell(i);
            ((c.row * 7919 + c.col * 104_729) % 1021) as f64 / 4096.0
        };
        let z = self.field.elevation().iter().enumerate().map(|(i, z)| z + tie(i)).collect();
        HeightField::new(self.field.grid().clone(), z).unwrap()
    }
}

#[test]
fn slopes_directions_and_shade_are_those_of_gdal() {
    for r in Reference::all() {
        let (grid, z) = (r.field.grid(), r.field.elevation());
        r.check("slope_horn_deg", 1.0, |i| math::atan(gradient(grid, z, i).slope()).to_degrees());
        r.check("slope_zt_deg", 1.0, |i| math::atan(gradient_of_four(grid, z, i).slope()).to_degrees());
        r.check("aspect_horn_deg", 10.0, |i| gradient(grid, z, i).aspect().to_degrees());
        let index = position_index(grid.shape, z, 1);
        r.check("tpi", 1.0, |i| index[i]);
        let shade = hillshade(grid, z, 315.0_f64.to_radians(), 45.0_f64.to_radians(), 1.0);
        // GDAL's bytes: 1 in shadow up to 255.
        r.check("hillshade_u8", 1.0, |i| (1.0 + 254.0 * shade[i] + 0.5).floor());
    }
}

#[test]
fn filled_ground_and_drainage_are_those_of_three_tools() {
    for r in Reference::all() {
        let route = |field: &HeightField| {
            let domain = RasterDomain::new(field.grid(), &[]);
            let (mut flow, mut area) = (Flow::new(), node_areas(&domain));
            flow.route(&domain, field.elevation(), &mut area);
            let cell = field.grid().cell_area();
            area.iter_mut().for_each(|a| *a /= cell);
            (flow, area)
        };
        let (flow, area) = route(&r.field);
        let level = flow.water_level(r.field.elevation());
        for (i, expected) in r.cells("fill") {
            assert_eq!(level[i], expected);
        }
        let mean = |v: &[f64]| v.iter().sum::<f64>() / v.len() as f64;
        let filled = mean(&level);
        // Single precision of the tool.
        assert!((filled / r.statistic("fill", "mean") - 1.0).abs() < 1e-6);
        let close = |a: f64, quantity: &str, name: &str, tolerance: f64| {
            let b = r.statistic(quantity, name);
            assert!((a / b - 1.0).abs() < tolerance, "{name} of {quantity}: {a} for {b}");
        };
        let part = |v: &[f64], q: f64| {
            let mut v = v.to_vec();
            v.sort_by(f64::total_cmp);
            v[(q * (v.len() - 1) as f64) as usize]
        };
        // Whole metres: ties are free, statistics are not. (The mean is: one great river counts the
        // length of its way through a lake.)
        close(part(&area, 1.0), "area_cells_fastscapelib", "max", 0.005);
        close(part(&area, 0.9), "area_cells_fastscapelib", "p90", 0.05);
        let tied = r.without_ties();
        let (flow, area) = route(&tied);
        let same = r.cells("tb_area_cells_fastscapelib").iter().filter(|(i, a)| area[*i] == *a).count();
        assert!(same >= 39, "{same} of 40 areas");
        close(part(&area, 1.0), "tb_area_cells_fastscapelib", "max", 1e-3);
        close(part(&area, 0.9), "tb_area_cells_fastscapelib", "p90", 0.05);
        let order = strahler(&flow, |i| area[i] >= 100.0);
        let same = r.cells("tb_strahler_fastscapelib").iter().filter(|(i, o)| f64::from(order[*i]) == *o).count();
        assert!(same >= 39, "{same} of 40 orders");
        let highest = order.iter().copied().max().unwrap();
        assert_eq!(f64::from(highest), r.statistic("tb_strahler_fastscapelib", "max"));
    }
}

#[test]
fn directions_and_areas_by_d_infinity_are_those_of_pysheds_and_whitebox() {
    for r in Reference::all() {
        let field = r.without_ties();
        let (grid, z) = (field.grid(), field.elevation());
        let domain = RasterDomain::new(grid, &[]);
        let turn = std::f64::consts::TAU;
        for (i, expected) in r.cells("tb_dinf_angle_pysheds") {
            let found = direction(&domain, grid, z, i).unwrap().angle.rem_euclid(turn);
            assert!((found - expected).abs() < 1e-4, "angle at {i}: {found} for {expected}");
        }
        // Hollows stop the flow, as in the tools: from the highest node down.
        let mut order: Vec<usize> = (0..z.len()).collect();
        order.sort_by(|&a, &b| z[b].total_cmp(&z[a]));
        let mut area = vec![1.0; z.len()];
        let inner = r.inner();
        let inside: std::collections::BTreeSet<usize> = inner.into_iter().collect();
        for i in order.into_iter().filter(|i| inside.contains(i)) {
            if let Some(d) = direction(&domain, grid, z, i) {
                use landform_core::grid::Domain;
                area[domain.neighbour(i, d.diagonal)] += area[i] * d.part;
                area[domain.neighbour(i, d.cardinal)] += area[i] * (1.0 - d.part);
            }
        }
        for (i, expected) in r.cells("tb_dinf_area_tarboton_own") {
            assert!((area[i] / expected - 1.0).abs() < 1e-4, "area at {i}: {} for {expected}", area[i]);
        }
        let same = r.cells("tb_dinf_area_whitebox").iter().filter(|(i, a)| (area[*i] / a - 1.0).abs() < 1e-4).count();
        assert!(same >= 25, "{same} of 40 areas");
    }
}

#[test]
fn measures_of_a_mountain_range_are_those_of_public_tools() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../landform/gallery/data/big_tujunga_ca_srtm1_utm11.tif");
    let (m, _) = metrics(&load_raster(&path).unwrap(), None).unwrap();
    let (surface, spectrum) = (m.surface.unwrap(), m.spectrum.unwrap());
    // Where definitions coincide: four digits as published.
    let exact = [
        ("integral", m.hypsometry.integral, 0.46042),
        ("curve skew", m.hypsometry.curve_skew, 0.372),
        ("skew", m.hypsometry.elevation_skew, -0.257),
        ("deviation", m.elevations.deviation, 369.067),
        ("slope", surface.slope_mean, 21.52),
        ("slope p90", surface.slope_p90, 33.06),
        ("slope max", surface.slope_max, 64.35),
        ("repose", surface.talus_share, 0.1574),
        ("beta", spectrum.surface.exponent, 4.376),
        ("axes", spectrum.axes_over_diagonals, 1.052),
        ("variogram", m.variogram.hurst, 0.8109),
        ("near", m.variogram.hurst_near, 0.9348),
        ("detrended", m.variogram.hurst_detrended, 0.809),
        ("sinks", m.form.sinks, 0.00624),
        ("upside down", m.form.sinks_upside_down, 0.198),
        ("peaks", m.form.peaks, 1.99),
        ("pits", m.form.pits, 1.37),
        ("laplacian", m.form.laplacian_skew, -0.0265),
    ];
    for (name, found, expected) in exact {
        assert!((found / expected - 1.0).abs() < 3e-3, "{name}: {found} for {expected}");
    }
    // Where tools differ among themselves: within twice their spread (p90).
    let free = [
        ("hack", m.network.scaling.hack_exponent, 0.493, 0.014),
        ("beta", m.network.scaling.area_exponent, 0.511, 0.016),
        ("theta", m.network.slope_area.concavity, 0.382, 0.02),
        ("chi", m.network.chi.unwrap().r2, 0.905, 0.044),
        ("density", m.network.drainage_density.unwrap(), 0.654, 0.01),
        ("model ratio", m.hypsometry.model.ratio, 0.0549, 0.001),
        ("model exponent", m.hypsometry.model.exponent, 0.276, 0.002),
    ];
    for (name, found, expected, spread) in free {
        assert!((found - expected).abs() <= 2.0 * spread, "{name}: {found} for {expected}");
    }
    assert_eq!(m.network.horton.order, 5);
}

#[test]
fn coasts_have_the_dimensions_of_the_divider_walk() {
    let expected = [
        ("great_britain_10m", "Great Britain (whole island)", 1.243),
        ("great_britain_10m", "Great Britain, west coast", 1.301),
        ("south_africa_10m", "South Africa", 1.049),
        ("norway_10m", "Norway, mainland", 1.450),
    ];
    for (file, name, dimension) in expected {
        let list = lines(&std::fs::read(data(&format!("coast/{file}.geojson"))).unwrap()).unwrap();
        let line = list.iter().find(|l| l.name == name).unwrap();
        let found = dimension_by_divider(&line.points, 4_000.0, 128_000.0).unwrap();
        assert_eq!(found.points.len(), 11);
        assert!((found.dimension - dimension).abs() < 0.03, "{name}: {} for {dimension}", found.dimension);
    }
}
