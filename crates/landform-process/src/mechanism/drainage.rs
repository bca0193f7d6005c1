//! The fields that describe drainage.

use landform_core::algo::flow::{Flow, node_areas};
use landform_core::algo::outlets::fill_inland_water;
use landform_core::field::names;
use landform_core::grid::{Domain, Status};
use landform_core::terrain::NodeSurface;
use landform_core::{Result, math, parallel};

/// Routes flow over the terrain as it is and adds drainage area, lake depth, receiver and basin as
/// fields. With a sea, water at its level that is not connected to it is a lake.
pub fn write_drainage_fields<T: NodeSurface>(
    terrain: &mut T,
    domain: &T::Domain,
    flow: &mut Flow,
    sea_level: Option<f64>,
) -> Result<()> {
    let mut area = node_areas(domain);
    flow.route(domain, terrain.elevation(), &mut area);
    let status = domain.status();
    let z = terrain.elevation();
    let mut level = flow.water_level(z);
    if let Some(sea_level) = sea_level {
        fill_inland_water(terrain, domain, sea_level, &mut level);
    }
    let depth = parallel::map(z.len(), |i| level[i] - z[i]);
    parallel::update(&mut area, |i, a| {
        if status[i] == Status::Masked {
            *a = f64::NAN;
        }
    });
    let (receiver, basin) = (flow.receivers().to_vec(), flow.basins(status));
    let fields = terrain.fields_mut();
    fields.insert(&names::DRAINAGE_AREA, area)?;
    fields.insert(&names::LAKE_DEPTH, depth)?;
    fields.insert(&names::RECEIVER, receiver)?;
    fields.insert(&names::BASIN, basin)
}

/// Area that χ refers to, m².
const CHI_AREA: f64 = 1e6;

/// Adds the slope along the flow and χ as fields; `flow` is as [`write_drainage_fields`] left it.
/// Sources: Perron & Royden (2013) for χ.
pub fn write_channel_steepness_fields<T: NodeSurface>(
    terrain: &mut T,
    domain: &T::Domain,
    flow: &Flow,
    concavity: f64,
) -> Result<()> {
    let z = terrain.elevation();
    let area = terrain.fields().get(&names::DRAINAGE_AREA, "chi")?;
    let (mut slope, mut chi) = (vec![0.0; z.len()], vec![0.0; z.len()]);
    for &i in flow.order().iter().rev() {
        let i = i as usize;
        let r = flow.receivers()[i] as usize;
        if r != i {
            let length = domain.distance(i, flow.slots()[i]);
            slope[i] = (z[i] - z[r]) / length;
            chi[i] = chi[r] + math::pow(CHI_AREA / area[i], concavity) * length;
        } else if domain.status()[i] == Status::Masked {
            (slope[i], chi[i]) = (f64::NAN, f64::NAN);
        }
    }
    let fields = terrain.fields_mut();
    fields.insert(&names::CHANNEL_SLOPE, slope)?;
    fields.insert(&names::CHI, chi)
}
