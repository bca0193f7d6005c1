//! The fields that describe where water goes.

use landform_core::algo::flow::{Flow, node_areas};
use landform_core::field::names;
use landform_core::grid::{Domain, MASKED};
use landform_core::parallel;
use landform_core::terrain::NodeSurface;

/// Routes flow over the terrain as it is and leaves drainage area, lake depth, receiver and basin as fields.
pub fn leave_drainage<T: NodeSurface>(terrain: &mut T, domain: &T::Domain, flow: &mut Flow) {
    let mut area = node_areas(domain);
    flow.route(domain, terrain.elevation(), &mut area);
    let status = domain.status();
    let z = terrain.elevation();
    let level = flow.water_level(z);
    let depth = parallel::map(z.len(), |i| level[i] - z[i]);
    parallel::update(&mut area, |i, a| {
        if status[i] == MASKED {
            *a = f64::NAN;
        }
    });
    let (receiver, basin) = (flow.receivers().to_vec(), flow.basins(status));
    let fields = terrain.fields_mut();
    fields.insert(&names::DRAINAGE_AREA, area);
    fields.insert(&names::LAKE_DEPTH, depth);
    fields.insert(&names::RECEIVER, receiver);
    fields.insert(&names::BASIN, basin);
}
