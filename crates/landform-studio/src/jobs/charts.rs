//! Charts of a preview's ground, computed aside so that they hold up nothing.

use std::sync::{Arc, Condvar, Mutex, PoisonError};

use landform::Result;
use landform::core::terrain::{AnyTerrain, Body, HeightField, NodeSurface, Surface, Visit, not_a_surface};
use landform::io::report::Analysis;
use serde_json::{Value as Json, json};

use super::whole;
use crate::hub::{Hub, Slot, lock};

/// Ground of more nodes is not measured in a preview.
const MOST_NODES: usize = 2_200_000;
/// Bars of the histogram.
const BARS: usize = 64;

/// Computes charts, the newest that is asked for.
pub(crate) struct Charts {
    desk: Mutex<(Option<Task>, bool)>,
    wake: Condvar,
    hub: Arc<Hub>,
}

struct Task {
    revision: u64,
    level: String,
    ground: Arc<AnyTerrain>,
    sea_level: Option<f64>,
}

impl Charts {
    pub(crate) fn new(hub: Arc<Hub>) -> Self {
        Self { desk: Mutex::default(), wake: Condvar::new(), hub }
    }

    pub(crate) fn ask(&self, revision: u64, level: String, ground: Arc<AnyTerrain>, sea_level: Option<f64>) {
        if ground.nodes() <= MOST_NODES {
            lock(&self.desk).0 = Some(Task { revision, level, ground, sea_level });
            self.wake.notify_one();
        }
    }

    pub(crate) fn close(&self) {
        lock(&self.desk).1 = true;
        self.wake.notify_one();
    }

    /// Computes until it is closed.
    pub(crate) fn work(&self) {
        loop {
            let task = {
                let mut desk = lock(&self.desk);
                loop {
                    if desk.1 {
                        return;
                    }
                    match desk.0.take() {
                        Some(task) => break task,
                        None => desk = self.wake.wait(desk).unwrap_or_else(PoisonError::into_inner),
                    }
                }
            };
            match whole(|| task.ground.visit(Measuring(task.sea_level))) {
                Ok(mut charts) => {
                    charts["tell"] = "charts".into();
                    charts["revision"] = task.revision.into();
                    charts["level"] = task.level.into();
                    self.hub.tell(Slot::Charts, &charts);
                }
                Err(error) => self.hub.log("note", &format!("charts: {error}")),
            }
        }
    }
}

struct Measuring(Option<f64>);

impl Visit for Measuring {
    type Out = Result<Json>;

    fn surface<T: Surface>(self, terrain: &T) -> Result<Json> {
        charts(&*terrain.rasterized()?, self.0)
    }

    fn body<T: Body>(self, _: &T) -> Self::Out {
        Err(not_a_surface(T::KIND, "a chart"))
    }
}

/// Numbers that could not be measured are null.
fn charts(raster: &HeightField, sea_level: Option<f64>) -> Result<Json> {
    // Where all is under the sea, all is measured.
    let analysis = Analysis::of(raster, sea_level).or_else(|_| Analysis::of(raster, None))?;
    let m = &analysis.metrics;
    let (edges, counts) = histogram(raster.elevation(), m.elevations.min, m.elevations.max);
    let curve = m.hypsometry.curve.iter().enumerate();
    let heights: Vec<_> = curve.map(|(k, h)| (k as f64 / 100.0, m.elevations.min + h * m.elevations.relief)).collect();
    let power = |exponent: f64| landform::core::math::pow(10.0, exponent);
    let bins: Vec<_> = m.network.slope_area.bins.iter().map(|bin| (power(bin.0), power(bin.1))).collect();
    let card: Vec<Json> = analysis
        .card
        .iter()
        .map(|line| {
            json!({ "name": line.name, "value": line.value, "low": line.natural[0], "high": line.natural[1], "unit": "",
            "verdict": line.inside.map_or("none", |inside| if inside { "inside" } else { "outside" }),
            "decides": line.decides, "meaning": line.meaning, "source": line.source })
        })
        .collect();
    Ok(json!({
        "summary": { "min": m.elevations.min, "max": m.elevations.max, "mean": m.elevations.mean,
            "median": m.elevations.median, "deviation": m.elevations.deviation, "relief": m.elevations.relief,
            "area": m.elevations.area, "nodes": m.elevations.nodes,
            "mean_slope": m.surface.as_ref().map(|surface| surface.slope_mean), "sea_level": m.sea_level,
            "drainage_density": m.network.drainage_density, "hypsometric_integral": m.hypsometry.integral,
            "concavity": m.network.slope_area.concavity },
        "verdict": { "title": analysis.verdict.title, "reason": analysis.verdict.reason },
        "histogram": { "edges": edges, "counts": counts },
        "hypsometry": heights, "slope_area": bins, "card": card,
    }))
}

fn histogram(z: &[f64], min: f64, max: f64) -> (Vec<f64>, Vec<u64>) {
    let width = (max - min) / BARS as f64;
    let edges = (0..=BARS).map(|k| min + k as f64 * width).collect();
    let mut counts = vec![0; BARS];
    for z in z.iter().filter(|&&z| z >= min && z <= max) {
        let bar = if width > 0.0 { ((z - min) / width) as usize } else { 0 };
        counts[bar.min(BARS - 1)] += 1;
    }
    (edges, counts)
}

#[cfg(test)]
mod tests {
    use super::*;
    use landform::core::grid::{Grid, Shape};

    #[test]
    fn a_ramp_has_even_bars_and_a_straight_curve() {
        let grid = Grid::new(Shape::new(40, 64), [10.0, 10.0]).unwrap();
        let ramp = HeightField::new(grid, (0..40 * 64).map(|i| (i % 64) as f64).collect()).unwrap();
        let charts = charts(&ramp, None).unwrap();
        assert!(charts["histogram"]["counts"].as_array().unwrap().iter().all(|c| c == 40), "{charts}");
        assert!((charts["hypsometry"][50][1].as_f64().unwrap() - 31.5).abs() < 1.0);
        assert_eq!(charts["summary"]["relief"], 63.0);
        assert!(charts["card"].as_array().unwrap().len() > 10);
    }
}
